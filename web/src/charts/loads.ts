import { at, largest, type Loop, type Interface } from '../data/run';
import { toCsv } from '../data/csv';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import { choice, el, svg } from '../ui/dom';
import { legend, panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Selection } from '../ui/selection';
import { type Look } from '../ui/theme';
import { axis, Chart, roundAbove, tooltip, tooltipBox, type Option } from './chart';
import type { Curve } from './loops';

function loadsAt(loop: Loop, kind: Interface, index: number): number[] {
  const field = loop.field(`normal_force_${kind.name}`);
  return Array.from({ length: field.width }, (_, node) => field.at(index, node));
}

/** Normal forces of one direction as bars, one group of bars per run; ticks show the increment chosen. */
class LoadPanel {
  readonly root: HTMLElement;
  private readonly chart: Chart;
  private shownNow = false;

  constructor(
    private readonly curves: Curve[],
    private kind: Interface,
    private scale: Scale,
    private readonly most: () => number,
    private readonly selection: Selection,
  ) {
    const { loop } = at(curves, 0);
    const heaviest = this.heaviest();
    this.chart = new Chart(
      `Bump loads at full displacement, ${loop.name}: ${heaviest}`,
      () => 220,
      (current, width) => this.option(current, width),
    );
    this.root = panel(
      {
        title: loop.name,
        file: () => fileName('loads', this.kind.name, loop.name),
        svg: () => this.chart.toSvg(),
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    selection.onChange(() => this.follow());
  }

  show(kind: Interface, scale: Scale): void {
    this.kind = kind;
    this.scale = scale;
    this.chart.fit();
  }

  private heaviest(): string {
    const { loop } = at(this.curves, 0);
    const loads = loadsAt(loop, this.kind, loop.turning);
    const most = largest(loads);
    return most > 0 ? `${formatQuantity(most, 'N')} on bump ${loads.indexOf(most) + 1}` : 'none';
  }

  private option(current: Look, width: number): Option {
    const nodes = Math.max(...this.curves.map((curve) => curve.loop.field(`normal_force_${this.kind.name}`).width));
    const node = this.kind.node === 'foot' ? 'Foot' : 'Bump';
    return {
      grid: { left: 54, right: 12, top: 12, bottom: 44 },
      xAxis: axis(current, `${node}, counted from the weld`, {
        type: 'category',
        data: Array.from({ length: nodes }, (_, i) => String(i + 1)),
        axisLabel: { color: current.muted, fontSize: 12 },
        nameGap: 26,
        splitLine: { show: false },
        axisTick: { show: false },
      }),
      yAxis: axis(current, axisTitle('Load', this.scale), { nameGap: 38, max: roundAbove(this.most() * this.scale.factor) }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        axisPointer: { type: 'shadow', shadowStyle: { color: current.grid, opacity: 0.5 } },
        formatter: (items: { dataIndex: number }[]) => this.tip(node, items[0]?.dataIndex ?? 0),
      }),
      series: [
        ...this.curves.map((curve) => ({
          type: 'bar',
          name: curve.label,
          itemStyle: { color: at(current.series, curve.style % current.series.length) },
          barCategoryGap: width > 500 ? '25%' : '12%',
          barGap: '0%',
          data: this.scaled(curve.loop, curve.loop.turning),
        })),
        {
          type: 'line',
          name: 'now',
          lineStyle: { opacity: 0 },
          symbol: 'rect',
          symbolSize: [Math.max(4, (0.7 * (width - 66)) / Math.max(1, nodes)), 2.5],
          itemStyle: { color: current.text, opacity: 1 },
          showAllSymbol: true,
          silent: true,
          z: 5,
          data: this.now(),
        },
      ],
    };
  }

  private scaled(loop: Loop, index: number): number[] {
    return loadsAt(loop, this.kind, index).map((load) => load * this.scale.factor);
  }

  private now(): (number | string)[] {
    const { loop, index } = this.selection;
    this.shownNow = this.curves.some((curve) => curve.loop === loop);
    if (!this.shownNow) return [];
    return this.scaled(loop, index).map((load) => (load > 0 ? load : '-'));
  }

  private follow(): void {
    const before = this.shownNow;
    const data = this.now();
    if (before || this.shownNow) this.chart.update({ series: [...this.curves.map(() => ({})), { data }] });
  }

  private tip(node: string, index: number): HTMLElement {
    const rows = this.curves.map(({ label, loop }): [string, string] => [
      `${label}, full displacement`,
      formatQuantity(loadsAt(loop, this.kind, loop.turning)[index], 'N'),
    ]);
    if (this.shownNow) {
      const { loop, index: increment } = this.selection;
      const load = loadsAt(loop, this.kind, increment)[index];
      rows.push([`increment ${at(loop.increments, increment)}`, formatQuantity(load, 'N')]);
    }
    return tooltipBox(`${node} ${index + 1}`, rows);
  }

  private csv(): string {
    const unit = this.kind.node;
    return toCsv(
      ['run', at(this.curves, 0).run.kind.loops.column, unit, 'normal_force_N'],
      this.curves.flatMap(({ run, loop }) =>
        loadsAt(loop, this.kind, loop.turning).map((load, i) => [run.label, loop.key, i + 1, load]),
      ),
    );
  }
}

/** One chart per direction, all with the same scales; the interface can be chosen. */
export function loadSection(groups: Curve[][], selection: Selection): HTMLElement {
  const begun = groups.map((curves) => curves.filter((curve) => curve.loop.size > 0)).filter((c) => c.length > 0);
  const { interfaces } = at(selection.runs, 0);
  let kind = interfaces.find(({ name }) => name === 'top_bump') ?? at(interfaces, 0);
  const most = (): number =>
    largest(...begun.flat().map(({ loop }) => loadsAt(loop, kind, loop.turning)));
  const scale = (): Scale => scaleFor(most(), 'N');
  const panels = begun.map((curves) => new LoadPanel(curves, kind, scale(), most, selection));
  const chooser = choice(
    'Loads shown',
    interfaces.map((value) => ({ value, text: value.title })),
    kind,
    (chosen) => {
      kind = chosen;
      for (const one of panels) one.show(kind, scale());
    },
  );
  const bar = svg('svg', { width: 12, height: 12, 'aria-hidden': 'true' }, svg('rect', { x: 2, y: 1, width: 8, height: 11, class: 'swatch' }));
  const tick = svg('svg', { width: 14, height: 12, 'aria-hidden': 'true' }, svg('rect', { x: 0, y: 5, width: 14, height: 2.5, fill: 'currentColor' }));
  return el(
    'div',
    {},
    el(
      'div',
      { class: 'tools' },
      chooser,
      legend([
        { sample: bar, text: 'at full displacement' },
        { sample: tick, text: 'at the increment chosen' },
      ]),
    ),
    el('div', { class: 'multiples' }, ...panels.map((one) => one.root)),
  );
}
