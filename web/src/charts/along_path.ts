import { at, largest, type Cycle } from '../data/run';
import { toCsv } from '../data/csv';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import type { Comparison } from '../ui/comparison';
import { el, svg } from '../ui/dom';
import { type LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, Chart, roundAbove, tooltip, tooltipBox, type Option } from './chart';
import { curvesOf, type Curve } from './curves';
import { PathAxis } from './path_axis';

/** What is drawn along the path, beside others of its unit. */
export interface PathQuantity {
  /** Of the variable in result.nc. */
  name: string;
  text: string;
  /** Number of its colour. */
  style: number;
  marker: 'circle' | 'rect' | 'triangle' | 'diamond';
  /** What is drawn, and what the table has. */
  value: (cycle: Cycle, index: number) => number;
  stored: (cycle: Cycle, index: number) => number;
}

export interface PathSection {
  title: string;
  axis: string;
  unit: string;
  quantities: PathQuantity[];
  /** Of files. */
  file: string;
}

const markerShapes: Record<PathQuantity['marker'], string> = {
  circle: 'M11.5 6a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0Z',
  rect: 'M11.8 2.8H18.2V9.2H11.8Z',
  triangle: 'M15 2L19 9.5H11Z',
  diamond: 'M15 1.5L19 6L15 10.5L11 6Z',
};

function lineSample(text: string, dash: Curve['dash'], colour: (current: Look) => string, marker = ''): LegendEntry {
  return {
    width: 30,
    draw: (current) => [
      svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: colour(current), 'stroke-width': 2, 'stroke-dasharray': dash === 'solid' ? 'none' : dash.join(' ') }),
      svg('path', { d: marker, fill: colour(current) }),
    ],
    text,
  };
}

/** Increments from one marker to the next. */
function spacing(cycle: Cycle): number {
  return Math.max(1, Math.round(cycle.size / 9));
}

/** Some quantities of one direction along the path: colours tell the quantities apart, dashes the runs in focus. */
class PathPanel {
  readonly root: HTMLElement;
  private readonly chart: Chart;

  constructor(
    private readonly section: PathSection,
    private readonly key: number,
    name: string,
    private readonly comparison: Comparison,
  ) {
    this.chart = new Chart(
      () => this.description(name),
      () => 240,
      (current, width) => this.option(current, width),
    );
    const panel = new Panel(
      {
        title: `${section.title}, ${name}`,
        subject: () => comparison.focusFoils.map(({ label }) => label).join(', '),
        file: () => fileName(section.file, ...comparison.focusFoils.map(({ label }) => label), name),
        drawing: () => this.chart.drawing,
        legend: () => this.legend(),
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    this.root = panel.root;
    comparison.onChange(() => {
      panel.refresh();
      this.chart.fit();
      this.follow();
    });
    comparison.selection.onChange(() => this.follow());
    this.follow();
  }

  private get curves(): Curve[] {
    return curvesOf(this.comparison, this.key, this.comparison.focusFoils);
  }

  /** Loops that the axes have room for. */
  private get compared(): Cycle[] {
    if (this.comparison.ownAxes) return this.curves.map(({ cycle }) => cycle);
    return this.comparison.focusFoils.flatMap((run) => run.cycles.filter((cycle) => cycle.size > 0));
  }

  private get most(): number {
    return largest(...this.compared.flatMap((cycle) => this.section.quantities.map((quantity) => valuesOf(quantity, cycle))));
  }

  private description(name: string): string {
    const { quantities, title, unit } = this.section;
    const peaks = this.curves.flatMap(({ cycle, label }) =>
      quantities.map((quantity) => `${label}, ${quantity.text}, at most ${formatQuantity(largest(valuesOf(quantity, cycle)), unit)}`),
    );
    return `${title}, ${name}: ${peaks.join('; ')}`;
  }

  private legend(): LegendEntry[] {
    return [
      ...this.section.quantities.map(({ text, style, marker }) =>
        lineSample(text, 'solid', (current) => at(current.series, style), markerShapes[marker]),
      ),
      ...(this.curves.length > 1 ? this.curves.map(({ label, dash }) => lineSample(label, dash, (current) => current.text)) : []),
    ];
  }

  private option(current: Look, width: number): Option {
    const { curves, section } = this;
    const path = new PathAxis(this.compared);
    const scale = scaleFor(this.most, section.unit);
    return {
      grid: { left: 56, right: 16, top: 14, bottom: 46 },
      xAxis: path.option(current, width),
      yAxis: axis(current, axisTitle(section.axis, scale), { nameGap: 40, max: roundAbove(this.most * scale.factor) }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        formatter: (items: { seriesIndex: number; dataIndex: number }[]) => this.tip(curves, items),
      }),
      series: curves.flatMap((curve) => section.quantities.map((quantity) => this.series(curve, quantity, path, scale, current))),
    };
  }

  private series(curve: Curve, quantity: PathQuantity, path: PathAxis, scale: Scale, current: Look): object {
    const every = spacing(curve.cycle);
    const color = at(current.series, quantity.style);
    return {
      type: 'line',
      name: quantity.text,
      showAllSymbol: true,
      symbol: (_: unknown, item: { dataIndex: number }) => (item.dataIndex % every === every >> 1 ? quantity.marker : 'none'),
      symbolSize: 7,
      lineStyle: { color, width: 1.8, type: curve.dash },
      itemStyle: { color },
      data: valuesOf(quantity, curve.cycle).map((value, index) => [path.position(curve.cycle, index), value * scale.factor]),
    };
  }

  private tip(curves: Curve[], items: { seriesIndex: number; dataIndex: number }[]): HTMLElement | string {
    const { quantities, unit } = this.section;
    const first = items[0];
    if (!first) return '';
    const rows = items.map(({ seriesIndex, dataIndex }): [string, string] => {
      const curve = at(curves, Math.floor(seriesIndex / quantities.length));
      const quantity = at(quantities, seriesIndex % quantities.length);
      const name = curves.length > 1 ? `${curve.label}: ${quantity.text}` : quantity.text;
      return [name, formatQuantity(quantity.value(curve.cycle, dataIndex), unit)];
    });
    const { cycle } = at(curves, Math.floor(first.seriesIndex / quantities.length));
    const branch = cycle.isLoading(first.dataIndex) ? 'loading' : 'unloading';
    return tooltipBox(`${cycle.name}, ${branch}, ${formatQuantity(cycle.value('displacement', first.dataIndex), 'm')}`, rows);
  }

  private follow(): void {
    const shown = this.curves.find((curve) => curve.cycle === this.comparison.selection.cycle);
    const path = new PathAxis(this.compared);
    this.chart.setCursors(shown ? [{ name: 'line', grid: 0, x: path.position(shown.cycle, this.comparison.selection.index) }] : []);
  }

  private csv(): string {
    const { quantities, unit } = this.section;
    const { column } = at(this.comparison.runs, 0).kind.cycles;
    return toCsv(
      ['run', column, 'increment', 'displacement_m', ...quantities.map(({ name }) => `${name}_${unit}`)],
      this.curves.flatMap(({ run, cycle }) =>
        cycle.increments.map((increment, index) => [
          run.label,
          cycle.key,
          increment,
          cycle.value('displacement', index),
          ...quantities.map(({ stored }) => stored(cycle, index)),
        ]),
      ),
    );
  }
}

function valuesOf(quantity: PathQuantity, cycle: Cycle): number[] {
  return cycle.increments.map((_, index) => quantity.value(cycle, index));
}

/** One chart per direction. */
export function pathSection(section: PathSection, keys: { key: number; name: string }[], comparison: Comparison): HTMLElement {
  return el('div', { class: 'multiples' }, ...keys.map(({ key, name }) => new PathPanel(section, key, name, comparison).root));
}

const energy = (name: string, text: string, style: number, marker: PathQuantity['marker']): PathQuantity => ({
  name,
  text,
  style,
  marker,
  // Since the start of the path, as work and dissipation are.
  value: (cycle, index) => cycle.value(name, index) - (name === 'elastic_energy' ? cycle.value(name, 0) : 0),
  stored: (cycle, index) => cycle.value(name, index),
});

/** Where the work goes. */
export const energies: PathSection = {
  title: 'Energies',
  axis: 'Energy',
  unit: 'J',
  quantities: [
    energy('work', 'work done on the foils', 0, 'circle'),
    energy('elastic_energy', 'elastic energy gained', 2, 'rect'),
    energy('dissipated_energy', 'dissipated by friction', 1, 'triangle'),
  ],
  file: 'energies',
};

const stress = (name: string, text: string, style: number, marker: PathQuantity['marker']): PathQuantity => ({
  name,
  text,
  style,
  marker,
  value: (cycle, index) => cycle.value(name, index),
  stored: (cycle, index) => cycle.value(name, index),
});

const stressQuantities = [
  stress('stress_top_foil', 'top foil over the crests', 0, 'circle'),
  stress('stress_top_foil_weld', 'top foil at the weld', 3, 'triangle'),
  stress('stress_bump_foil', 'bump foil along the arcs', 1, 'rect'),
  stress('stress_bump_foil_weld', 'bump foil at the weld', 2, 'diamond'),
];

/** The largest bending stresses that the results have. */
export function stresses(cycles: Cycle[]): PathSection {
  const known = (name: string): boolean => cycles.some((cycle) => cycle.values(name).some(Number.isFinite));
  return {
    title: 'Largest bending stress',
    axis: 'Stress',
    unit: 'Pa',
    quantities: stressQuantities.filter(({ name }) => known(name)),
    file: 'stress',
  };
}

const markers = ['circle', 'rect', 'triangle', 'diamond'] as const;

/** Part of the force that each of several pads carries. */
export function padForces(pads: number): PathSection {
  return {
    title: 'Forces of the pads',
    axis: 'Force',
    unit: 'N',
    quantities: Array.from({ length: pads }, (_, pad) => {
      const size = (cycle: Cycle, index: number): number => Math.hypot(cycle.field('pad_force_x').at(index, pad), cycle.field('pad_force_y').at(index, pad));
      return { name: `pad_force_${pad + 1}`, text: `pad ${pad + 1}`, style: pad % 8, marker: at(markers, pad % 4), value: size, stored: size };
    }),
    file: 'pad-forces',
  };
}
