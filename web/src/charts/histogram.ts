import { toCsv } from '../data/csv';
import type { Ensemble } from '../data/ensemble';
import type { DistributionData, Quantity, StatisticsData } from '../data/format';
import { at, capital, largest } from '../data/run';
import { axisTitle, formatNumber, formatQuantity, scaleFor, type Scale } from '../data/units';
import { svg } from '../ui/dom';
import type { EnsembleSelection } from '../ui/ensemble_selection';
import type { LegendEntry } from '../ui/legend';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Chart, type Option, type RenderApi } from './chart';
import { ChartPanel } from './chart_panel';

/** Marks of the bearings that can be looked at, px. */
const markHeight = 9;
/** From so near a click finds one, px. */
const nearEnough = 60;

const line = (dash: string) => (current: Look): SVGElement[] => [
  svg('line', { x1: 1, y1: 6, x2: 25, y2: 6, stroke: current.text, 'stroke-width': 2, 'stroke-dasharray': dash }),
];

/** What the marks in all histograms stand for. */
const legend: LegendEntry[] = [
  { width: 26, draw: line('none'), text: 'mean' },
  { width: 26, draw: line('4 3'), text: 'median' },
  { width: 26, draw: (current) => [svg('rect', { x: 1, y: 1, width: 24, height: 10, fill: current.line, 'fill-opacity': 0.45 })], text: '5 % to 95 % of the bearings' },
];
const legendOfMarks: LegendEntry = {
  width: 10,
  draw: (current) => [svg('line', { x1: 5, y1: 1, x2: 5, y2: 11, stroke: current.text, 'stroke-width': 1.6 })],
  text: 'bearings that can be inspected',
};

/** How a quantity is distributed over the bearings of an ensemble, in the direction that is looked at. */
export class HistogramPanel {
  readonly root: HTMLElement;
  private readonly panel: ChartPanel;
  private readonly distribution: DistributionData;

  constructor(
    private readonly ensemble: Ensemble,
    private readonly quantity: Quantity,
    distribution: DistributionData,
    private readonly selection: EnsembleSelection,
  ) {
    this.distribution = distribution;
    const title = capital(quantity.label);
    const looked = ensemble.runs.length > 0;
    this.panel = new ChartPanel({
      title,
      ...(looked ? { note: 'Click to inspect the bearing with the nearest mark.' } : {}),
      subject: () => `${this.words()} · ${this.direction} · ${ensemble.label}`,
      legend: () => (looked ? [...legend, legendOfMarks] : legend),
      file: () => fileName('distribution', quantity.name, ensemble.label, this.direction),
      csv: () => this.csv(),
      description: () => `Distribution of ${quantity.label}, ${this.direction}: ${this.words()}`,
      option: (current) => this.option(current),
      ready: (chart, instance) => instance.getZr().on('click', ({ offsetX }) => this.choose(chart, offsetX)),
    });
    this.root = this.panel.root;
    let direction = selection.direction;
    selection.onChange(() => {
      if (direction !== selection.direction) this.panel.refresh();
      direction = selection.direction;
      this.follow();
    });
    this.follow();
  }

  /** To be called when the numbers have changed. */
  refresh(): void {
    this.panel.refresh();
  }

  private get direction(): string {
    return at(this.ensemble.directions, this.selection.direction);
  }

  private get statistics(): StatisticsData | undefined {
    return this.ensemble.statistics(this.quantity, this.selection.direction);
  }

  private get scale(): Scale {
    const { from, to } = this.distribution;
    return scaleFor(largest([from ?? 0, to ?? 0]), this.quantity.unit);
  }

  private number(key: string): number {
    const value = this.statistics?.[key];
    return typeof value === 'number' ? value : NaN;
  }

  private words(): string {
    const { statistics, quantity } = this;
    if (!statistics || statistics.count === 0) return 'not known for any bearing';
    const [low, high] = statistics.mean_interval_95;
    const half = 0.5 * ((high ?? NaN) - (low ?? NaN));
    // One unit for all.
    const { factor, unit } = scaleFor(Math.abs(this.number('mean')), quantity.unit);
    const value = (number: number): string => `${formatNumber(number * factor)} ${unit}`.trimEnd();
    return [
      `mean ${value(this.number('mean'))}${Number.isFinite(half) ? ` ± ${value(half)} (95 %)` : ''}`,
      `5 % below ${value(this.number('p5'))}, 5 % above ${value(this.number('p95'))}`,
      ...(statistics.undefined > 0 ? [`not defined for ${statistics.undefined} of ${statistics.undefined + statistics.count}`] : []),
    ].join(', ');
  }

  /** Intervals with their counts. */
  private get bars(): [number, number, number][] {
    const { from, to, counts } = this.distribution;
    const all = counts[this.selection.direction] ?? [];
    if (from === null || to === null) return [];
    // All the same: a bar of some width is still to be seen.
    const [first, last] = from < to ? [from, to] : [from - 0.05 * Math.abs(from || 1), to + 0.05 * Math.abs(to || 1)];
    const width = (last - first) / Math.max(1, all.length);
    return all.map((count, i) => [first + i * width, first + (i + 1) * width, count]);
  }

  private option(current: Look): Option {
    const { bars, scale } = this;
    const most = Math.max(1, ...this.distribution.counts.flat());
    const shown = (value: number): number => value * scale.factor;
    const [p5, p50, p95, mean] = ['p5', 'p50', 'p95', 'mean'].map((key) => shown(this.number(key)));
    const rows = this.ensemble.runs.map((run) => shown(this.value(run))).filter(Number.isFinite);
    const behind = { type: 'custom', silent: true, clip: true };
    return {
      grid: { left: 52, right: 18, top: 12, bottom: 48 },
      xAxis: axis(current, axisTitle(capital(this.quantity.label), scale), {
        scale: true,
        min: shown(bars[0]?.[0] ?? 0),
        max: shown(bars[bars.length - 1]?.[1] ?? 1),
        axisLabel: { color: current.muted, fontSize: 12, hideOverlap: true, showMinLabel: false, showMaxLabel: false, formatter: (x: number) => String(Number(x.toPrecision(4))).replace('-', '−') },
      }),
      yAxis: axis(current, 'Bearings', { nameGap: 36, min: 0, max: Math.ceil(1.05 * most), minInterval: 1, axisLabel: { color: current.muted, fontSize: 12, showMaxLabel: false } }),
      tooltip: tooltip(current, { trigger: 'item', formatter: (item: { dataIndex: number }) => this.tip(item.dataIndex) }),
      series: [
        { ...behind, name: '5 % to 95 %', data: [[p5, p95]].filter((pair) => pair.every(Number.isFinite)), renderItem: (item: Area, api: RenderApi) => band(item, api, current.line) },
        {
          type: 'custom',
          name: 'bearings',
          clip: true,
          encode: { x: [0, 1], y: 2 },
          data: bars.map(([from, to, count]) => [shown(from), shown(to), count]),
          renderItem: (_: unknown, api: RenderApi) => bar(api, current.accent),
        },
        { ...behind, name: 'mean', data: [[mean]].filter(([x]) => Number.isFinite(x)), renderItem: (item: Area, api: RenderApi) => upright(item, api, current.text) },
        { ...behind, name: 'median', data: [[p50]].filter(([x]) => Number.isFinite(x)), renderItem: (item: Area, api: RenderApi) => upright(item, api, current.text, [4, 3]) },
        { ...behind, name: 'looked at', data: rows.map((x) => [x]), renderItem: (item: Area, api: RenderApi) => mark(item, api, current.text) },
      ],
    };
  }

  private value(run: Ensemble['runs'][number]): number {
    return this.ensemble.numberOf(run, this.quantity.name, this.selection.direction);
  }

  private tip(index: number): HTMLElement | string {
    const bar = this.bars[index];
    if (!bar) return '';
    const [from, to, count] = bar;
    const all = this.bars.reduce((sum, [, , one]) => sum + one, 0);
    return tooltipBox(`${count} of ${all} bearings`, [
      ['From', formatQuantity(from, this.quantity.unit)],
      ['To', formatQuantity(to, this.quantity.unit)],
    ]);
  }

  /** The bearing whose mark is nearest. */
  private choose(chart: Chart, x: number): void {
    const places = this.ensemble.runs.map((run) => ({ run, distance: Math.abs(chart.pixel(0, this.value(run) * this.scale.factor, 0)[0] - x) }));
    const nearest = places.filter(({ distance }) => distance <= nearEnough).sort((a, b) => a.distance - b.distance)[0];
    if (nearest) this.selection.show({ run: nearest.run });
  }

  private follow(): void {
    const { run } = this.selection;
    const x = run ? this.value(run) * this.scale.factor : NaN;
    this.panel.chart.setCursors(Number.isFinite(x) ? [{ name: 'line', grid: 0, x }] : []);
  }

  private csv(): string {
    const unit = this.quantity.unit === '' ? '' : `_${this.quantity.unit}`;
    return toCsv([this.ensemble.placeColumn.name, `from${unit}`, `to${unit}`, 'bearings'], this.bars.map((bar) => [at(this.ensemble.placeColumn.cells, this.selection.direction), ...bar]));
  }
}

interface Area {
  coordSys: { x: number; y: number; width: number; height: number };
}

function bar(api: RenderApi, fill: string): object {
  const [left, top] = api.coord([api.value(0), api.value(2)]);
  const [right, foot] = api.coord([api.value(1), 0]);
  return { type: 'rect', shape: { x: left, y: top, width: Math.max(0.6, right - left - 1), height: foot - top }, style: { fill, opacity: 0.8 } };
}

function band({ coordSys: { y, height } }: Area, api: RenderApi, fill: string): object {
  const [left, right] = [api.coord([api.value(0), 0])[0], api.coord([api.value(1), 0])[0]];
  return { type: 'rect', shape: { x: left, y, width: right - left, height }, style: { fill, opacity: 0.45 } };
}

function upright({ coordSys: { y, height } }: Area, api: RenderApi, stroke: string, lineDash: number[] = []): object {
  const [x] = api.coord([api.value(0), 0]);
  return { type: 'line', shape: { x1: x, y1: y, x2: x, y2: y + height }, style: { stroke, lineWidth: 2, lineDash } };
}

function mark({ coordSys: { y, height } }: Area, api: RenderApi, stroke: string): object {
  const [x] = api.coord([api.value(0), 0]);
  return { type: 'line', shape: { x1: x, y1: y + height - markHeight, x2: x, y2: y + height }, style: { stroke, lineWidth: 1.6 } };
}
