/** Spectra of a rotor in time, one above the other, as a map. */
import { bandsOf, isMonotonous, type Band } from '../data/bands';
import { toCsv } from '../data/csv';
import { numbersOf } from '../data/grid';
import { at, largest } from '../data/run';
import { speedText } from '../data/states';
import type { TimeRun } from '../data/time_run';
import { axisTitle, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { choice, svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import { fileName } from '../ui/save';
import { intensityColour, type Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option, type RenderApi } from './chart';
import { ChartPanel } from './chart_panel';

type Across = 'order' | 'frequency';
type Up = 'speed' | 'revolution';
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

export function waterfall(run: TimeRun, selection: GridSelection): HTMLElement {
  const orders = numbersOf(run, 'order');
  const speeds = numbersOf(run, 'spectrum_speed').map(Math.abs);
  const numbers = numbersOf(run, 'spectrum');
  const length = run.spectrumLength;
  const amplitudes = run.variable('spectrum_amplitude');
  const overSpeed = isMonotonous(speeds);
  let [across, up, shades, axisShown]: [Across, Up, Shades, number] = ['order', overSpeed ? 'speed' : 'revolution', 'linear', 0];
  const station = (): number => selection.index(run.station);
  const amplitude = (spectrum: number, order: number): number => amplitudes?.at({ spectrum, station: station(), axis: axisShown, order }) ?? NaN;
  /** Of spectra from the bottom to the top. */
  const heights = (): { spectrum: number; band: Band }[] => {
    const rpm = scaleFor(1, 'rpm').factor;
    // The middle of its revolutions.
    const places = up === 'speed' ? speeds.map((speed) => speed * rpm) : numbers.map((number) => (number - 0.5) * length + 0.5);
    const order = [...places.keys()].sort((a, b) => at(places, a) - at(places, b));
    const bands = places.length === 1 && up === 'revolution' ? [[0.5, length + 0.5] as Band] : bandsOf(order.map((i) => at(places, i)));
    return order.map((spectrum, i) => ({ spectrum, band: at(bands, i) }));
  };
  const found = new Map<string, number>();
  const most = (): number => {
    const key = `${station()} ${axisShown}`;
    const known = found.get(key) ?? largest(speeds.flatMap((_, spectrum) => orders.map((__, order) => amplitude(spectrum, order))));
    found.set(key, known);
    return known;
  };
  const end = (): number => {
    const limit = smallPart * most();
    const last = orders.reduce((before, order, i) => (speeds.some((_, spectrum) => amplitude(spectrum, i) > limit) ? order : before), 0);
    return Math.min(at(orders, orders.length - 1), Math.max(leastEnd, Math.ceil(2 * last) / 2 + 0.5));
  };
  const hertz = (spectrum: number): number => at(speeds, spectrum) / (2 * Math.PI);
  const right = (): number => (across === 'order' ? end() : end() * Math.max(...speeds.map((_, i) => hertz(i))));
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
    const [bottom, top] = [at(all, 0).band[0], at(all, all.length - 1).band[1]];
    const edge = right();
    const hidden = { showMinLabel: false, showMaxLabel: false };
    const label = { color: current.muted, fontSize: 12, hideOverlap: true, formatter: (x: number) => String(Number(x.toPrecision(6))) };
    return {
      grid: { left: 66, right: 24, top: 26, bottom: 48 },
      xAxis: axis(current, across === 'order' ? 'Order: frequency / speed' : 'Frequency (Hz)', { min: 0, max: edge, splitLine: { show: false }, axisLabel: { ...label, showMaxLabel: false } }),
      yAxis: axis(current, up === 'speed' ? axisTitle(run.speed.title, { factor: 1, unit: 'rpm' }) : 'Revolution', { nameGap: 50, min: bottom, max: top, splitLine: { show: false }, axisLabel: { ...label, ...hidden } }),
      tooltip: tooltip(current, {
        trigger: 'item',
        formatter: () => {
          const cell = under();
          if (!cell) return '';
          const { spectrum, order } = cell;
          const first = (at(numbers, spectrum) - 1) * length + 1;
          return tooltipBox(formatQuantity(amplitude(spectrum, order), 'm'), [
            ['Order', formatNumber(at(orders, order), 3)],
            ['Frequency', formatQuantity(at(orders, order) * at(speeds, spectrum), 'rad/s')],
            ['Speed', speedText(at(speeds, spectrum))],
            ['Revolutions', length > 1 ? `${first} to ${first + length - 1}` : String(first)],
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
  const where = (): string => [run.station.texts.length > 1 ? (run.station.texts[station()] ?? '') : '', `along ${axes[axisShown] ?? ''}`].filter((text) => text !== '').join(', ');
  const refresh = (): void => panel.refresh();
  const pick = <T,>(name: string, options: [T, string][], chosen: T, choose: (value: T) => void): HTMLElement =>
    choice(name, options.map(([value, text]) => ({ value, text })), chosen, (value) => {
      choose(value);
      refresh();
    });
  const panel = new ChartPanel({
    title: 'Waterfall',
    note: 'Amplitude of sine waves at each frequency. Click a spectrum to see the orbit in its middle.',
    controls: [
      pick<number>('Direction of the spectra', [[0, 'X'], [1, 'Y']], axisShown, (value) => (axisShown = value)),
      pick<Across>('Axis of the spectra', [['order', 'Order'], ['frequency', 'Frequency']], across, (value) => (across = value)),
      ...(overSpeed ? [pick<Up>('Spectra over', [['speed', 'Over speed'], ['revolution', 'Over revolutions']], up, (value) => (up = value))] : []),
      pick<Shades>('Colours of the spectra', [['linear', 'Linear'], ['logarithmic', 'Log']], shades, (value) => (shades = value)),
    ],
    subject: () => [where(), `${speeds.length} spectra of ${length} ${length === 1 ? 'revolution' : 'revolutions'} each`, `largest ${formatQuantity(most(), 'm')}`, run.label].join(' · '),
    legend: () => [
      { width: 5 * shadesShown, draw: (current) => Array.from({ length: shadesShown }, (_, i) => svg('rect', { x: 5 * i, y: 1, width: 5.5, height: 10, fill: intensityColour(current, i / (shadesShown - 1)) })), text: range() },
    ],
    file: () => fileName('waterfall', run.label, where()),
    description: () => `Waterfall, ${where()}: amplitudes ${range()}`,
    height: (width) => Math.max(260, Math.min(0.75 * width, 460)),
    csv: () =>
      toCsv(
        ['spectrum', 'speed_rad_per_s', 'order', 'amplitude_m'],
        numbers.flatMap((number, spectrum) => orders.map((order, i) => [number, at(speeds, spectrum), order, amplitude(spectrum, i)])),
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
        if (cell) selection.show({ place: { revolution: run.indexOfRevolution(Math.round((at(numbers, cell.spectrum) - 0.5) * length)) } });
      });
    },
  });
  let drawn = station();
  selection.onChange(() => {
    if (station() === drawn) return;
    drawn = station();
    refresh();
  });
  return panel.root;
}
