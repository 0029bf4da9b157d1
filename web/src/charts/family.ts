import { at } from '../data/run';
import { columnNameOf, type Coordinate, type Place } from '../data/grid';
import { toCsv, type Cell } from '../data/csv';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import { choice } from '../ui/dom';
import { named, type GridSelection } from '../ui/grid_selection';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { isPrinting, type Look } from '../ui/theme';
import { axis, Chart, tooltip, tooltipBox, type Option, type Point } from './chart';
import { coordinateLegend, lookOf } from './grid_lines';
import { followPointer } from './nearest';

/** A force along the loops of a grid. */
export interface LoopForce {
  key: string;
  text: string;
  title: string;
  values: (place: Place) => number[];
}

export interface Loops {
  /** What their points are numbered by. */
  counter: string;
  displacement: (place: Place) => number[];
  forces: LoopForce[];
}

/** More loops than these cannot be seen one by one: of more, every n-th is drawn. */
const mostLoops = 60;

/** The loops along a coordinate, all else as at the point that is looked at, whose loop is the thick one. */
export class FamilyPanel {
  readonly root: HTMLElement;
  private force: LoopForce;
  private readonly chart: Chart;
  private readonly panel: Panel;
  /** Indices along the coordinate; the one looked at is the last, on top. */
  private drawn: number[] = [];

  constructor(
    private readonly loops: Loops,
    private readonly selection: GridSelection,
    private readonly label: string,
  ) {
    this.force = at(loops.forces, 0);
    this.read();
    this.chart = new Chart(
      () => this.subject(),
      (width) => this.height(width),
      (current) => this.option(current),
      (instance) => followPointer(() => this.chart, instance, () => this.points(), ({ series }) => this.choose(series)),
    );
    const forces = loops.forces.map((value) => ({ value, text: value.text }));
    this.panel = new Panel(
      {
        title: 'Loops',
        note: 'Click a loop to select it.',
        controls: forces.length > 1 ? [choice('Force shown', forces, this.force, (force) => this.show(force))] : [],
        subject: () => this.subject(),
        legend: () => coordinateLegend(this.along, false),
        file: () => fileName('loops', this.force.key, label),
        drawing: () => this.chart.drawing,
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    this.root = this.panel.root;
    selection.onChange(() => this.refresh());
  }

  private get along(): Coordinate {
    return this.selection.along;
  }

  private show(force: LoopForce): void {
    this.force = force;
    this.refresh();
  }

  private refresh(): void {
    this.read();
    this.panel.refresh();
    this.chart.fit();
  }

  private read(): void {
    const looked = this.selection.index(this.along);
    const every = Math.ceil(this.along.texts.length / mostLoops);
    const others = [...this.along.texts.keys()].filter((i) => i % every === 0 && i !== looked);
    this.drawn = [...others, looked].filter((i) => this.loops.displacement(this.placeOf(i)).length > 0);
  }

  private placeOf(index: number): Place {
    return { ...this.selection.place, [this.along.name]: index };
  }

  private subject(): string {
    const { along, selection } = this;
    const every = Math.ceil(along.texts.length / mostLoops);
    return [
      `${this.force.title} vs. displacement`,
      selection.textAt(selection.place, along),
      `thick: ${named(along, selection.index(along))}`,
      every > 1 ? `one loop in ${every} is drawn` : '',
      this.label,
    ]
      .filter((text) => text !== '')
      .join(' · ');
  }

  private height(width: number): number {
    const room = isPrinting() ? 320 : window.innerHeight - 330;
    return Math.max(260, Math.min(0.75 * width, 520, room));
  }

  private scaleOf(values: (place: Place) => number[], unit: string): Scale {
    const sizes = this.drawn.map((i) => values(this.placeOf(i)).reduce((most, value) => Math.max(most, Math.abs(value)), 0));
    return scaleFor(Math.max(0, ...sizes), unit);
  }

  private get across(): Scale {
    return this.scaleOf(this.loops.displacement, 'm');
  }

  private get upwards(): Scale {
    return this.scaleOf(this.force.values, 'N');
  }

  private points(): Point[][] {
    const [across, upwards] = [this.across.factor, this.upwards.factor];
    return this.drawn.map((i) => {
      const place = this.placeOf(i);
      const force = this.force.values(place);
      return this.loops.displacement(place).map((x, k): Point => [x * across, (force[k] ?? NaN) * upwards]);
    });
  }

  private option(current: Look): Option {
    const points = this.points();
    const looked = this.selection.index(this.along);
    return {
      grid: { left: 66, right: 24, top: 16, bottom: 48 },
      xAxis: axis(current, axisTitle('Displacement', this.across), { scale: true }),
      yAxis: axis(current, axisTitle(this.force.title, this.upwards), { nameGap: 48, scale: true }),
      tooltip: tooltip(current, { triggerOn: 'none', formatter: (tip: { seriesIndex: number; dataIndex: number }) => this.tip(tip.seriesIndex, tip.dataIndex) }),
      series: this.drawn.map((index, i) => ({
        type: 'line',
        name: named(this.along, index),
        silent: true,
        symbol: 'none',
        lineStyle: { color: lookOf(this.along, index).colour(current), width: index === looked ? 3 : 1.3 },
        data: at(points, i),
      })),
    };
  }

  private tip(series: number, point: number): HTMLElement | string {
    const index = this.drawn[series];
    if (index === undefined) return '';
    const place = this.placeOf(index);
    return tooltipBox(named(this.along, index), [
      ['Displacement', formatQuantity(this.loops.displacement(place)[point], 'm')],
      ...this.loops.forces.map(({ title, values }): [string, string] => [title, formatQuantity(values(place)[point], 'N')]),
    ]);
  }

  private choose(series: number): void {
    const index = this.drawn[series];
    if (index !== undefined) this.selection.show({ place: { [this.along.name]: index } });
  }

  private csv(): string {
    const { coordinates } = this.selection;
    const header = coordinates.map(columnNameOf);
    const rows = [...this.drawn].sort((a, b) => a - b).flatMap((index) => {
      const place = this.placeOf(index);
      const forces = this.loops.forces.map(({ values }) => values(place));
      return this.loops.displacement(place).map((x, k): Cell[] => [
        ...coordinates.map(({ name, numbers, texts }) => (numbers ?? texts)[place[name] ?? 0]),
        k,
        x,
        ...forces.map((values) => values[k]),
      ]);
    });
    return toCsv([...header, this.loops.counter, 'displacement_m', ...this.loops.forces.map(({ key }) => `${key}_N`)], rows);
  }
}
