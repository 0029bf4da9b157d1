import { toCsv } from '../data/csv';
import type { Place } from '../data/grid';
import { periodic, responseKinds, sliding, stuck, unwrapped, type Responses } from '../data/responses';
import { at, largest } from '../data/run';
import { speedText } from '../data/states';
import { axisTitle, formatNumber, formatQuantity, scaleFor, type Scale } from '../data/units';
import { svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, Chart, roundAbove, tooltip, tooltipBox, type Option, type Point } from './chart';
import { followPointer } from './nearest';

/** Points over the speeds, the slowest first. */
interface ResponseLine {
  text: string;
  /** Among the colours. */
  colour: number;
  /** Lengths of dashes and gaps; none of a solid line. */
  dash?: number[];
  /** Marks without a line between them. */
  marks?: boolean;
  /** Whether the mark of a place is filled; all are without it. */
  filled?: (place: Place) => boolean;
  points: Point[];
  rows: (place: Place) => [string, string][];
}

/** A line that is of no response. */
interface ResponseGuide {
  points: Point[];
  label?: string;
}

/** What a chart shows of responses at a station. */
interface ResponseDiagram {
  title: string;
  /** Also in words: what there is to see. */
  subject: (station: number) => string;
  note: string;
  across: string;
  upwards: (scale: Scale) => string;
  unit: string;
  lines: (station: number) => ResponseLine[];
  guides: (points: Point[]) => ResponseGuide[];
  /** In true shape about the middle, without axes. */
  round?: boolean;
  fromZero?: boolean;
  legend: (lines: ResponseLine[]) => LegendEntry[];
  csv: (station: number) => string;
}

/** Beyond so many speeds marks are small. */
const mostMarks = 40;
/** Parts of a circle that a guide is drawn in. */
const arcs = 72;

function entryOf({ colour, dash, marks, text }: ResponseLine): LegendEntry {
  const colourOf = (current: Look): string => at(current.series, colour);
  return {
    width: 30,
    draw: (current) =>
      marks
        ? [svg('circle', { cx: 8, cy: 6, r: 3.5, fill: colourOf(current) }), svg('circle', { cx: 22, cy: 6, r: 3.5, fill: colourOf(current) })]
        : [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: colourOf(current), 'stroke-width': 2, ...(dash ? { 'stroke-dasharray': dash.join(' ') } : {}) })],
    text,
  };
}

const lastingEntry: LegendEntry = {
  width: 30,
  draw: (current) => [svg('circle', { cx: 8, cy: 6, r: 3.5, fill: current.text }), svg('circle', { cx: 22, cy: 6, r: 3, fill: current.background, stroke: current.text, 'stroke-width': 1.5 })],
  text: 'filled: the orbit lasts, hollow: it does not',
};

/** Responses of a rotor to unbalance in a diagram, at the station chosen. */
class ResponsePanel {
  readonly root: HTMLElement;
  private lines: ResponseLine[] = [];
  private station: number;
  private readonly chart: Chart;
  private readonly panel: Panel;

  constructor(
    private readonly responses: Responses,
    private readonly selection: GridSelection,
    private readonly diagram: ResponseDiagram,
  ) {
    this.station = selection.index(responses.station);
    this.lines = diagram.lines(this.station);
    this.chart = new Chart(
      () => this.description(),
      (width) => this.height(width),
      (current, width) => this.option(current, width),
      (instance) => followPointer(() => this.chart, instance, () => this.points(), ({ index }) => this.choose(index)),
    );
    this.panel = new Panel(
      {
        title: diagram.title,
        note: diagram.note,
        subject: () => `${diagram.subject(this.station)} · ${responses.label}`,
        legend: () => diagram.legend(this.lines),
        file: () => fileName(diagram.title, responses.stations[this.station] ?? '', responses.label),
        drawing: () => this.chart.drawing,
        csv: () => diagram.csv(this.station),
      },
      this.chart.root,
    );
    this.root = this.panel.root;
    selection.onChange(() => this.follow());
    this.setCursor();
  }

  private height(width: number): number {
    return Math.max(260, Math.min((this.diagram.round ? 0.85 : 0.75) * width, 420));
  }

  private follow(): void {
    const station = this.selection.index(this.responses.station);
    if (station !== this.station) {
      this.station = station;
      this.lines = this.diagram.lines(station);
      this.panel.refresh();
      this.chart.fit();
    }
    this.setCursor();
  }

  private get scale(): Scale {
    return scaleFor(largest(this.lines.flatMap(({ points }) => points.map(([x, y]) => (this.diagram.round ? Math.hypot(x, y) : y)))), this.diagram.unit);
  }

  /** As axes have them. */
  private points(): Point[][] {
    const { factor } = this.scale;
    return this.lines.map(({ points }) => points.map(([x, y]): Point => [this.diagram.round ? x * factor : x, y * factor]));
  }

  private setCursor(): void {
    const index = this.responses.places.findIndex(({ speed }) => speed === this.selection.index(this.responses.speed));
    const marks = this.points().flatMap((points) => {
      const [x, y] = points[index] ?? [NaN, NaN];
      return Number.isFinite(y) ? [{ name: 'point', grid: 0, x, y }] : [];
    });
    this.chart.setCursors(marks);
  }

  private description(): string {
    const each = this.lines.map(({ text, points }) => {
      const values = points.map(([x, y]) => (this.diagram.round ? Math.hypot(x, y) : y)).filter(Number.isFinite);
      const ends = [Math.min(...values), Math.max(...values)].map((value) => (this.diagram.unit === '' || this.diagram.unit === '°' ? formatNumber(value) : formatQuantity(value, this.diagram.unit)));
      return values.length === 0 ? `${text}: not known` : `${text} from ${ends[0] ?? ''} to ${ends[1] ?? ''}`;
    });
    return `${this.diagram.title}, ${this.diagram.subject(this.station)}: ${each.join('; ')}`;
  }

  private option(current: Look, width: number): Option {
    const { diagram, scale } = this;
    const points = this.points();
    const guides = diagram.guides(points.flat());
    const few = this.responses.speeds.length <= mostMarks;
    return {
      ...this.axes(current, width, guides),
      tooltip: tooltip(current, { triggerOn: 'none', formatter: (tip: { seriesIndex: number; dataIndex: number }) => this.tip(tip.seriesIndex, tip.dataIndex) }),
      series: [
        ...this.lines.map((line, i) => this.series(line, at(points, i), few, current)),
        ...guides.map(({ points: guide, label }) => ({
          type: 'line',
          silent: true,
          symbol: 'none',
          z: 1,
          lineStyle: { color: diagram.round ? current.line : current.muted, width: diagram.round ? 0.7 : 1 },
          ...(label === undefined ? {} : { endLabel: { show: true, formatter: label, color: current.muted, fontSize: 12, distance: 4 } }),
          data: guide,
        })),
      ],
      ...(diagram.round ? { title: { text: axisTitle('Amplitude', scale), right: 8, bottom: 4, textStyle: { color: current.muted, fontSize: 12, fontWeight: 'normal' } } } : {}),
    };
  }

  private axes(current: Look, width: number, guides: ResponseGuide[]): Option {
    const { diagram } = this;
    if (!diagram.round) {
      return {
        grid: { left: 66, right: 34, top: 16, bottom: 48 },
        xAxis: axis(current, diagram.across, { scale: true }),
        yAxis: axis(current, diagram.upwards(this.scale), { nameGap: 48, scale: !diagram.fromZero }),
      };
    }
    const height = this.height(width);
    const reach = 1.16 * Math.max(...guides.flatMap(({ points }) => points.map(([x, y]) => Math.hypot(x, y))));
    const side = Math.min(width, height);
    const bare = { axisLine: { show: false }, axisTick: { show: false }, axisLabel: { show: false }, splitLine: { show: false } };
    return {
      grid: { left: 0, right: 0, top: 0, bottom: 0 },
      xAxis: axis(current, '', { ...bare, min: (-reach * width) / side, max: (reach * width) / side }),
      yAxis: axis(current, '', { ...bare, min: (-reach * height) / side, max: (reach * height) / side }),
    };
  }

  private series({ text, colour, dash, marks, filled }: ResponseLine, points: Point[], few: boolean, current: Look): object {
    const shade = at(current.series, colour);
    const last = points.length - 1;
    const size = few ? 7 : 4;
    return {
      type: 'line',
      name: text,
      silent: true,
      symbol: 'circle',
      symbolSize: size,
      showSymbol: marks === true || this.diagram.round === true || points.length === 1,
      showAllSymbol: true,
      lineStyle: marks ? { width: 0 } : { color: shade, width: 1.8, ...(dash ? { type: dash } : {}) },
      data: points.map(([x, y], i) => ({
        value: [x, Number.isFinite(y) ? y : null],
        // Where the speed is on no axis.
        symbolSize: this.diagram.round ? (i === last ? 11 : marks ? size : 3) : size,
        itemStyle: { color: !filled || filled(at(this.responses.places, i)) ? shade : current.background, borderColor: shade, borderWidth: 1.5 },
      })),
    };
  }

  private tip(series: number, index: number): HTMLElement | string {
    const line = this.lines[series];
    const place = this.responses.places[index];
    if (!line || !place) return '';
    return tooltipBox(line.text, [['Speed', speedText(at(this.responses.speeds, place['speed'] ?? 0))], ...line.rows(place)]);
  }

  private choose(index: number): void {
    const place = this.responses.places[index];
    if (place) this.selection.show({ place });
  }
}

/** Both axes, for each kind: small orbits as lines, periodic ones as marks. */
function linesOf(responses: Responses, station: number, points: (axis: 'x' | 'y', kind: number) => Point[]): ResponseLine[] {
  const looks: Record<number, Partial<ResponseLine>> = { [stuck]: {}, [sliding]: { dash: [7, 3] }, [periodic]: { marks: true, filled: (place: Place) => responses.lastingAt(place) !== 'does not last' } };
  return [stuck, sliding, periodic].flatMap((kind) =>
    !responses.kinds.includes(kind)
      ? []
      : (['x', 'y'] as const).map((axis, colour) => ({
          ...looks[kind],
          text: `${axis.toUpperCase()}, ${at(responseKinds, kind)}`,
          colour,
          points: points(axis, kind),
          rows: (place: Place): [string, string][] => {
            const there = { ...place, kind, station };
            const lasting = kind === periodic ? responses.lastingAt(place) : '';
            return [
              ['Amplitude', formatQuantity(responses.numberAt(`amplitude_${axis}`, there), 'm')],
              ['Phase', `${formatNumber(responses.numberAt(`phase_${axis}`, there))}°`],
              ...(lasting === '' ? [] : [['Orbit', lasting] as [string, string]]),
            ];
          },
        })),
  );
}

function phasesOf(responses: Responses, axis: 'x' | 'y', kind: number, station: number): number[] {
  return responses.places.map((place) => responses.numberAt(`phase_${axis}`, { ...place, kind, station }));
}

/** Those of periodic orbits and of sliding contacts are next to those of stuck ones. */
function unwrappedPhases(responses: Responses, axis: 'x' | 'y', kind: number, station: number): number[] {
  const reference = unwrapped(phasesOf(responses, axis, stuck, station), 0);
  const own = phasesOf(responses, axis, kind, station);
  const first = own.findIndex(Number.isFinite);
  return unwrapped(own, reference[first] ?? 0);
}

function csvOf(responses: Responses, station: number): string {
  const names = ['amplitude_x', 'phase_x', 'amplitude_y', 'phase_y'];
  return toCsv(
    ['speed_rad_per_s', 'station', 'kind', ...names.map((name) => responses.variable(name)?.key ?? name)],
    responses.kinds.flatMap((kind) =>
      responses.places.map((place) => [
        responses.speeds[place['speed'] ?? 0],
        responses.stations[station],
        responses.variable('kind')?.words[kind],
        ...names.map((name) => responses.numberAt(name, { ...place, kind, station })),
      ]),
    ),
  );
}

/** Circles at round amplitudes, and rays every 30 degrees, with the phase at their ends. */
function polarGuides(points: Point[]): ResponseGuide[] {
  const reach = roundAbove(Math.max(...points.map(([x, y]) => Math.hypot(x, y)).filter(Number.isFinite), 0));
  const circles = [0.5, 1].map((part) => ({
    points: Array.from({ length: arcs + 1 }, (_, i): Point => {
      // It ends, and is named, between two rays.
      const angle = (2 * Math.PI * i) / arcs + Math.PI / 12;
      return [part * reach * Math.cos(angle), part * reach * Math.sin(angle)];
    }),
    label: formatNumber(part * reach, 2),
  }));
  const rays = Array.from({ length: 12 }, (_, i) => {
    const angle = (i * Math.PI) / 6;
    return { points: [[0, 0], [reach * Math.cos(angle), reach * Math.sin(angle)]] as Point[], ...(i % 3 === 0 ? { label: `${i > 6 ? '−' : ''}${i > 6 ? 360 - 30 * i : 30 * i}°` } : {}) };
  });
  return [...circles, ...rays];
}

/** Amplitude and phase over speed, the polar plot, and Floquet multipliers where there are periodic orbits. */
export function responseCharts(responses: Responses, selection: GridSelection): HTMLElement[] {
  const across = responses.turnsBack ? 'Speed, from Y to X (rpm)' : 'Speed (rpm)';
  const subject = (station: number): string => `${responses.stations[station] ?? ''}, at the rotation frequency`;
  const rpm = responses.places.map((place) => responses.revolutionsAt(place));
  const legend = (lines: ResponseLine[]): LegendEntry[] => [...lines.map(entryOf), ...(responses.hasOrbits ? [lastingEntry] : [])];
  const common = { subject, across, note: 'Click a point to select its speed.', legend, csv: (station: number) => csvOf(responses, station) };
  const over = (values: number[]): Point[] => values.map((value, i) => [rpm[i] ?? NaN, value]);
  const diagrams: ResponseDiagram[] = [
    {
      ...common,
      title: 'Bode plot: amplitude',
      upwards: (scale) => axisTitle('Amplitude', scale),
      unit: 'm',
      fromZero: true,
      lines: (station) => linesOf(responses, station, (axis, kind) => over(responses.places.map((place) => responses.numberAt(`amplitude_${axis}`, { ...place, kind, station })))),
      guides: () => [],
    },
    {
      ...common,
      title: 'Bode plot: phase',
      note: 'Of X and Y ahead of an unbalance of phase 0, which lies along +X at t = 0; negative phases lag.',
      upwards: () => 'Phase (°)',
      unit: '°',
      lines: (station) => linesOf(responses, station, (axis, kind) => over(unwrappedPhases(responses, axis, kind, station))),
      guides: () => [],
    },
    {
      ...common,
      title: 'Polar plot',
      note: 'Amplitude from the centre, phase counterclockwise from the right. The mark of the highest speed is larger.',
      upwards: () => '',
      unit: 'm',
      round: true,
      lines: (station) =>
        linesOf(responses, station, (axis, kind) =>
          responses.places.map((place): Point => {
            const there = { ...place, kind, station };
            const [amplitude, phase] = [responses.numberAt(`amplitude_${axis}`, there), (responses.numberAt(`phase_${axis}`, there) * Math.PI) / 180];
            return [amplitude * Math.cos(phase), amplitude * Math.sin(phase)];
          }),
        ),
      guides: polarGuides,
    },
  ];
  if (responses.hasOrbits) diagrams.push(multiplierDiagram(responses, across, over));
  return diagrams.map((diagram) => new ResponsePanel(responses, selection, diagram).root);
}

/** Whether orbits last. */
function multiplierDiagram(responses: Responses, across: string, over: (values: number[]) => Point[]): ResponseDiagram {
  const multipliers = responses.places.map((place) => responses.numberAt('largest_multiplier', place));
  const verdicts = responses.places.map((place) => responses.lastingAt(place)).filter((text) => text !== '');
  const lasting = verdicts.filter((text) => text === 'lasts').length;
  const rpm = responses.places.map((place) => responses.revolutionsAt(place));
  return {
    title: 'Floquet multipliers',
    subject: () => `${lasting} of ${verdicts.length} periodic orbits last`,
    note: 'The largest multiplier found by the search: below 1 the rotor stays on the orbit, above 1 it leaves it and whirls.',
    across,
    upwards: () => 'Largest Floquet multiplier',
    unit: '',
    lines: () => [
      {
        text: 'largest Floquet multiplier',
        colour: 0,
        points: over(multipliers),
        marks: true,
        filled: (place) => responses.lastingAt(place) !== 'does not last',
        rows: (place) => [
          ['Largest multiplier', formatNumber(responses.numberAt('largest_multiplier', place))],
          ['Orbit', responses.lastingAt(place) || 'not known'],
        ],
      },
    ],
    guides: () => [{ points: [[Math.min(...rpm), 1], [Math.max(...rpm), 1]], label: '1' }],
    legend: () => [lastingEntry],
    csv: () =>
      toCsv(
        ['speed_rad_per_s', 'largest_multiplier', 'lasts'],
        responses.places.map((place, i) => [responses.speeds[place['speed'] ?? 0], multipliers[i], responses.lastingAt(place)]),
      ),
  };
}
