import { axisScale, columnNameOf, type Place } from '../data/grid';
import { at, largest } from '../data/run';
import { toCsv, type Cell } from '../data/csv';
import { rangeOf } from '../data/range';
import { axisTitle, formatNumber, formatQuantity, scaleFor, type Scale } from '../data/units';
import { dropDown } from '../ui/dom';
import { named, type GridSelection } from '../ui/grid_selection';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { isPrinting, type Look } from '../ui/theme';
import { axis, Chart, tooltip, tooltipBox, type Option, type Point } from './chart';
import { coordinateLegend, lineEntry, lookOf, plainLook, type LineLook } from './grid_lines';
import { followPointer } from './nearest';
import { tickText } from './ticks';

/** A number at every point of a grid. */
export interface Part {
  /** Of the column in files. */
  key: string;
  text: string;
  /** Dimensions that it has. */
  has: (dimension: string) => boolean;
  value: (place: Place) => number;
}

/** What a chart shows: one quantity, of which lines differ in a coordinate, or several of one unit. */
export interface Measure {
  text: string;
  unit: string;
  parts: Part[];
}

interface Line {
  text: string;
  look: LineLook;
  part: Part;
  /** One for each value along the axis. */
  places: Place[];
}

/** Beyond so many points lines have no markers. */
const mostMarkers = 60;

/** A quantity over a coordinate of a grid. */
export class OverPanel {
  readonly root: HTMLElement;
  private measure: Measure;
  private lines: Line[] = [];
  private readonly chart: Chart;
  private readonly panel: Panel;

  constructor(
    private readonly title: string,
    private readonly measures: Measure[],
    private readonly selection: GridSelection,
    private readonly label: string,
  ) {
    this.measure = at(measures, 0);
    this.read();
    this.chart = new Chart(
      () => this.description(),
      (width) => this.height(width),
      (current) => this.option(current),
      (instance) => followPointer(() => this.chart, instance, () => this.points(), ({ series, index }) => this.choose(series, index)),
    );
    this.panel = new Panel(
      {
        title,
        note: 'Click a point to select it.',
        controls: measures.length > 1 ? [this.chooser()] : [],
        subject: () => this.subject(),
        legend: () => this.legend(),
        file: () => fileName(this.measure.text, label),
        drawing: () => this.chart.drawing,
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    this.root = this.panel.root;
    let drawn = this.drawnPlace();
    selection.onChange(() => {
      const now = this.drawnPlace();
      if (now === drawn) return this.follow();
      drawn = now;
      this.refresh();
    });
    this.follow();
  }

  /** What all that is drawn depends on; where on its axis the reader is, the cursor shows. */
  private drawnPlace(): string {
    const { along, by, place } = this.selection;
    return JSON.stringify([along.title, along.name, by?.name, { ...place, [along.name]: 0 }]);
  }

  private chooser(): HTMLElement {
    const options = this.measures.map((value) => ({ value, text: value.text }));
    return dropDown(`Quantity: ${this.title}`, options, (measure) => {
      this.measure = measure;
      this.refresh();
    });
  }

  /** To be called when the numbers have changed. */
  refresh(): void {
    this.read();
    this.panel.refresh();
    this.chart.fit();
    this.follow();
  }

  private read(): void {
    const { selection, measure } = this;
    const { along, by, place } = selection;
    const line = (part: Part, text: string, look: LineLook, at: Place): Line => ({
      text,
      look,
      part,
      places: along.texts.map((_, i) => ({ ...at, [along.name]: i })),
    });
    const first = at(measure.parts, 0);
    if (measure.parts.length > 1) {
      this.lines = measure.parts.map((part, i) => line(part, part.text, plainLook(i), place));
    } else if (by && first.has(by.name)) {
      this.lines = by.texts.map((_, i) => line(first, named(by, i), lookOf(by, i), { ...place, [by.name]: i }));
    } else {
      this.lines = [line(first, measure.text, plainLook(0), place)];
    }
  }

  /** What is the same for all that is drawn. */
  private subject(): string {
    const { along, by, place } = this.selection;
    const several = this.measure.parts.length > 1;
    const others = this.selection.coordinates.filter((one) => !at(this.measure.parts, 0).has(one.name));
    const fixed = this.selection.textAt(place, along, several ? undefined : by, ...others);
    return [`${this.measure.text} over ${along.title}`, fixed, this.label].filter((text) => text !== '').join(' · ');
  }

  private legend(): LegendEntry[] {
    const { by } = this.selection;
    if (this.lines.length < 2) return [];
    return this.measure.parts.length > 1 || !by ? this.lines.map(({ look, text }) => lineEntry(look, text)) : coordinateLegend(by);
  }

  private description(): string {
    const ends = this.lines.slice(0, 8).map(({ text, part, places }) => {
      const values = places.map((place) => part.value(place)).filter(Number.isFinite);
      const range = rangeOf(values).map((value) => this.valueText(value));
      return values.length === 0 ? `${text}: not known` : `${text} from ${range[0] ?? ''} to ${range[1] ?? ''}`;
    });
    return `${this.subject()}: ${ends.join('; ')}${this.lines.length > 8 ? '; and more' : ''}`;
  }

  private valueText(value: number): string {
    return this.measure.unit === '' ? formatNumber(value) : formatQuantity(value, this.measure.unit);
  }

  private height(width: number): number {
    const room = isPrinting() ? 320 : window.innerHeight - 330;
    return Math.max(260, Math.min(0.75 * width, 520, room));
  }

  private get scale(): Scale {
    return scaleFor(largest(...this.lines.map(({ part, places }) => places.map((place) => part.value(place)))), this.measure.unit);
  }

  private across(index: number): number {
    const { along } = this.selection;
    return along.numbers ? at(along.numbers, index) * axisScale(along).factor : index;
  }

  private points(): Point[][] {
    const { factor } = this.scale;
    return this.lines.map(({ part, places }) => places.map((place, i): Point => [this.across(i), part.value(place) * factor]));
  }

  private option(current: Look): Option {
    const { along } = this.selection;
    const points = this.points();
    const [least, most] = rangeOf(points.flatMap((line) => line.map(([, y]) => y)));
    const few = along.texts.length <= mostMarkers;
    return {
      grid: { left: 66, right: 24, top: 16, bottom: 48 },
      xAxis: axis(current, axisTitle(along.title, along.numbers ? axisScale(along) : { factor: 1, unit: '' }), {
        scale: true,
        ...(along.numbers ? {} : this.categories(current)),
      }),
      // What hardly varies would be a straight line above an axis from 0.
      yAxis: axis(current, axisTitle(this.measure.text, this.scale), { nameGap: 48, scale: least > 0.6 * most || most < 0.6 * least }),
      tooltip: tooltip(current, { triggerOn: 'none', formatter: (tip: { seriesIndex: number; dataIndex: number }) => this.tip(tip.seriesIndex, tip.dataIndex) }),
      series: this.lines.map(({ text, look }, i) => ({
        type: 'line',
        name: text,
        silent: true,
        symbol: look.marker,
        symbolSize: few ? 7 : 0,
        showSymbol: few,
        lineStyle: { color: look.colour(current), width: 1.8 },
        itemStyle: { color: look.colour(current) },
        data: at(points, i).map(([x, y]) => [x, Number.isFinite(y) ? y : null]),
      })),
    };
  }

  /** An axis with a name at every place. */
  private categories(current: Look): object {
    const { texts } = this.selection.along;
    return {
      min: -0.5,
      max: texts.length - 0.5,
      interval: 1,
      axisLabel: { color: current.muted, fontSize: 12, hideOverlap: true, customValues: [...texts.keys()], formatter: (i: number) => texts[i] ?? tickText(i) },
      axisTick: { customValues: [...texts.keys()], lineStyle: { color: current.line } },
      splitLine: { show: false },
    };
  }

  private tip(series: number, index: number): HTMLElement | string {
    const line = this.lines[series];
    const place = line?.places[index];
    if (!line || !place) return '';
    const { selection } = this;
    const rows = selection.coordinates
      .filter((one) => one.texts.length > 1 && line.part.has(one.name))
      .map((one): [string, string] => [one.title, one.texts[place[one.name] ?? 0] ?? '']);
    return tooltipBox(line.part.text, [...rows, [this.measure.text, this.valueText(line.part.value(place))]]);
  }

  private choose(series: number, index: number): void {
    const place = this.lines[series]?.places[index];
    if (place) this.selection.show({ place });
  }

  private follow(): void {
    const index = this.selection.index(this.selection.along);
    const lines = this.measure.parts.length > 1 ? this.lines : this.lines.filter(({ places }) => this.isLookedAt(places[index]));
    const { factor } = this.scale;
    this.chart.setCursors(
      lines.flatMap(({ part, places }) => {
        const y = part.value(at(places, index)) * factor;
        return Number.isFinite(y) ? [{ name: 'point', grid: 0, x: this.across(index), y }] : [];
      }),
    );
  }

  private isLookedAt(place: Place | undefined): boolean {
    return place !== undefined && this.selection.coordinates.every(({ name }) => place[name] === this.selection.place[name]);
  }

  private csv(): string {
    const { coordinates } = this.selection;
    const keys = [...new Set(this.lines.map(({ part }) => part.key))];
    const known = coordinates.filter(({ name }) => at(this.measure.parts, 0).has(name));
    const header = [...known.map(columnNameOf), ...keys];
    const row = (place: Place, values: Cell[]): Cell[] => [
      ...known.map(({ name, numbers, texts }) => (numbers ?? texts)[place[name] ?? 0]),
      ...values,
    ];
    if (this.measure.parts.length > 1) {
      const { places } = at(this.lines, 0);
      return toCsv(header, places.map((place) => row(place, this.lines.map(({ part }) => part.value(place)))));
    }
    return toCsv(header, this.lines.flatMap(({ part, places }) => places.map((place) => row(place, [part.value(place)]))));
  }
}

