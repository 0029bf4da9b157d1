/** Spectra of a rotor in time, one above the other, as a map: of one run, or of the ends of runs over a swept key. */
import { bandsOf, isMonotonous, type Band } from '../data/bands';
import { toCsv } from '../data/csv';
import { axisScale, columnNameOf, numbersOf, type Coordinate, type Grid } from '../data/grid';
import { at, largest } from '../data/run';
import { speedText } from '../data/states';
import type { TimeRun } from '../data/time_run';
import { axisTitle, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { choice, svg } from '../ui/dom';
import { shortTitle, type GridSelection } from '../ui/grid_selection';
import { fileName } from '../ui/save';
import { intensityColour, type Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option, type RenderApi } from './chart';
import { ChartPanel } from './chart_panel';

type Across = 'order' | 'frequency';
type Shades = 'linear' | 'logarithmic';

const axes = ['X', 'Y'] as const;
/** Orders that lines are drawn at. */
const lines: [order: number, text: string][] = [[0.5, '½x'], [1, '1x'], [2, '2x']];
/** Decades below the largest amplitude that logarithmic colours show. */
const decades = 3;
/** The map ends behind the last amplitude that is this part of the largest, yet never before the order below. */
const smallPart = 0.01;
const leastEnd = 2.5;
/** Of the colour bar. */
const shadesShown = 24;
/** Points of the picture to a pixel of the screen. */
const fineness = 2;

/** What a map goes up along. */
interface Up {
  choice: string;
  title: string;
  /** Of each spectrum. */
  places: number[];
  /** Of a single one. */
  band?: Band;
}

interface Spectra {
  note: string;
  label: string;
  orders: number[];
  /** In how many revolutions each is. */
  length: number;
  /** Sizes, rad/s; NaN where there is no spectrum. */
  speeds: () => number[];
  amplitude: (spectrum: number, axis: number, order: number) => number;
  /** One at least, that which is shown first in front. */
  ups: () => Up[];
  /** What it is of besides the axis. */
  where: () => string[];
  /** What tells them apart in files. */
  column: () => { name: string; values: number[] };
  /** Of one, besides its speed. */
  more: (spectrum: number) => [name: string, text: string][];
  show: (spectrum: number) => void;
}

/** Spectra of a run, one after the other. */
export function waterfall(run: TimeRun, selection: GridSelection): HTMLElement {
  const numbers = numbersOf(run, 'spectrum');
  const speeds = numbersOf(run, 'spectrum_speed').map(Math.abs);
  const length = run.spectrumLength;
  const amplitudes = run.variable('spectrum_amplitude');
  const station = (): number => selection.index(run.station);
  const rpm = scaleFor(1, 'rpm').factor;
  const ups: Up[] = [
    ...(isMonotonous(speeds) ? [{ choice: 'Over speed', title: axisTitle(run.speed.title, { factor: 1, unit: 'rpm' }), places: speeds.map((speed) => speed * rpm) }] : []),
    // The middle of its revolutions.
    { choice: 'Over revolutions', title: 'Revolution', places: numbers.map((number) => (number - 0.5) * length + 0.5), band: [0.5, length + 0.5] },
  ];
  const spectra: Spectra = {
    note: 'Amplitude of sine waves at each frequency. Click a spectrum to see the orbit in its middle.',
    label: run.label,
    orders: numbersOf(run, 'order'),
    length,
    speeds: () => speeds,
    amplitude: (spectrum, axis, order) => amplitudes?.at({ spectrum, station: station(), axis, order }) ?? NaN,
    ups: () => ups,
    where: () => (run.station.texts.length > 1 ? [run.station.texts[station()] ?? ''] : []),
    column: () => ({ name: 'spectrum', values: numbers }),
    more: (spectrum) => {
      const first = (at(numbers, spectrum) - 1) * length + 1;
      return [['Revolutions', length > 1 ? `${first} to ${first + length - 1}` : String(first)]];
    },
    show: (spectrum) => selection.show({ place: { revolution: run.indexOfRevolution(Math.round((at(numbers, spectrum) - 0.5) * length)) } }),
  };
  return mapOf(spectra, selection, () => String(station()));
}

/** The last spectrum of each run of a sweep, over the key that charts go along. */
export function sweptWaterfall(grid: Grid, selection: GridSelection): HTMLElement {
  const orders = numbersOf(grid, 'order');
  const amplitudes = grid.variable('last_spectrum_amplitude');
  const speed = grid.variable('last_spectrum_speed');
  const along = (): Coordinate => selection.along;
  const placeOf = (spectrum: number): Record<string, number> => ({ ...selection.place, [along().name]: spectrum });
  const where = (): string[] => [selection.textAt(selection.place, along())].filter((text) => text !== '');
  const spectra: Spectra = {
    note: 'Amplitude of sine waves at each frequency, in the last spectrum of each run. Click a spectrum to select its run.',
    label: grid.label,
    orders,
    length: Math.round(1 / (orders[1] ?? NaN)),
    speeds: () => along().texts.map((_, spectrum) => Math.abs(speed?.at(placeOf(spectrum)) ?? NaN)),
    amplitude: (spectrum, axis, order) => amplitudes?.at({ ...placeOf(spectrum), axis, order }) ?? NaN,
    ups: () => {
      const scale = axisScale(along());
      return [{ choice: '', title: axisTitle(along().title, scale), places: (along().numbers ?? []).map((number) => number * scale.factor) }];
    },
    where,
    column: () => ({ name: columnNameOf(along()), values: along().numbers ?? [] }),
    more: (spectrum) => [[shortTitle(along().title), along().texts[spectrum] ?? '']],
    show: (spectrum) => selection.show({ place: { [along().name]: spectrum } }),
  };
  return mapOf(spectra, selection, () => `${along().name} ${where().join()}`);
}

/** @param shown  tells what is drawn of a selection, besides what the chart's own controls choose */
function mapOf(spectra: Spectra, selection: GridSelection, shown: () => string): HTMLElement {
  const { orders, length, label } = spectra;
  const upNames = spectra.ups().map((one) => one.choice);
  let [across, upChosen, shades, axisShown]: [Across, number, Shades, number] = ['order', 0, 'linear', 0];
  let speeds = spectra.speeds();
  const up = (): Up => at(spectra.ups(), upChosen);
  const amplitude = (spectrum: number, order: number): number => spectra.amplitude(spectrum, axisShown, order);
  const present = (): number[] => [...speeds.keys()].filter((spectrum) => Number.isFinite(speeds[spectrum]));
  /** Of spectra from the bottom to the top. */
  const heights = (): { spectrum: number; band: Band }[] => {
    const { places, band } = up();
    const order = present().sort((a, b) => at(places, a) - at(places, b));
    const bands = order.length === 1 && band ? [band] : bandsOf(order.map((i) => at(places, i)));
    return order.map((spectrum, i) => ({ spectrum, band: at(bands, i) }));
  };
  const found = new Map<string, number>();
  const most = (): number => {
    const key = `${shown()} ${axisShown}`;
    const known = found.get(key) ?? largest(present().flatMap((spectrum) => orders.map((_, order) => amplitude(spectrum, order))));
    found.set(key, known);
    return known;
  };
  const end = (): number => {
    const limit = smallPart * most();
    const last = orders.reduce((before, order, i) => (present().some((spectrum) => amplitude(spectrum, i) > limit) ? order : before), 0);
    return Math.min(at(orders, orders.length - 1), Math.max(leastEnd, Math.ceil(2 * last) / 2 + 0.5));
  };
  const hertz = (spectrum: number): number => at(speeds, spectrum) / (2 * Math.PI);
  const right = (): number => (across === 'order' ? end() : end() * Math.max(...present().map(hertz)));
  const fraction = (value: number, full: number): number => (shades === 'linear' ? value / full : 1 + Math.log10(Math.max(value / full, 1e-12)) / decades);
  const widthAt = (spectrum: number): number => (across === 'order' ? 1 : hertz(spectrum));
  const picture = (current: Look, width: number, height: number): string => {
    const canvas = document.createElement('canvas');
    canvas.width = Math.max(1, Math.round(fineness * width));
    canvas.height = Math.max(1, Math.round(fineness * height));
    const context = canvas.getContext('2d');
    if (!context) return '';
    context.fillStyle = current.background;
    context.fillRect(0, 0, canvas.width, canvas.height);
    const [all, full, edge] = [heights(), most(), right()];
    const [bottom, top] = [at(all, 0).band[0], at(all, all.length - 1).band[1]];
    const cells = bandsOf(orders);
    const x = (place: number): number => (canvas.width * place) / edge;
    const y = (place: number): number => (canvas.height * (top - place)) / (top - bottom);
    for (const { spectrum, band } of all) {
      const [foot, head] = band.map((place) => Math.round(y(place))) as Band;
      cells.forEach(([from, to], order) => {
        const [left, far] = [from, to].map((place) => Math.round(x(place * widthAt(spectrum)))) as Band;
        if (left > canvas.width) return;
        context.fillStyle = intensityColour(current, fraction(amplitude(spectrum, order), full));
        context.fillRect(left, head, Math.max(1, far - left), Math.max(1, foot - head));
      });
    }
    return canvas.toDataURL();
  };
  let pointer: [number, number] = [NaN, NaN];
  const under = (): { spectrum: number; order: number } | undefined => {
    const [x, y] = pointer;
    const row = heights().find(({ band: [from, to] }) => y >= from && y <= to);
    if (!row) return undefined;
    const order = bandsOf(orders).findIndex(([from, to]) => x >= from * widthAt(row.spectrum) && x <= to * widthAt(row.spectrum));
    return order < 0 ? undefined : { spectrum: row.spectrum, order };
  };
  const option = (current: Look): Option => {
    const all = heights();
    if (all.length === 0) return {};
    const [bottom, top] = [at(all, 0).band[0], at(all, all.length - 1).band[1]];
    const edge = right();
    const hidden = { showMinLabel: false, showMaxLabel: false };
    const label = { color: current.muted, fontSize: 12, hideOverlap: true, formatter: (x: number) => String(Number(x.toPrecision(6))) };
    return {
      grid: { left: 66, right: 24, top: 26, bottom: 48 },
      xAxis: axis(current, across === 'order' ? 'Order: frequency / speed' : 'Frequency (Hz)', { min: 0, max: edge, splitLine: { show: false }, axisLabel: { ...label, showMaxLabel: false } }),
      yAxis: axis(current, up().title, { nameGap: 50, min: bottom, max: top, splitLine: { show: false }, axisLabel: { ...label, ...hidden } }),
      tooltip: tooltip(current, {
        trigger: 'item',
        formatter: () => {
          const cell = under();
          if (!cell) return '';
          const { spectrum, order } = cell;
          return tooltipBox(formatQuantity(amplitude(spectrum, order), 'm'), [
            ['Order', formatNumber(at(orders, order), 3)],
            ['Frequency', formatQuantity(at(orders, order) * at(speeds, spectrum), 'rad/s')],
            ['Speed', speedText(at(speeds, spectrum))],
            ...spectra.more(spectrum),
          ]);
        },
      }),
      series: [
        {
          type: 'custom',
          name: 'amplitude',
          clip: true,
          data: [[edge, top]],
          encode: { x: 0, y: 1 },
          renderItem: (_: unknown, api: RenderApi) => {
            const [[x, foot], [far, y]] = [api.coord([0, bottom]), api.coord([edge, top])];
            return { type: 'image', style: { image: picture(current, far - x, foot - y), x, y, width: far - x, height: foot - y } };
          },
        },
        ...lines.map(([order, text]) => ({
          type: 'custom',
          name: text,
          silent: true,
          tooltip: { show: false },
          data: [[0, bottom]],
          renderItem: (_: unknown, api: RenderApi) => {
            const points = all.flatMap(({ spectrum, band }) => band.map((place) => [order * widthAt(spectrum), place] as [number, number]));
            // Straight from end to end: a frequency goes with the speed.
            const ends = across === 'order' ? [at(points, 0), at(points, points.length - 1)] : all.map(({ spectrum, band: [from, to] }) => [order * widthAt(spectrum), 0.5 * (from + to)] as [number, number]);
            const inside = ends.filter(([x]) => x <= edge);
            if (inside.length === 0) return undefined;
            const pixels = inside.map((point) => api.coord(point));
            const [x, y] = at(pixels, pixels.length - 1);
            return {
              type: 'group',
              children: [
                { type: 'polyline', shape: { points: pixels }, style: { stroke: current.text, lineWidth: 1, lineDash: [4, 3], fill: 'none' } },
                { type: 'text', style: { text, x, y: Math.min(y, api.coord([0, top])[1]) - 3, align: 'center', verticalAlign: 'bottom', fill: current.muted, fontSize: 12 } },
              ],
            };
          },
        })),
      ],
    };
  };
  const range = (): string => (shades === 'linear' ? `0 to ${formatQuantity(most(), 'm', 3)}` : `${formatQuantity(most() / 10 ** decades, 'm', 3)} to ${formatQuantity(most(), 'm', 3)}, logarithmic`);
  const where = (): string => [...spectra.where(), `along ${axes[axisShown] ?? ''}`].join(', ');
  const refresh = (): void => panel.refresh();
  const pick = <T,>(name: string, options: [T, string][], chosen: T, choose: (value: T) => void): HTMLElement =>
    choice(name, options.map(([value, text]) => ({ value, text })), chosen, (value) => {
      choose(value);
      refresh();
    });
  const panel = new ChartPanel({
    title: 'Waterfall',
    note: spectra.note,
    controls: [
      pick<number>('Direction of the spectra', [[0, 'X'], [1, 'Y']], axisShown, (value) => (axisShown = value)),
      pick<Across>('Axis of the spectra', [['order', 'Order'], ['frequency', 'Frequency']], across, (value) => (across = value)),
      ...(upNames.length > 1 ? [pick<number>('Spectra over', upNames.map((name, i) => [i, name]), upChosen, (value) => (upChosen = value))] : []),
      pick<Shades>('Colours of the spectra', [['linear', 'Linear'], ['logarithmic', 'Log']], shades, (value) => (shades = value)),
    ],
    subject: () => [where(), `${present().length} spectra of ${length} ${length === 1 ? 'revolution' : 'revolutions'} each`, `largest ${formatQuantity(most(), 'm')}`, label].join(' · '),
    legend: () => [
      { width: 5 * shadesShown, draw: (current) => Array.from({ length: shadesShown }, (_, i) => svg('rect', { x: 5 * i, y: 1, width: 5.5, height: 10, fill: intensityColour(current, i / (shadesShown - 1)) })), text: range() },
    ],
    file: () => fileName('waterfall', label, where()),
    description: () => `Waterfall, ${where()}: amplitudes ${range()}`,
    height: (width) => Math.max(260, Math.min(0.75 * width, 460)),
    csv: () =>
      toCsv(
        [spectra.column().name, 'speed_rad_per_s', 'order', 'amplitude_m'],
        present().flatMap((spectrum) => orders.map((order, i) => [at(spectra.column().values, spectrum), at(speeds, spectrum), order, amplitude(spectrum, i)])),
      ),
    option,
    ready: (_, instance) => {
      const area = instance.getZr();
      const follow = ({ offsetX, offsetY }: { offsetX: number; offsetY: number }): void => {
        pointer = instance.convertFromPixel({ gridIndex: 0 }, [offsetX, offsetY]) as [number, number];
      };
      area.on('mousemove', follow);
      area.on('click', (event) => {
        follow(event);
        const cell = under();
        if (cell) spectra.show(cell.spectrum);
      });
    },
  });
  let drawn = shown();
  selection.onChange(() => {
    if (shown() === drawn) return;
    drawn = shown();
    speeds = spectra.speeds();
    refresh();
  });
  return panel.root;
}
