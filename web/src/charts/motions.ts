import { toCsv } from '../data/csv';
import type { GridData, OnsetData } from '../data/format';
import type { Place } from '../data/grid';
import { at } from '../data/run';
import { speedText } from '../data/states';
import { formatNumber } from '../data/units';
import { contactKinds, contactTexts, onsetText, type Mode, type Whirls } from '../data/whirls';
import { svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, Chart, tooltip, tooltipBox, type Option, type Point } from './chart';
import { lineEntry, plainLook, type LineLook } from './grid_lines';
import { followPointer } from './nearest';

interface MotionAxis {
  title: () => string;
  value: (whirls: Whirls, place: Place) => number;
  /** Where it begins; at what is shown without it. */
  min?: number;
}

/** A line that is of no motion. */
interface Guide {
  points: Point[];
  /** At its end. */
  label?: string;
  /** Of what the coefficients say, or of the run that is compared with. */
  line?: 'dotted' | 'dashed';
}

export type DiagramTitle = 'Campbell diagram' | 'Growth over speed' | 'Root locus';

/** What a chart shows of motions at speeds. */
interface Diagram {
  title: DiagramTitle;
  across: MotionAxis;
  upwards: MotionAxis;
  guides: (contacts: number) => Guide[];
  onsetAt: (onset: OnsetData) => Point;
  /** Of its guides. */
  legend: LegendEntry[];
  /** Where the speed is on no axis: marks of the highest speed are larger. */
  note?: string;
}

/** Beyond so many speeds marks are small. */
const mostMarks = 40;
/** Solid, and then dashed where there are more motions than colours. */
const dashes = [undefined, [7, 3], [2, 2]];
const colours = 8;

function lookOf(motion: number): LineLook {
  const dash = dashes[Math.floor(motion / colours) % dashes.length];
  return { ...plainLook(motion), ...(dash ? { dash } : {}) };
}

/** A cross for onsets of all motions, an upright one for those by coefficients. */
const onsetMarks = { full: 'M0 0L10 10M10 0L0 10', byCoefficients: 'M5 0V10M0 5H10' };

function onsetEntry(mark: string, text: string): LegendEntry {
  return { width: 14, draw: (current) => [svg('path', { d: mark, transform: 'translate(2 1)', stroke: current.text, 'stroke-width': 2, fill: 'none' })], text };
}

const dottedEntry: LegendEntry = {
  width: 30,
  draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: current.text, 'stroke-width': 2, 'stroke-dasharray': '2 3' })],
  text: 'by synchronous coefficients',
};

const baselineEntry: LegendEntry = {
  width: 30,
  draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: current.muted, 'stroke-width': 1, 'stroke-dasharray': '5 3' })],
  text: 'baseline',
};

const markEntry: LegendEntry = {
  width: 30,
  draw: (current) => [svg('circle', { cx: 8, cy: 6, r: 3.5, fill: current.text }), svg('circle', { cx: 22, cy: 6, r: 3, fill: current.background, stroke: current.text, 'stroke-width': 1.5 })],
  text: 'filled: grows, hollow: decays',
};

/** Motions of a rotor in a diagram, a line for each, filled marks where it grows. */
class MotionPanel {
  readonly root: HTMLElement;
  private contacts: number;
  private modes: Mode[] = [];
  private onsets: OnsetData[] = [];
  /** What these were read from. */
  private data: GridData | undefined;
  private readonly chart: Chart;
  private readonly panel: Panel;

  constructor(
    private readonly whirls: Whirls,
    private readonly selection: GridSelection,
    private readonly diagram: Diagram,
    private readonly baseline: () => Whirls | undefined,
  ) {
    this.contacts = selection.index(whirls.contacts);
    this.read();
    this.chart = new Chart(
      () => this.description(),
      (width) => Math.max(260, Math.min(0.75 * width, 420)),
      (current) => this.option(current),
      (instance) => followPointer(() => this.chart, instance, () => this.points(), ({ series, index }) => this.choose(series, index)),
    );
    this.panel = new Panel(
      {
        title: diagram.title,
        note: ['Click a point to select its speed and motion.', ...(diagram.note === undefined ? [] : [diagram.note])].join(' '),
        subject: () => this.subject,
        legend: () => this.legend(),
        file: () => fileName(diagram.title, this.contactWord, whirls.label),
        drawing: () => this.chart.drawing,
        csv: () => this.csv(),
      },
      this.chart.root,
    );
    this.root = this.panel.root;
    selection.onChange(() => this.follow());
    this.setCursor();
  }

  private get contactWord(): string {
    return at([...contactKinds], this.contacts);
  }

  private get subject(): string {
    return `${at([...contactTexts], this.contacts)} · ${this.whirls.label}`;
  }

  private read(): void {
    this.data = this.whirls.data;
    this.modes = this.whirls.modes(this.contacts);
    this.onsets = this.whirls.onsets(this.contacts);
  }

  private follow(): void {
    const contacts = this.selection.index(this.whirls.contacts);
    if (contacts !== this.contacts || this.data !== this.whirls.data) {
      this.contacts = contacts;
      this.read();
      this.panel.refresh();
      this.chart.fit();
    }
    this.setCursor();
  }

  private pointAt(place: Place, whirls = this.whirls): Point {
    return [this.diagram.across.value(whirls, place), this.diagram.upwards.value(whirls, place)];
  }

  /** The motions of the run that this one is compared with. */
  private get ghosts(): Guide[] {
    const whirls = this.baseline();
    return whirls ? whirls.modes(this.contacts).map(({ places }) => ({ points: places.map((place) => this.pointAt(place, whirls)), line: 'dashed' })) : [];
  }

  private setCursor(): void {
    const [x, y] = this.pointAt(this.selection.place);
    this.chart.setCursors(Number.isFinite(y) ? [{ name: 'point', grid: 0, x, y }] : []);
  }

  /** Of all series; guides have none to point at. */
  private points(): Point[][] {
    return [...this.modes.map(({ places }) => places.map((place) => this.pointAt(place))), this.onsets.map(this.diagram.onsetAt)];
  }

  private legend(): LegendEntry[] {
    const full = this.onsets.some((onset) => !onset.by_coefficients);
    const byCoefficients = this.onsets.some((onset) => onset.by_coefficients);
    return [
      ...this.modes.map(({ motion, text }) => lineEntry(lookOf(motion), text)),
      markEntry,
      ...this.diagram.legend,
      ...(this.baseline() ? [baselineEntry] : []),
      ...(full ? [onsetEntry(onsetMarks.full, 'onset or end of whirl')] : []),
      ...(byCoefficients ? [onsetEntry(onsetMarks.byCoefficients, 'the same by synchronous coefficients')] : []),
    ];
  }

  private description(): string {
    const each = this.modes.slice(0, 8).map(({ text, places }) => {
      const values = places.map((place) => this.diagram.upwards.value(this.whirls, place));
      const ends = [Math.min(...values), Math.max(...values)].map((value) => formatNumber(value));
      const growing = places.filter((place) => this.whirls.growthRateAt(place) > 0).length;
      return `${text} from ${ends[0] ?? ''} to ${ends[1] ?? ''}, growing at ${growing} of ${places.length} speeds`;
    });
    const { upwards, across, title } = this.diagram;
    return `${title}: ${upwards.title()} over ${across.title()}, ${this.subject}: ${each.join('; ')}${this.modes.length > 8 ? '; and more' : ''}`;
  }

  private option(current: Look): Option {
    const { across, upwards, guides, onsetAt } = this.diagram;
    const few = this.whirls.speeds.length <= mostMarks;
    return {
      grid: { left: 66, right: 34, top: 16, bottom: 48 },
      xAxis: axis(current, across.title(), { scale: true }),
      yAxis: axis(current, upwards.title(), { nameGap: 48, scale: upwards.min === undefined, ...(upwards.min === undefined ? {} : { min: upwards.min }) }),
      tooltip: tooltip(current, { triggerOn: 'none', formatter: (tip: { seriesIndex: number; dataIndex: number }) => this.tip(tip.seriesIndex, tip.dataIndex) }),
      series: [
        ...this.modes.map(({ motion, text, places }) => this.modeSeries(motion, text, places, few, current)),
        {
          type: 'line',
          name: 'onsets',
          silent: true,
          z: 4,
          lineStyle: { width: 0 },
          data: this.onsets.map((onset) => ({
            value: onsetAt(onset),
            symbol: `path://${onset.by_coefficients ? onsetMarks.byCoefficients : onsetMarks.full}`,
            symbolSize: 11,
            itemStyle: { color: 'none', borderColor: current.text, borderWidth: 2 },
          })),
        },
        ...[...guides(this.contacts), ...this.ghosts].map(({ points, label, line }) => ({
          type: 'line',
          silent: true,
          symbol: 'none',
          z: 1,
          lineStyle: line === 'dotted' ? { color: current.text, width: 1.8, type: [2, 3] } : { color: current.muted, width: 1, ...(line === 'dashed' ? { type: [5, 3] } : {}) },
          ...(label === undefined ? {} : { endLabel: { show: true, formatter: label, color: current.muted, fontSize: 12, distance: 4 } }),
          data: points.map(([x, y]) => [x, Number.isFinite(y) ? y : null]),
        })),
      ],
    };
  }

  private modeSeries(motion: number, text: string, places: Place[], few: boolean, current: Look): object {
    const { colour, marker, dash } = lookOf(motion);
    return {
      type: 'line',
      name: text,
      silent: true,
      symbol: marker,
      symbolSize: few ? 7 : 4,
      showAllSymbol: true,
      lineStyle: { color: colour(current), width: 1.8, ...(dash ? { type: dash } : {}) },
      data: places.map((place, i) => ({
        value: this.pointAt(place),
        ...(this.diagram.note !== undefined && i === places.length - 1 ? { symbolSize: 11 } : {}),
        itemStyle: { color: this.whirls.growthRateAt(place) > 0 ? colour(current) : current.background, borderColor: colour(current), borderWidth: 1.5 },
      })),
    };
  }

  private tip(series: number, index: number): HTMLElement | string {
    const mode = this.modes[series];
    const place = mode?.places[index];
    if (!mode || !place) {
      const onset = this.onsets[index];
      return onset === undefined ? '' : tooltipBox(onset.begins ? 'Onset' : 'End', [[onset.by_coefficients ? 'by synchronous coefficients' : 'all motions', onsetText(onset)]]);
    }
    const { whirls } = this;
    return tooltipBox(mode.text, [
      ['Speed', speedText(at(whirls.speeds, place['speed'] ?? 0))],
      ['Damped frequency', `${formatNumber(whirls.frequencyAt(place))} Hz`],
      ['Growth rate', `${formatNumber(whirls.growthRateAt(place))} 1/s`],
      ['Growth per radian', formatNumber(whirls.growthAt(place))],
      ['Whirl', whirls.wordAt('direction', place)],
    ]);
  }

  private choose(series: number, index: number): void {
    const place = this.modes[series]?.places[index];
    if (place) this.selection.show({ place });
  }

  private csv(): string {
    const { whirls } = this;
    return toCsv(
      ['speed_rad_per_s', 'mode', 'contacts', 'real_rad_per_s', 'imag_rad_per_s', 'growth', 'growth_by_coefficients'],
      this.modes.flatMap(({ number, places }) =>
        places.map((place) => [
          whirls.speeds[place['speed'] ?? 0],
          number,
          this.contactWord,
          whirls.growthRateAt(place),
          whirls.numberAt('imag', place),
          whirls.growthAt(place),
          whirls.growthByCoefficientsAt(place),
        ]),
      ),
    );
  }
}

/** Once and half the speed of rotation, in Hz over rpm. */
function multiplesOf(whirls: Whirls): Guide[] {
  const [first, last] = speedRange(whirls);
  return [
    { label: '1×', ratio: 1 },
    { label: '1/2×', ratio: 0.5 },
  ].map(({ label, ratio }) => ({ label, points: [first, last].map((rpm): Point => [rpm, (ratio * rpm) / 60]) }));
}

/** Of a single speed, with some room on both sides. */
function speedRange(whirls: Whirls): Point {
  const sizes = whirls.speeds.map((_, speed) => whirls.revolutionsAt({ speed }));
  const [least, most] = [Math.min(...sizes), Math.max(...sizes)];
  return least < most ? [least, most] : [0.9 * least, 1.1 * most];
}

function frequencyOf({ speed_rad_per_s: speed, whirl_ratio: ratio }: OnsetData): number {
  return (ratio * Math.abs(speed)) / (2 * Math.PI);
}

function revolutionsOf({ speed_rad_per_s: speed }: OnsetData): number {
  return (Math.abs(speed) * 30) / Math.PI;
}

/**
 * Campbell diagram, growth over speed, and root locus, or some of them. They follow the selection, and what takes the place
 * of the run before.
 * @param baseline  the run that it is compared with, if any
 */
export function motionCharts(whirls: Whirls, selection: GridSelection, titles?: DiagramTitle[], baseline: () => Whirls | undefined = () => undefined): HTMLElement[] {
  const speed: MotionAxis = { title: () => (whirls.turnsBack ? 'Speed, from Y to X (rpm)' : 'Speed (rpm)'), value: (of, place) => of.revolutionsAt(place) };
  const frequency: MotionAxis = { title: () => 'Damped frequency (Hz)', value: (of, place) => of.frequencyAt(place), min: 0 };
  const fastest = (): number => Math.max(...[0, 1].flatMap((contacts) => whirls.modes(contacts).flatMap(({ places }) => places.map((place) => whirls.frequencyAt(place)))), 0);
  const diagrams: Diagram[] = [
    { title: 'Campbell diagram', across: speed, upwards: frequency, guides: () => multiplesOf(whirls), onsetAt: (onset) => [revolutionsOf(onset), frequencyOf(onset)], legend: [] },
    {
      title: 'Growth over speed',
      across: speed,
      upwards: { title: () => 'Growth rate / speed of rotation', value: (of, place) => of.growthAt(place) },
      guides: (contacts) => [
        { points: speedRange(whirls).map((end): Point => [end, 0]) },
        { points: whirls.places(contacts).map((place): Point => [whirls.revolutionsAt(place), whirls.growthByCoefficientsAt(place)]), line: 'dotted' },
      ],
      onsetAt: (onset) => [revolutionsOf(onset), 0],
      legend: [dottedEntry],
    },
    {
      title: 'Root locus',
      across: { title: () => 'Growth rate (1/s)', value: (of, place) => of.growthRateAt(place) },
      upwards: frequency,
      guides: () => [{ points: [[0, 0], [0, fastest()]] }],
      onsetAt: (onset) => [0, frequencyOf(onset)],
      legend: [],
      note: 'The mark of the highest speed of each motion is larger.',
    },
  ];
  const chosen = diagrams.filter(({ title }) => titles?.includes(title) ?? true);
  return chosen.map((diagram) => new MotionPanel(whirls, selection, diagram, baseline).root);
}
