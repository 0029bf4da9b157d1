import { at, capital, contactStates, type ContactState, type Interface, type Cycle } from '../data/run';
import { tickText } from '../data/counted';
import { toCsv } from '../data/csv';
import { formatQuantity } from '../data/units';
import { svg } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Selection } from '../ui/selection';
import { isPrinting, type Look } from '../ui/theme';
import { axis, Chart, tooltip, tooltipBox, type Option, type RenderApi } from './chart';
import { PathAxis } from './path_axis';
import { stretchesOf, type Stretch } from './stretches';

/** Part of a row that a state takes, from its lower edge: its place tells it apart, not its colour alone. */
export const stateBand: Record<ContactState, [number, number]> = {
  open: [0, 0],
  stick: [0.08, 0.92],
  'slip forward': [0.5, 1],
  'slip backward': [0, 0.5],
};

/** Nothing sticks to the journal, which has no friction. */
const stateText: Record<ContactState, string> = {
  open: 'open',
  stick: 'stick, or closed without friction',
  'slip forward': 'slip forward, away from the weld',
  'slip backward': 'slip backward',
};

/** Contact states of the chosen direction: one map per interface, displacement against bump or foot. */
export class StatePanel {
  readonly root: HTMLElement;
  private readonly chart: Chart;
  private readonly panel: Panel;
  private path: PathAxis;
  private stretches: Stretch[][] = [];
  private cycle: Cycle;

  constructor(private readonly selection: Selection) {
    this.cycle = selection.cycle;
    this.path = new PathAxis([this.cycle]);
    this.chart = new Chart(
      () => `Contact states of every bump along the path, at each interface; ${this.subject}`,
      () => this.layout().height,
      (current, width) => this.option(current, width),
    );
    this.panel = new Panel(
      {
        title: 'Contact states along the path',
        subject: () => this.subject,
        legend: () => contactStates.map(stateSample),
        file: () => fileName('contact-states', selection.run.label, this.cycle.name),
        drawing: () => this.chart.drawing,
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    this.root = this.panel.root;
    selection.onChange(() => this.follow());
    this.read();
    this.setCursors();
  }

  private get subject(): string {
    return `${this.selection.run.label} · ${this.cycle.name}`;
  }

  private get interfaces(): Interface[] {
    return this.selection.run.interfaces;
  }

  private read(): void {
    this.cycle = this.selection.cycle;
    this.path = new PathAxis([this.cycle]);
    this.stretches = this.interfaces.map(({ name }) => stretchesOf(this.cycle, name));
  }

  private follow(): void {
    if (this.cycle !== this.selection.cycle) {
      this.read();
      this.panel.refresh();
      this.chart.fit();
    }
    this.setCursors();
  }

  private setCursors(): void {
    if (this.cycle.size === 0) return;
    const x = this.path.position(this.cycle, this.selection.index);
    this.chart.setCursors(this.interfaces.map((_, grid) => ({ name: 'line', grid, x })));
  }

  private nodes(interfaceIndex: number): number {
    return Math.max(1, this.cycle.states(at(this.interfaces, interfaceIndex).name).width);
  }

  /** Places of the three maps, one above the other. */
  private layout(): { tops: number[]; heights: number[]; height: number } {
    const tops: number[] = [];
    const heights: number[] = [];
    let top = 28;
    this.interfaces.forEach((_, i) => {
      const height = Math.min(isPrinting() ? 200 : 420, Math.max(60, 9 * this.nodes(i)));
      tops.push(top);
      heights.push(height);
      top += height + 54;
    });
    return { tops, heights, height: top + 14 };
  }

  private option(current: Look, width: number): Option {
    const { interfaces } = this;
    const { tops, heights } = this.layout();
    // What is drawn keeps its own: a change of size may draw it again after the direction has changed.
    const { stretches } = this;
    const last = interfaces.length - 1;
    return {
      title: interfaces.map(({ title }, i) => ({
        text: title,
        left: 54,
        top: at(tops, i) - 22,
        padding: 0,
        textStyle: { color: current.text, fontSize: 12, fontWeight: 'bold' },
      })),
      grid: tops.map((top, i) => ({ left: 54, right: 16, top, height: at(heights, i) })),
      xAxis: interfaces.map((_, gridIndex) => ({
        ...this.path.option(current, width, gridIndex === last ? {} : { name: '' }),
        gridIndex,
      })),
      yAxis: interfaces.map(({ node }, gridIndex) => ({
        ...axis(current, this.selection.run.pads > 1 ? `Pad.${node}` : capital(node), {
          min: 0.5,
          max: this.nodes(gridIndex) + 0.5,
          interval: 1e9,
          splitLine: { show: false },
          nameGap: 32,
          axisLabel: { color: current.muted, fontSize: 11, customValues: nodeTicks(this.nodes(gridIndex), (index) => this.selection.run.counted(node, index).number), formatter: (value: number) => tickText(this.selection.run.counted(node, value - 1)) },
          axisTick: { show: false },
        }),
        gridIndex,
      })),
      tooltip: tooltip(current, {
        trigger: 'item',
        formatter: (item: { seriesIndex: number; dataIndex: number }) => this.tip(item.seriesIndex, item.dataIndex),
      }),
      series: interfaces.map(({ title }, i) => ({
        type: 'custom',
        name: title,
        xAxisIndex: i,
        yAxisIndex: i,
        clip: true,
        encode: { x: [0, 1], y: 2 },
        data: at(stretches, i).map((stretch) => [...this.extent(stretch), stretch.node + 1]),
        renderItem: (item: { dataIndex: number }, api: RenderApi) =>
          renderStretch(at(at(stretches, i), item.dataIndex), current, api),
      })),
    };
  }

  /** From half-way since the increment before to half-way to the next. */
  private extent({ first, last }: Stretch): [number, number] {
    const position = (index: number): number => this.path.position(this.cycle, index);
    const end = this.cycle.size - 1;
    return [
      first === 0 ? position(0) : 0.5 * (position(first - 1) + position(first)),
      last === end ? position(end) : 0.5 * (position(last) + position(last + 1)),
    ];
  }

  private tip(interfaceIndex: number, dataIndex: number): HTMLElement {
    const { node, title } = at(this.interfaces, interfaceIndex);
    const stretch = at(at(this.stretches, interfaceIndex), dataIndex);
    const where = (index: number): string =>
      `${formatQuantity(this.cycle.value('displacement', index), 'm')}, ${this.cycle.isLoading(index) ? 'loading' : 'unloading'}`;
    return tooltipBox(`${capital(node)} ${this.selection.run.numberOf(node, stretch.node)}: ${stretch.state}`, [
      ['Interface', title],
      ['From', where(stretch.first)],
      ['To', where(stretch.last)],
    ]);
  }

  private csv(): string {
    const { cycle } = this;
    return toCsv(
      ['run', this.selection.run.kind.cycles.column, 'increment', 'displacement_m', 'interface', 'node', 'state'],
      this.interfaces.flatMap(({ name }) => {
        const states = cycle.states(name);
        return cycle.increments.flatMap((increment, index) =>
          Array.from({ length: states.width }, (_, node) => [
            this.selection.run.label,
            cycle.key,
            increment,
            cycle.value('displacement', index),
            name,
            node + 1,
            contactStates[states.at(index, node)],
          ]),
        );
      }),
    );
  }
}

function renderStretch({ state }: Stretch, current: Look, api: RenderApi): object {
  const row = api.value(2);
  const [lower, upper] = stateBand[state];
  const [left, top] = api.coord([api.value(0), row - 0.5 + upper]);
  const [right, bottom] = api.coord([api.value(1), row - 0.5 + lower]);
  return {
    type: 'rect',
    shape: { x: left, y: top, width: Math.max(0.5, right - left), height: bottom - top },
    style: { fill: current.states[state] },
  };
}

/** Rows that are named: of each pad its first, and some of the others. */
function nodeTicks(nodes: number, numberOf: (index: number) => number): number[] {
  const step = nodes <= 12 ? 1 : nodes <= 60 ? 5 : 10 ** Math.ceil(Math.log10(nodes / 20));
  return Array.from({ length: nodes }, (_, index) => index + 1).filter((row) => numberOf(row - 1) === 1 || numberOf(row - 1) % step === 0);
}

/** A piece of a map as the legend shows it. */
function stateSample(state: ContactState): LegendEntry {
  const [lower, upper] = stateBand[state];
  return {
    width: 26,
    draw: (current) => [
      svg('rect', { x: 1, y: 1 + 10 * (1 - upper), width: 24, height: 10 * (upper - lower), fill: current.states[state] }),
      svg('rect', { x: 0.5, y: 0.5, width: 25, height: 11, fill: 'none', stroke: current.line }),
    ],
    text: stateText[state],
  };
}
