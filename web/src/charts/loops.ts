import type { EChartsType } from 'echarts/core';
import { at, largest, type Branch, type Loop, type Run } from '../data/run';
import { toCsv, type Cell } from '../data/csv';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import { choice, svg } from '../ui/dom';
import { legend, panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Selection } from '../ui/selection';
import { look, markers, type Look } from '../ui/theme';
import { labelOffsets } from './label_offsets';
import { axis, Chart, roundAbove, tooltip, tooltipBox, type Option, type Point } from './chart';

/** One loop: a direction of a run. */
export interface Curve {
  run: Run;
  loop: Loop;
  label: string;
  /** Number of its colour and marker. */
  style: number;
}

interface Force {
  name: string;
  text: string;
  title: string;
}

/** That the results have; a plate has no cross force. */
function forcesOf(run: Run): Force[] {
  const direct = { name: 'force_direct', text: 'Direct', title: run.kind.force };
  const cross = { name: 'force_cross', text: 'Cross', title: 'Cross force' };
  return run.kind.flat ? [direct] : [direct, cross];
}

/** Line and markers of a branch: solid and filled on the way in, dashed and hollow on the way out. */
function branchLook(current: Look, style: number, loading: boolean): object {
  const color = at(current.series, style % current.series.length);
  return {
    symbol: at(markers, style % markers.length),
    lineStyle: { color, width: 1.8, type: loading ? 'solid' : [5, 3] },
    itemStyle: { color: loading ? color : current.background, borderColor: color, borderWidth: 1.4, opacity: 1 },
  };
}

/** Force over displacement: the hysteresis loops of several directions or runs, linked with the bearing. */
export class LoopPanel {
  readonly root: HTMLElement;
  private readonly forces: Force[];
  private force: Force;
  private readonly chart: Chart;
  private readonly across: Scale;
  private upwards: Scale;
  private readonly series: { curve: Curve; branch: Branch; label: number | undefined }[];

  constructor(
    title: string,
    private readonly curves: Curve[],
    private readonly selection: Selection,
  ) {
    this.forces = forcesOf(at(curves, 0).run);
    this.force = at(this.forces, 0);
    this.across = scaleFor(largest(...curves.map((curve) => curve.loop.values('displacement'))), 'm');
    this.upwards = this.scaleOfForce();
    this.series = curves.flatMap((curve, i) =>
      curve.loop.branches().map((branch, k) => ({ curve, branch, label: k === 0 ? i : undefined })),
    );
    const peaks = curves.map(({ label, loop }) => {
      const force = loop.value('force_direct', loop.turning);
      return `${label} ${formatQuantity(force, 'N')}`;
    });
    this.chart = new Chart(
      `${title}: ${this.force.title.toLowerCase()} over displacement; at full displacement ${peaks.join(', ')}`,
      (width) => this.height(width),
      (current, width) => this.option(current, width),
      (instance) => this.listen(instance),
    );
    this.root = panel(
      {
        title,
        note: 'Click a point of a loop to see the foils there.',
        controls: this.forces.length > 1 ? [this.chooser()] : [],
        file: () => fileName('loops', ...new Set(curves.map((curve) => curve.loop.name))),
        svg: () => this.chart.toSvg(),
        csv: () => this.csv(),
      },
      this.chart.root,
      legend([
        { sample: this.sample(true), text: 'loading' },
        { sample: this.sample(false), text: 'unloading' },
      ]),
    );
    selection.onChange(() => this.follow());
    this.follow();
  }

  private chooser(): HTMLElement {
    const options = this.forces.map((value) => ({ value, text: value.text }));
    return choice('Force shown', options, this.force, (force) => {
      this.force = force;
      this.upwards = this.scaleOfForce();
      this.chart.fit();
    });
  }

  private height(width: number): number {
    return Math.max(300, Math.min(0.82 * width, 560));
  }

  private scaleOfForce(): Scale {
    return scaleFor(largest(...this.curves.map((curve) => curve.loop.values(this.force.name))), 'N');
  }

  private point(loop: Loop, index: number): Point {
    return [
      loop.value('displacement', index) * this.across.factor,
      loop.value(this.force.name, index) * this.upwards.factor,
    ];
  }

  private option(current: Look, width: number): Option {
    const narrow = width < 480;
    const frame = { top: 16, bottom: 48 };
    const forces = this.curves.flatMap(({ loop }) => [...loop.values(this.force.name)]).filter(Number.isFinite);
    const upper = roundAbove(this.upwards.factor * Math.max(0, ...forces));
    const lower = forces.some((force) => force < 0) ? -roundAbove(-this.upwards.factor * Math.min(...forces)) : 0;
    const perUnit = (this.height(width) - frame.top - frame.bottom) / (upper - lower);
    const ends = this.curves.map(({ loop }) => -perUnit * this.point(loop, loop.turning)[1]);
    const offsets = labelOffsets(ends);
    const backwards = this.curves.some(({ loop }) => loop.values('displacement').some((displacement) => displacement < 0));
    return {
      grid: { left: narrow ? 52 : 62, right: narrow ? 54 : 92, ...frame },
      xAxis: axis(current, axisTitle('Displacement', this.across), backwards ? {} : { min: 0 }),
      yAxis: axis(current, axisTitle(this.force.title, this.upwards), {
        nameGap: narrow ? 38 : 46,
        min: lower,
        max: upper,
      }),
      tooltip: tooltip(current, {
        triggerOn: 'none',
        formatter: (tip: { seriesIndex: number; dataIndex: number }) => this.tip(tip.seriesIndex, tip.dataIndex),
      }),
      series: this.series.map(({ curve, branch: { loading, indices }, label }) => {
        const spacing = Math.max(1, Math.round(indices.length / 7));
        return {
          type: 'line',
          name: curve.label,
          silent: true,
          ...branchLook(current, curve.style, loading),
          symbolSize: (_: unknown, item: { dataIndex: number }) => (item.dataIndex % spacing === spacing >> 1 ? 7 : 0),
          showAllSymbol: true,
          data: indices.map((index) => this.point(curve.loop, index)),
          z: curve.loop === this.selection.loop ? 4 : 3,
          ...(label !== undefined
            ? {
                endLabel: {
                  show: true,
                  formatter: () => curve.label,
                  color: at(current.series, curve.style % current.series.length),
                  fontWeight: 'bold',
                  fontSize: 12,
                  width: narrow ? 44 : 84,
                  overflow: 'truncate',
                  offset: [0, at(offsets, label)],
                },
              }
            : {}),
        };
      }),
    };
  }

  private tip(seriesIndex: number, dataIndex: number): HTMLElement | string {
    const series = this.series[seriesIndex];
    const index = series?.branch.indices[dataIndex];
    if (!series || index === undefined) return '';
    const { loop, label } = series.curve;
    const increment = at(loop.increments, index);
    return tooltipBox(label, [
      ['Increment', `${increment}, ${series.branch.loading ? 'loading' : 'unloading'}`],
      ['Displacement', formatQuantity(loop.value('displacement', index), 'm')],
      ...this.forces.map(({ name, title }): [string, string] => [title, formatQuantity(loop.value(name, index), 'N')]),
    ]);
  }

  /** The point next to the pointer, if it is near enough. */
  private nearest(x: number, y: number, reach: number): { seriesIndex: number; dataIndex: number } | undefined {
    let found: { seriesIndex: number; dataIndex: number } | undefined;
    let least = reach ** 2;
    this.series.forEach(({ curve, branch }, seriesIndex) => {
      branch.indices.forEach((index, dataIndex) => {
        const [px, py] = this.chart.pixel(0, ...this.point(curve.loop, index));
        const distance = (px - x) ** 2 + (py - y) ** 2;
        if (distance < least) {
          least = distance;
          found = { seriesIndex, dataIndex };
        }
      });
    });
    return found;
  }

  private listen(instance: EChartsType): void {
    const area = instance.getZr();
    area.on('mousemove', (event) => {
      const point = this.nearest(event.offsetX, event.offsetY, 40);
      if (point) instance.dispatchAction({ type: 'showTip', ...point });
      else instance.dispatchAction({ type: 'hideTip' });
    });
    area.on('globalout', () => instance.dispatchAction({ type: 'hideTip' }));
    area.on('click', (event) => {
      const point = this.nearest(event.offsetX, event.offsetY, 60);
      if (!point) return;
      const { curve, branch } = at(this.series, point.seriesIndex);
      this.selection.show({
        run: curve.run,
        key: curve.loop.key,
        index: at(branch.indices, point.dataIndex),
      });
    });
  }

  private follow(): void {
    const { loop, index, run } = this.selection;
    const shown = this.curves.some((curve) => curve.run === run && curve.loop === loop);
    const [x, y] = this.point(loop, index);
    this.chart.setCursors(shown ? [{ name: 'point', grid: 0, x, y }] : []);
  }

  private sample(loading: boolean): SVGElement {
    const marker = { cx: 15, cy: 6, r: 3, stroke: 'currentColor', 'stroke-width': 1.4 };
    return svg(
      'svg',
      { width: 30, height: 12, 'aria-hidden': 'true' },
      svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: 'currentColor', 'stroke-width': 1.8, 'stroke-dasharray': loading ? 'none' : '5 3' }),
      svg('circle', { ...marker, class: loading ? 'filled' : 'hollow' }),
    );
  }

  private csv(): string {
    const names = this.forces.map(({ name }) => name);
    const rows: Cell[][] = this.curves.flatMap(({ run, loop }) =>
      loop.increments.map((increment, index) => [
        run.label,
        loop.key,
        increment,
        loop.isLoading(index) ? 'loading' : 'unloading',
        ...['displacement', ...names].map((name) => loop.value(name, index)),
      ]),
    );
    return toCsv(
      ['run', at(this.curves, 0).run.kind.loops.column, 'increment', 'branch', 'displacement_m', ...names.map((name) => `${name}_N`)],
      rows,
    );
  }
}

/** Colour of a curve, for what stands for it elsewhere. */
export function curveColour(style: number): string {
  const { series } = look();
  return at(series, style % series.length);
}
