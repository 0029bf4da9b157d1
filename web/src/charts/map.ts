/** Maps of a quantity over two keys, with the region in which a limit is met. */
import { toCsv } from '../data/csv';
import { axisScale, columnNameOf, type Coordinate, type Place } from '../data/grid';
import { rangeOf, type Range } from '../data/range';
import { at } from '../data/run';
import { axisTitle, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { dropDown, el, svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import { fileName } from '../ui/save';
import { rampColour, type Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option, type RenderApi } from './chart';
import { ChartPanel } from './chart_panel';
import { colourBar, rangeText } from './colour_bar';
import { bandOf, lineOf, trianglesOf, type Corner } from './contours';
import type { Measure } from './over';
import { roundTicks } from './ticks';

const bands = 12;
/** Room beside and below a map for the titles of its axes, and that of a second line of them, px. */
const [left, right, top, bottom, line] = [66, 20, 14, 48, 16];
/** About as wide is a letter of these, px. */
const letter = 6.4;

/** Round numbers along an axis from end to end; an end close to one of them has none of its own. */
function axisAlong(all: number[], current: Look, title: string, more: object = {}): object {
  const [min, max] = [Math.min(...all), Math.max(...all)];
  const ticks = roundTicks(min, max);
  const [first = min, last = max] = [ticks[0], ticks[ticks.length - 1]];
  const interval = ticks.length > 1 ? (last - first) / (ticks.length - 1) : max - min;
  const isApart = (end: number, tick: number): boolean => end === tick || Math.abs(end - tick) > 0.6 * interval;
  const plain = axis(current, title, { min, max, interval, splitLine: { show: false }, nameTextStyle: { color: current.muted, fontSize: 12, lineHeight: line }, ...more }) as { axisLabel: object };
  return { ...plain, axisLabel: { ...plain.axisLabel, showMinLabel: isApart(min, first), showMaxLabel: isApart(max, last) } };
}

/** What the region is of in which a limit is met. */
export class Limit {
  private quantity: Measure | undefined;
  private least = true;
  private bound = NaN;
  private readonly listeners: (() => void)[] = [];
  readonly root: HTMLElement;

  /**
   * @param sizes  of a quantity, by which its unit is chosen
   * @param first  that is set at first
   */
  constructor(
    measures: Measure[],
    private readonly sizes: (measure: Measure) => number[],
    first?: { measure: Measure; least: boolean; bound: number },
  ) {
    const box = el('input', { type: 'text', inputmode: 'decimal', class: 'number', 'aria-label': 'Limit' });
    const unit = document.createTextNode('');
    const tell = (): void => {
      const { factor, unit: shown } = this.scale;
      unit.data = shown;
      const typed = Number(box.value.replace(',', '.'));
      this.bound = box.value.trim() === '' ? NaN : typed / factor;
      for (const listener of this.listeners) listener();
    };
    const list = dropDown('Feasible where', [{ value: undefined as Measure | undefined, text: 'none' }, ...measures.map((value) => ({ value: value as Measure | undefined, text: value.text }))], (value) => {
      this.quantity = value;
      box.disabled = !value;
      tell();
    });
    const sides = dropDown('Side of the limit', [{ value: true, text: 'at least' }, { value: false, text: 'at most' }], (value) => {
      this.least = value;
      tell();
    });
    box.disabled = !first;
    if (first) {
      this.quantity = first.measure;
      this.least = first.least;
      list.selectedIndex = 1 + measures.indexOf(first.measure);
      sides.selectedIndex = first.least ? 0 : 1;
      box.value = String(Number((first.bound * this.scale.factor).toPrecision(6)));
      tell();
    }
    box.addEventListener('input', tell);
    this.root = el('div', { class: 'tools', role: 'group', 'aria-label': 'Feasible region' }, el('label', { class: 'control' }, 'Feasible where', list), el('span', { class: 'control' }, sides), el('label', { class: 'control' }, box, unit));
  }

  private get scale(): { factor: number; unit: string } {
    return this.quantity ? scaleFor(Math.max(...this.sizes(this.quantity).map(Math.abs)), this.quantity.unit) : { factor: 1, unit: '' };
  }

  get isGiven(): boolean {
    return this.quantity !== undefined && Number.isFinite(this.bound);
  }

  /** By how much a point misses it, in the quantity: positive where it does; NaN where that is not known. */
  shortfallAt(place: Place): number {
    const value = this.quantity ? at(this.quantity.parts, 0).value(place) : NaN;
    return this.least ? this.bound - value : value - this.bound;
  }

  get text(): string {
    return this.isGiven && this.quantity ? `${this.quantity.text} ${this.least ? '≥' : '≤'} ${formatQuantity(this.bound, this.quantity.unit)}` : '';
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }
}

/** @param measures  of which this one is shown at first */
export function mapPanel(measures: Measure[], first: Measure, [across, up]: [Coordinate, Coordinate], selection: GridSelection, limit: Limit, label: string): HTMLElement {
  let measure = first;
  const part = (): Measure['parts'][number] => at(measure.parts, 0);
  const placeOf = (i: number, j: number): Place => ({ ...selection.place, [across.name]: i, [up.name]: j });
  const valuesOf = (of: (place: Place) => number): number[][] => up.texts.map((_, j) => across.texts.map((__, i) => of(placeOf(i, j))));
  const values = (): number[][] => valuesOf((place) => part().value(place));
  const known = (): number[] => values().flat().filter(Number.isFinite);
  const range = (): Range => rangeOf(known());
  // Without the noise of single precision, which would give the ends ticks of their own.
  const numbers = (one: Coordinate): number[] => (one.numbers ?? []).map((number) => Number((number * axisScale(one).factor).toPrecision(6)));
  const caption = (): string => (known().length === 0 ? 'not known' : rangeText(range(), measure.unit));
  const fixed = (): string => selection.textAt(selection.place, across, up);
  const heightOf = (width: number): number => Math.max(230, Math.min(0.72 * width, 420));
  /** A long title has two lines. */
  const titled = (one: Coordinate, size: number): { title: string; more: number } => {
    const title = axisTitle(one.title, axisScale(one));
    return letter * title.length > size ? { title: title.replace(': ', ':\n'), more: line } : { title, more: 0 };
  };
  const option = (current: Look, width: number): Option => {
    const [wide, high] = [titled(across, width - left - right), titled(up, heightOf(width) - top - bottom)];
    const [xs, ys] = [numbers(across), numbers(up)];
    const [least, most] = known().length > 0 ? range() : [0, 1];
    const triangles = trianglesOf(xs, ys, values());
    const shortfalls = trianglesOf(xs, ys, valuesOf((place) => limit.shortfallAt(place)));
    const level = (k: number): number => least + ((most - least) * k) / bands;
    const path = (api: RenderApi, polygons: Corner[][], close: boolean): string =>
      polygons.map((polygon) => `M${polygon.map(({ x, y }) => api.coord([x, y]).map((pixel) => pixel.toFixed(1)).join(' ')).join('L')}${close ? 'Z' : ''}`).join('');
    const drawn = (name: string, data: number[][], style: (k: number) => object, polygons: (k: number) => Corner[][], close: boolean): object => ({
      type: 'custom',
      name,
      silent: true,
      clip: true,
      progressive: 0,
      data,
      encode: { x: 0, y: 1 },
      renderItem: ({ dataIndex }: { dataIndex: number }, api: RenderApi) => ({ type: 'path', shape: { pathData: path(api, polygons(dataIndex), close) || 'M0 0' }, style: style(dataIndex) }),
    });
    const anywhere = [xs[0] ?? 0, ys[0] ?? 0];
    const points = up.texts.flatMap((_, j) => across.texts.map((__, i): [number, number, number, number] => [xs[i] ?? NaN, ys[j] ?? NaN, i, j]));
    return {
      grid: { left: left + high.more, right, top, bottom: bottom + wide.more },
      xAxis: axisAlong(xs, current, wide.title),
      yAxis: axisAlong(ys, current, high.title, { nameGap: 48 }),
      tooltip: tooltip(current, {
        trigger: 'item',
        formatter: ({ dataIndex }: { dataIndex: number }) => {
          const [, , i = 0, j = 0] = points[dataIndex] ?? [];
          const value = part().value(placeOf(i, j));
          return tooltipBox(measure.unit === '' ? formatNumber(value) : formatQuantity(value, measure.unit), [
            [across.title, across.texts[i] ?? ''],
            [up.title, up.texts[j] ?? ''],
          ]);
        },
      }),
      series: [
        drawn('bands', Array.from({ length: bands }, () => anywhere), (k) => ({ fill: rampColour(current, (k + 0.5) / bands), stroke: rampColour(current, (k + 0.5) / bands), lineWidth: 0.5 }), (k) => bandOf(triangles, level(k), level(k + 1)), true),
        drawn('lines', roundTicks(least, most).map(() => anywhere), () => ({ fill: 'none', stroke: current.background, lineWidth: 1.2 }), (k) => lineOf(triangles, roundTicks(least, most)[k] ?? NaN), false),
        ...(limit.isGiven
          ? [
              drawn('infeasible', [anywhere], () => ({ fill: current.background, opacity: 0.72 }), () => bandOf(shortfalls, 0, Infinity), true),
              drawn('limit', [anywhere], () => ({ fill: 'none', stroke: current.text, lineWidth: 2.4 }), () => lineOf(shortfalls, 0), false),
            ]
          : []),
        {
          type: 'custom',
          name: 'points',
          clip: false,
          progressive: 0,
          data: points,
          encode: { x: 0, y: 1 },
          renderItem: ({ dataIndex }: { dataIndex: number }, api: RenderApi) => {
            const [cx, cy] = api.coord([api.value(0), api.value(1)]);
            const [, , i = 0, j = 0] = points[dataIndex] ?? [];
            const looked = selection.place[across.name] === i && selection.place[up.name] === j;
            const found = Number.isFinite(part().value(placeOf(i, j)));
            // A wide ring that is not seen takes the pointer.
            return {
              type: 'group',
              children: [
                { type: 'circle', shape: { cx, cy, r: 9 }, style: { fill: 'transparent', stroke: looked ? current.text : 'transparent', lineWidth: 2.4 } },
                found
                  ? { type: 'circle', shape: { cx, cy, r: 2.2 }, style: { fill: current.background, stroke: current.text, lineWidth: 0.8 } }
                  : { type: 'path', shape: { pathData: `M${cx - 4} ${cy - 4}L${cx + 4} ${cy + 4}M${cx - 4} ${cy + 4}L${cx + 4} ${cy - 4}` }, style: { fill: 'none', stroke: current.friction, lineWidth: 2 } },
              ],
            };
          },
        },
      ],
    };
  };
  const panel = new ChartPanel({
    title: () => `Map of ${measure.text.charAt(0).toLowerCase()}${measure.text.slice(1)}`,
    note: 'Click a point to select it.',
    controls: measures.length > 1 ? [chooser()] : [],
    subject: () => [caption(), limit.text === '' ? '' : `feasible where ${limit.text}`, fixed(), label].filter((text) => text !== '').join(' · '),
    legend: () => [
      ...(known().length > 0 ? [colourBar(range(), measure.unit)] : []),
      ...(known().length < across.texts.length * up.texts.length ? [{ width: 12, draw: (current: Look) => [svg('path', { d: 'M2 2L10 10M2 10L10 2', stroke: current.friction, 'stroke-width': 2 })], text: 'not known' }] : []),
      ...(limit.isGiven ? [{ width: 26, draw: (current: Look) => [svg('path', { d: 'M1 6H25', stroke: current.text, 'stroke-width': 2.4 })], text: `${limit.text}; pale where it is not met` }] : []),
    ],
    file: () => fileName('map', measure.text, label),
    csv: () => toCsv([columnNameOf(across), columnNameOf(up), part().key], up.texts.flatMap((_, j) => across.texts.map((__, i) => [across.numbers?.[i] ?? i, up.numbers?.[j] ?? j, part().value(placeOf(i, j))]))),
    description: () => `${measure.text} over ${across.title} and ${up.title}: ${caption()}; ${fixed()}`,
    height: heightOf,
    option,
    ready: (chart, instance) =>
      instance.getZr().on('click', ({ offsetX, offsetY }) => {
        const [xs, ys] = [numbers(across), numbers(up)];
        const nearest = (all: number[], along: (one: number) => number): number => all.reduce((best, one, i) => (Math.abs(along(one)) < Math.abs(along(all[best] ?? NaN)) ? i : best), 0);
        selection.show({ place: { [across.name]: nearest(xs, (x) => chart.pixel(0, x, ys[0] ?? 0)[0] - offsetX), [up.name]: nearest(ys, (y) => chart.pixel(0, xs[0] ?? 0, y)[1] - offsetY) } });
      }),
  });
  function chooser(): HTMLElement {
    const list = dropDown('Mapped quantity', measures.map((value) => ({ value, text: value.text })), (value) => {
      measure = value;
      panel.refresh();
    });
    list.selectedIndex = measures.indexOf(first);
    return list;
  }
  selection.onChange(() => panel.refresh());
  limit.onChange(() => panel.refresh());
  return panel.root;
}
