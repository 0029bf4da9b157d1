import { at, capital, largest, type Cycle, type Interface, type Run } from '../data/run';
import { axisText, tickText } from '../data/counted';
import { toCsv } from '../data/csv';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import { afterwards } from '../ui/afterwards';
import type { Comparison } from '../ui/comparison';
import { choice, el, svg } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { type Look } from '../ui/theme';
import { axis, Chart, roundAbove, tooltip, tooltipBox, type Option, type RenderApi } from './chart';
import { curvesOf, runLegend, type Curve } from './curves';

function loadsAt(cycle: Cycle, kind: Interface, index: number): number[] {
  const field = cycle.field(`normal_force_${kind.name}`);
  return Array.from({ length: field.width }, (_, node) => field.at(index, node));
}

/** Part of the room of a bump that its bars take. */
const barsOfBand = 0.78;

/** Normal forces of one direction: a bar per run in focus at full displacement, and on it a mark at the increment chosen. */
class LoadPanel {
  readonly root: HTMLElement;
  private readonly chart: Chart;
  private readonly panel: Panel;

  constructor(
    private readonly key: number,
    private readonly name: string,
    private kind: Interface,
    private readonly comparison: Comparison,
  ) {
    this.chart = new Chart(
      () => this.description(),
      () => 220,
      (current, width) => this.option(current, width),
    );
    this.panel = new Panel(
      {
        title: `Bump loads, ${name}`,
        subject: () => [this.kind.title, ...comparison.focusFoils.map(({ label }) => label)].join(' · '),
        file: () => fileName('loads', this.kind.name, ...comparison.focusFoils.map(({ label }) => label), name),
        drawing: () => this.chart.drawing,
        legend: () => [...samples, ...runLegend(comparison, comparison.focusFoils)],
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    this.root = this.panel.root;
    const refresh = (): void => this.refresh();
    const follow = (): void => this.chart.update({ series: this.curves.map((curve, i) => ({ id: `now${i}`, data: this.now(curve) })) });
    comparison.onChange(() => afterwards(refresh));
    comparison.selection.onChange(() => afterwards(follow));
  }

  show(kind: Interface): void {
    this.kind = kind;
    this.refresh();
  }

  private refresh(): void {
    this.panel.refresh();
    this.chart.fit();
  }

  private get curves(): Curve[] {
    return curvesOf(this.comparison, this.key, this.comparison.focusFoils);
  }

  private get most(): number {
    const compared = this.comparison.ownAxes
      ? this.curves.map(({ cycle }) => cycle)
      : this.comparison.focusFoils.flatMap((run) => run.cycles.filter((cycle) => cycle.size > 0));
    return largest(...compared.map((cycle) => loadsAt(cycle, this.kind, cycle.turning)));
  }

  private get scale(): Scale {
    return scaleFor(this.most, 'N');
  }

  private description(): string {
    const peaks = this.curves.map(({ run, cycle, label }) => {
      const loads = loadsAt(cycle, this.kind, cycle.turning);
      const most = largest(loads);
      return `${label} ${most > 0 ? `${formatQuantity(most, 'N')} on ${this.node} ${run.numberOf(this.node, loads.indexOf(most))}` : 'none'}`;
    });
    return `${this.kind.title}, loads at full displacement, ${this.name}: at most ${peaks.join(', ')}`;
  }

  private get node(): Interface['node'] {
    return this.kind.node;
  }

  /** Of the runs in focus the one that has most bumps or feet, and how many. */
  private get widest(): { nodes: number; run: Run } {
    const each = this.curves.map(({ run, cycle }) => ({ nodes: cycle.field(`normal_force_${this.kind.name}`).width, run }));
    return each.reduce((best, one) => (one.nodes > best.nodes ? one : best), { nodes: 1, run: at(this.comparison.runs, 0) });
  }

  private option(current: Look, width: number): Option {
    const { curves, scale } = this;
    const { nodes, run } = this.widest;
    return {
      grid: { left: 54, right: 12, top: 12, bottom: 44 },
      xAxis: axis(current, axisText(this.node, run.pads > 1), {
        type: 'category',
        data: Array.from({ length: nodes }, (_, i) => tickText(run.counted(this.node, i))),
        axisLabel: { color: current.muted, fontSize: 12 },
        nameGap: 26,
        splitLine: { show: false },
        axisTick: { show: false },
      }),
      yAxis: axis(current, axisTitle('Load', scale), { nameGap: 38, max: roundAbove(this.most * scale.factor) }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        axisPointer: { type: 'shadow', shadowStyle: { color: current.grid, opacity: 0.5 } },
        formatter: (items: { dataIndex: number }[]) => this.tip(items[0]?.dataIndex ?? 0),
      }),
      series: [
        ...curves.map((curve, i) => ({
          type: 'custom',
          name: curve.label,
          clip: true,
          data: this.scaled(curve.cycle, curve.cycle.turning),
          renderItem: (_: unknown, api: RenderApi) => bar(api, i, curves.length, curve.colour(current)),
        })),
        ...curves.map((curve, i) => ({
          type: 'custom',
          id: `now${i}`,
          name: `${curve.label}, now`,
          clip: true,
          silent: true,
          z: 5,
          data: this.now(curve),
          renderItem: (_: unknown, api: RenderApi) => mark(api, i, curves.length, width > 500 ? 2.5 : 2, current.text),
        })),
      ],
    };
  }

  private scaled(cycle: Cycle, index: number): [number, number][] {
    const { factor } = this.scale;
    return loadsAt(cycle, this.kind, index).map((load, node) => [node, load * factor]);
  }

  /** Loads at the part of the way that the reader looks at. */
  private now({ cycle }: Curve): [number, number][] {
    return this.scaled(cycle, this.comparison.selection.indexIn(cycle)).filter(([, load]) => load > 0);
  }

  private tip(index: number): HTMLElement {
    const rows = this.curves.flatMap(({ label, cycle }): [string, string][] => {
      const now = this.comparison.selection.indexIn(cycle);
      return [
        [`${label}, full displacement`, formatQuantity(loadsAt(cycle, this.kind, cycle.turning)[index], 'N')],
        [`${label}, increment ${at(cycle.increments, now)}`, formatQuantity(loadsAt(cycle, this.kind, now)[index], 'N')],
      ];
    });
    return tooltipBox(`${capital(this.node)} ${this.widest.run.numberOf(this.node, index)}`, rows);
  }

  private csv(): string {
    const { column } = at(this.comparison.runs, 0).kind.cycles;
    return toCsv(
      ['run', column, 'interface', this.node, 'normal_force_N', 'increment', 'normal_force_there_N'],
      this.curves.flatMap(({ run, cycle }) => {
        const now = this.comparison.selection.indexIn(cycle);
        const there = loadsAt(cycle, this.kind, now);
        return loadsAt(cycle, this.kind, cycle.turning).map((load, i) => [run.label, cycle.key, this.kind.name, i + 1, load, at(cycle.increments, now), there[i]]);
      }),
    );
  }
}

/** Left edge and width of a bar. */
function place(api: RenderApi, bar: number, bars: number): { left: number; width: number } {
  const band = barsOfBand * at(api.size([1, 0]), 0);
  return { left: api.coord([api.value(0), 0])[0] - 0.5 * band + (bar * band) / bars, width: band / bars };
}

function bar(api: RenderApi, i: number, bars: number, fill: string): object {
  const { left, width } = place(api, i, bars);
  const [, top] = api.coord([api.value(0), api.value(1)]);
  const [, foot] = api.coord([api.value(0), 0]);
  return { type: 'rect', shape: { x: left, y: top, width: Math.max(0.6, width - 0.4), height: foot - top }, style: { fill } };
}

function mark(api: RenderApi, i: number, bars: number, thickness: number, fill: string): object {
  const { left, width } = place(api, i, bars);
  const [, y] = api.coord([api.value(0), api.value(1)]);
  return { type: 'rect', shape: { x: left - 0.5, y: y - 0.5 * thickness, width: width + 0.6, height: thickness }, style: { fill } };
}

const samples: LegendEntry[] = [
  { width: 12, draw: (current) => [svg('rect', { x: 2, y: 1, width: 8, height: 11, fill: current.muted })], text: 'bar: at full displacement' },
  { width: 14, draw: (current) => [svg('rect', { x: 0, y: 5, width: 14, height: 2.5, fill: current.text })], text: 'mark: at the increment chosen' },
];

/** One chart per direction; the interface can be chosen. */
export function loadSection(keys: { key: number; name: string }[], comparison: Comparison): HTMLElement {
  const { interfaces } = at(comparison.runs, 0);
  const kind = interfaces.find(({ name }) => name === 'top_bump') ?? at(interfaces, 0);
  const panels = keys.map(({ key, name }) => new LoadPanel(key, name, kind, comparison));
  const chooser = choice(
    'Loads shown',
    interfaces.map((value) => ({ value, text: value.title })),
    kind,
    (chosen) => panels.forEach((one) => one.show(chosen)),
  );
  return el('div', {}, el('div', { class: 'tools' }, chooser), el('div', { class: 'multiples' }, ...panels.map((one) => one.root)));
}
