import type { Coordinate, Variable } from '../data/grid';
import { at, largest } from '../data/run';
import { toCsv } from '../data/csv';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import { choice } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, Chart, tooltip, tooltipBox, type Option, type Point } from './chart';
import { coordinateLegend, lookOf } from './grid_lines';
import { followPointer } from './nearest';

/** A vector at every increment. */
export interface PlaneVector {
  text: string;
  unit: string;
  x: Variable;
  y: Variable;
}

/** The way of a vector in the plane of the bearing, in true shape, in a colour for each orbit. */
export class PlanePanel {
  readonly root: HTMLElement;
  private vector: PlaneVector;
  private readonly chart: Chart;
  private readonly panel: Panel;

  /** @param orbits  their numbers; `orbit` tells which one an increment is part of, 0 on the way there */
  constructor(
    vectors: PlaneVector[],
    private readonly orbits: Coordinate,
    private readonly orbit: Variable,
    private readonly selection: GridSelection,
    label: string,
  ) {
    this.vector = at(vectors, 0);
    this.chart = new Chart(
      () => `${this.vector.text} in the plane of the bearing, ${label}`,
      (width) => Math.max(260, Math.min(width - 30, 460)),
      (current, width) => this.option(current, width),
      (instance) => followPointer(() => this.chart, instance, () => this.stretches().map((stretch) => stretch.map((i) => this.point(i))), ({ series, index }) => this.choose(series, index)),
    );
    const options = vectors.map((value) => ({ value, text: value.text }));
    this.panel = new Panel(
      {
        title: 'In the plane',
        note: 'Click a point to select it.',
        controls: [
          choice('Vector shown', options, this.vector, (vector) => {
            this.vector = vector;
            this.panel.refresh();
            this.chart.fit();
            this.follow();
          }),
        ],
        subject: () => `${this.vector.text} · ${label}`,
        legend: () => (orbits.texts.length > 1 ? coordinateLegend(orbits, false) : []),
        file: () => fileName('plane', this.vector.text, label),
        drawing: () => this.chart.drawing,
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    this.root = this.panel.root;
    selection.onChange(() => this.follow());
    this.follow();
  }

  private get size(): number {
    return this.orbit.values.length;
  }

  /** Increments of each orbit, with the last one before it, so that they hang together. */
  private stretches(): number[][] {
    return this.orbits.texts.map((_, k) => {
      const own = [...Array(this.size).keys()].filter((i) => this.orbit.values[i] === (this.orbits.numbers?.[k] ?? k));
      const first = own[0];
      return first === undefined || first === 0 ? own : [first - 1, ...own];
    });
  }

  private get scale(): Scale {
    return scaleFor(largest(this.vector.x.values, this.vector.y.values), this.vector.unit);
  }

  private point(index: number): Point {
    const { factor } = this.scale;
    return [(this.vector.x.values[index] ?? NaN) * factor, (this.vector.y.values[index] ?? NaN) * factor];
  }

  /** Ranges of both axes with the same length of a unit. */
  private ranges(width: number, height: number): { x: [number, number]; y: [number, number] } {
    const points = [...Array(this.size).keys()].map((i) => this.point(i)).filter((point) => point.every(Number.isFinite));
    const range = (k: 0 | 1): [number, number] => [Math.min(...points.map((point) => point[k])), Math.max(...points.map((point) => point[k]))];
    const [[left, right], [lower, upper]] = [range(0), range(1)];
    const unit = 1.12 * Math.max((right - left) / width, (upper - lower) / height, 1e-12);
    const around = (from: number, to: number, pixels: number): [number, number] => [0.5 * (from + to - unit * pixels), 0.5 * (from + to + unit * pixels)];
    return { x: around(left, right, width), y: around(lower, upper, height) };
  }

  private option(current: Look, width: number): Option {
    const height = Math.max(260, Math.min(width - 30, 460));
    const ranges = this.ranges(width - 90, height - 64);
    const inside = { axisLabel: { color: current.muted, fontSize: 12, hideOverlap: true, showMinLabel: false, showMaxLabel: false, formatter: (x: number) => String(Number(x.toPrecision(3))).replace('-', '−') } };
    return {
      grid: { left: 66, right: 24, top: 16, bottom: 48 },
      xAxis: axis(current, axisTitle(`${this.vector.text} X`, this.scale), { min: ranges.x[0], max: ranges.x[1], ...inside }),
      yAxis: axis(current, axisTitle(`${this.vector.text} Y`, this.scale), { nameGap: 48, min: ranges.y[0], max: ranges.y[1], ...inside }),
      tooltip: tooltip(current, { triggerOn: 'none', formatter: (tip: { seriesIndex: number; dataIndex: number }) => this.tip(tip.seriesIndex, tip.dataIndex) }),
      series: this.stretches().map((stretch, k) => ({
        type: 'line',
        name: at(this.orbits.texts, k),
        silent: true,
        symbol: 'none',
        lineStyle: { color: lookOf(this.orbits, k).colour(current), width: 1.8 },
        data: stretch.map((i) => this.point(i)),
      })),
    };
  }

  private indexAt(series: number, point: number): number | undefined {
    return this.stretches()[series]?.[point];
  }

  private tip(series: number, point: number): HTMLElement | string {
    const index = this.indexAt(series, point);
    if (index === undefined) return '';
    const { text, unit, x, y } = this.vector;
    return tooltipBox(`Increment ${index}`, [
      [`${text} X`, formatQuantity(x.values[index], unit)],
      [`${text} Y`, formatQuantity(y.values[index], unit)],
    ]);
  }

  private choose(series: number, point: number): void {
    const index = this.indexAt(series, point);
    if (index !== undefined) this.selection.show({ place: { increment: index } });
  }

  private follow(): void {
    const [x, y] = this.point(this.selection.place['increment'] ?? 0);
    this.chart.setCursors(Number.isFinite(x) ? [{ name: 'point', grid: 0, x, y }] : []);
  }

  private csv(): string {
    const { unit, x, y } = this.vector;
    return toCsv(
      ['increment', 'orbit', `${x.name}_${unit}`, `${y.name}_${unit}`],
      [...Array(this.size).keys()].map((i) => [i, this.orbit.values[i], x.values[i], y.values[i]]),
    );
  }
}
