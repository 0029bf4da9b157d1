import type { EChartsType } from 'echarts/core';
import { at, largest, type Branch, type Cycle, type Run } from '../data/run';
import { toCsv, type Cell } from '../data/csv';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import type { Comparison } from '../ui/comparison';
import { choice, svg } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { isPrinting, type Look } from '../ui/theme';
import { runLegend, type Curve } from './curves';
import { labelOffsets } from './label_offsets';
import { axis, Chart, roundAbove, tooltip, tooltipBox, type Option, type Point } from './chart';

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
function branchLook(current: Look, curve: Curve, loading: boolean): object {
  const color = curve.colour(current);
  return {
    lineStyle: { color, width: 1.8, type: loading ? 'solid' : [5, 3] },
    itemStyle: { color: loading ? color : current.background, borderColor: color, borderWidth: 1.4, opacity: 1 },
  };
}

/** How branches are drawn, as the legend shows it. */
function branchSample(loading: boolean): LegendEntry {
  return {
    width: 30,
    draw: (current) => [
      svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: current.text, 'stroke-width': 1.8, 'stroke-dasharray': loading ? 'none' : '5 3' }),
      svg('circle', { cx: 15, cy: 6, r: 3, stroke: current.text, 'stroke-width': 1.4, fill: loading ? current.text : current.background }),
    ],
    text: loading ? 'loading' : 'unloading',
  };
}

/** A point of a curve, and where in the chart it lies, px. */
interface Place {
  curve: Curve;
  index: number;
  x: number;
  y: number;
}

export interface LoopPanelContents {
  title: string;
  /** All that are drawn. */
  curves: () => Curve[];
  /** Those of them that are told apart. */
  focus: () => Curve[];
  /** What tells them apart; the runs that are compared without it. */
  legend?: () => LegendEntry[];
}

/** Force over displacement: the hysteresis cycles of several directions or runs, linked with the bearing. */
export class LoopPanel {
  readonly root: HTMLElement;
  private readonly forces: Force[];
  private force: Force;
  private readonly chart: Chart;
  private readonly panel: Panel;
  private curves: Curve[] = [];
  private across: Scale = { factor: 1, unit: '' };
  private upwards: Scale = { factor: 1, unit: '' };
  private series: { curve: Curve; branch: Branch; label: number | undefined }[] = [];

  constructor(
    private readonly contents: LoopPanelContents,
    private readonly comparison: Comparison,
  ) {
    const { legend = (): LegendEntry[] => runLegend(comparison) } = contents;
    this.forces = forcesOf(at(comparison.runs, 0));
    this.force = at(this.forces, 0);
    this.read();
    this.chart = new Chart(
      () => this.description(),
      (width) => this.height(width),
      (current, width) => this.option(current, width),
      (instance) => this.listen(instance),
    );
    this.panel = new Panel(
      {
        title: contents.title,
        note: 'Click a point of a loop to see the foils there.',
        controls: this.forces.length > 1 ? [this.chooser()] : [],
        subject: () => `${this.force.title} vs. displacement · ${comparison.names}`,
        legend: () => [branchSample(true), branchSample(false), ...legend()],
        file: () => fileName('loops', this.force.name, comparison.names, ...new Set(this.curves.map((curve) => curve.cycle.name))),
        drawing: () => this.chart.drawing,
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    this.root = this.panel.root;
    comparison.onChange(() => {
      this.read();
      this.panel.refresh();
      this.chart.fit();
      this.follow();
    });
    comparison.selection.onChange(() => this.follow());
    this.follow();
  }

  private read(): void {
    this.curves = this.contents.curves().filter(({ cycle }) => cycle.knows(this.force.name));
    this.series = this.focus.flatMap((curve, i) =>
      curve.cycle.branches().map((branch, k) => ({ curve, branch, label: k === 0 ? i : undefined })),
    );
    this.scale();
  }

  private get focus(): Curve[] {
    return this.contents.focus().filter(({ cycle }) => cycle.knows(this.force.name));
  }

  private description(): string {
    const peaks = this.focus.map(({ label, cycle }) => `${label} ${formatQuantity(cycle.value('force_direct', cycle.turning), 'N')}`);
    return `${this.contents.title}: ${this.force.title.toLowerCase()} vs. displacement; at full displacement ${peaks.join(', ')}`;
  }

  private chooser(): HTMLElement {
    const options = this.forces.map((value) => ({ value, text: value.text }));
    return choice(`Force shown: ${this.contents.title}`, options, this.force, (force) => {
      this.force = force;
      this.read();
      this.panel.refresh();
      this.chart.fit();
      this.follow();
    });
  }

  /** The whole of it stands above the bar at the foot of the window, also below warnings that are not unfolded. */
  private height(width: number): number {
    // Three lines of warnings at most, and the cards of runs that did not end say why.
    const above = (this.comparison.several ? 508 : 448) + (document.querySelector('.warnings') ? 90 : 0);
    const room = isPrinting() ? 380 : window.innerHeight - above;
    return Math.max(230, Math.min(0.82 * width, 620, room));
  }

  /** What the axes must have room for. */
  private get compared(): Cycle[] {
    return this.comparison.ownAxes ? this.curves.map(({ cycle }) => cycle) : this.comparison.shownLoops;
  }

  private scale(): void {
    this.across = scaleFor(largest(...this.compared.map((cycle) => cycle.values('displacement'))), 'm');
    this.upwards = scaleFor(largest(...this.compared.map((cycle) => cycle.values(this.force.name))), 'N');
  }

  private points(cycle: Cycle, indices: number[]): Point[] {
    const [across, upwards] = [this.across.factor, this.upwards.factor];
    return indices.map((index) => [cycle.value('displacement', index) * across, cycle.value(this.force.name, index) * upwards]);
  }

  private option(current: Look, width: number): Option {
    const narrow = width < 480;
    const frame = { top: 16, bottom: 48 };
    const { across, upwards, compared } = this;
    const [right, left] = reach(compared, 'displacement', across);
    const [upper, lower] = reach(compared, this.force.name, upwards);
    const perUnit = (this.height(width) - frame.top - frame.bottom) / (upper - lower);
    const { focus } = this;
    const offsets = labelOffsets(focus.map(({ cycle }) => -perUnit * at(this.points(cycle, [cycle.turning]), 0)[1]));
    return {
      grid: { left: narrow ? 52 : 62, right: narrow ? 54 : 92, ...frame },
      xAxis: axis(current, axisTitle('Displacement', across), { min: left, max: right }),
      yAxis: axis(current, axisTitle(this.force.title, upwards), { nameGap: narrow ? 38 : 46, min: lower, max: upper }),
      tooltip: tooltip(current, { triggerOn: 'none' }),
      series: [
        ...this.series.map(({ curve, branch: { loading, indices }, label }) => {
          const spacing = Math.max(1, Math.round(indices.length / 7));
          return {
            type: 'line',
            name: curve.label,
            silent: true,
            ...branchLook(current, curve, loading),
            // Marks that are not there cost nothing, those of no size as much as others.
            symbol: (_: unknown, item: { dataIndex: number }) => (item.dataIndex % spacing === spacing >> 1 ? curve.marker : 'none'),
            symbolSize: 7,
            showAllSymbol: true,
            data: this.points(curve.cycle, indices),
            z: 4,
            ...(label !== undefined ? { endLabel: endLabel(curve, current, narrow, at(offsets, label)) } : {}),
          };
        }),
        ...this.others().map((curve) => ({
          type: 'line',
          name: curve.label,
          silent: true,
          symbol: 'none',
          lineStyle: { color: curve.colour(current), width: 1.1, opacity: 0.75 },
          data: this.points(curve.cycle, curve.cycle.increments.map((_, index) => index)),
          z: 3,
        })),
      ],
    };
  }

  /** Drawn as a family, without markers. */
  private others(): Curve[] {
    const focus = new Set(this.focus.map(({ cycle }) => cycle));
    return this.curves.filter(({ cycle }) => !focus.has(cycle));
  }

  private tip({ curve: { cycle, label }, index }: Place): HTMLElement {
    return tooltipBox(label, [
      ['Increment', `${at(cycle.increments, index)}, ${cycle.isLoading(index) ? 'loading' : 'unloading'}`],
      ['Displacement', formatQuantity(cycle.value('displacement', index), 'm')],
      ...this.forces.filter(({ name }) => cycle.knows(name)).map(({ name, title }): [string, string] => [title, formatQuantity(cycle.value(name, index), 'N')]),
    ]);
  }

  /** The point next to the pointer, if it is near enough. */
  private nearest(x: number, y: number, within: number): Place | undefined {
    const drawn = [
      ...this.series.map(({ curve, branch }) => ({ curve, indices: branch.indices })),
      ...this.others().map((curve) => ({ curve, indices: curve.cycle.increments.map((_, index) => index) })),
    ];
    // Axes are linear: two points tell where all others are.
    const [x0, y0] = this.chart.pixel(0, 0, 0);
    const [x1, y1] = this.chart.pixel(0, 1, 1);
    let found: Place | undefined;
    let least = within ** 2;
    for (const { curve, indices } of drawn) {
      this.points(curve.cycle, indices).forEach(([px, py], i) => {
        const place = { curve, index: at(indices, i), x: x0 + px * (x1 - x0), y: y0 + py * (y1 - y0) };
        const distance = (place.x - x) ** 2 + (place.y - y) ** 2;
        if (distance >= least) return;
        least = distance;
        found = place;
      });
    }
    return found;
  }

  private listen(instance: EChartsType): void {
    const area = instance.getZr();
    area.on('mousemove', (event) => {
      const point = this.nearest(event.offsetX, event.offsetY, 40);
      // Told at the place itself, as most points have no mark that could tell.
      if (point) instance.dispatchAction({ type: 'showTip', x: point.x, y: point.y, tooltip: { formatter: () => this.tip(point) } });
      else instance.dispatchAction({ type: 'hideTip' });
    });
    area.on('globalout', () => instance.dispatchAction({ type: 'hideTip' }));
    area.on('click', (event) => {
      const point = this.nearest(event.offsetX, event.offsetY, 60);
      if (point && !point.curve.run.isMeasured) this.comparison.selection.show({ run: point.curve.run, key: point.curve.cycle.key, index: point.index });
    });
  }

  private follow(): void {
    const { cycle, index, run } = this.comparison.selection;
    const shown = cycle.size > 0 && this.curves.some((curve) => curve.run === run && curve.cycle === cycle);
    const [x, y] = shown ? at(this.points(cycle, [index]), 0) : [0, 0];
    this.chart.setCursors(shown ? [{ name: 'point', grid: 0, x, y }] : []);
  }

  private csv(): string {
    const names = this.forces.map(({ name }) => name);
    const rows: Cell[][] = this.curves.flatMap(({ run, cycle }) =>
      cycle.increments.map((increment, index) => [
        run.label,
        cycle.key,
        increment,
        cycle.isLoading(index) ? 'loading' : 'unloading',
        ...['displacement', ...names].map((name) => cycle.value(name, index)),
      ]),
    );
    return toCsv(
      ['run', at(this.comparison.runs, 0).kind.cycles.column, 'increment', 'branch', 'displacement_m', ...names.map((name) => `${name}_N`)],
      rows,
    );
  }
}

/** Round numbers around all values, with 0 between them. */
function reach(cycles: Cycle[], name: string, scale: Scale): [number, number] {
  let [most, least] = [0, 0];
  for (const cycle of cycles) {
    for (const value of cycle.values(name)) {
      if (value > most) most = value;
      if (value < least) least = value;
    }
  }
  return [roundAbove(most * scale.factor), least < 0 ? -roundAbove(-least * scale.factor) : 0];
}

function endLabel(curve: Curve, current: Look, narrow: boolean, offset: number): object {
  return {
    show: true,
    formatter: () => curve.label,
    color: curve.colour(current),
    fontWeight: 'bold',
    fontSize: 12,
    width: narrow ? 44 : 84,
    overflow: 'truncate',
    offset: [0, offset],
  };
}
