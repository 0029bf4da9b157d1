import { percentiles, type Ensemble } from '../data/ensemble';
import type { Quantity, YieldData } from '../data/format';
import { at, capital, largest } from '../data/run';
import { toCsv, type Cell } from '../data/csv';
import { formatNumber, scaleFor } from '../data/units';
import { el, svg } from '../ui/dom';
import type { EnsembleSelection } from '../ui/ensemble_selection';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { term } from './glossary';
import { scroller } from '../ui/scroller';

const columns = [
  { key: 'mean', text: 'mean' },
  { key: 'standard_error', text: 'its error' },
  { key: 'std', text: 'std' },
  ...percentiles.map((percent) => ({ key: `p${percent}`, text: `${percent} %` })),
];

function numberOf(ensemble: Ensemble, quantity: Quantity, direction: number, key: string): number {
  const value = ensemble.statistics(quantity, direction)?.[key];
  return typeof value === 'number' ? value : NaN;
}

function row(ensemble: Ensemble, quantity: Quantity, direction: number): HTMLElement {
  const numbers = columns.map(({ key }) => numberOf(ensemble, quantity, direction, key));
  const scale = scaleFor(largest(numbers), quantity.unit);
  const undefinedCount = ensemble.statistics(quantity, direction)?.undefined ?? 0;
  return el(
    'tr',
    { 'data-key': quantity.key },
    el('th', { scope: 'row' }, term(quantity.name, quantity.label, quantity.meaning)),
    el('td', { class: 'unit' }, numbers.some(Number.isFinite) ? scale.unit : ''),
    ...numbers.map((number) => el('td', {}, formatNumber(number * scale.factor))),
    el('td', {}, String(undefinedCount)),
  );
}

/** Mean, scatter and percentiles of every quantity in the direction, or state, that is looked at. */
export function statisticsTable(ensemble: Ensemble, selection: EnsembleSelection): HTMLElement {
  const place = scroller('Table of statistics');
  const direction = (): string => at(ensemble.directions, selection.direction);
  const panel = new Panel(
    {
      title: 'Statistics of the bearings',
      subject: () => `${direction()} · ${ensemble.label} · of the bearings that converged; percentiles count a quantity that is not reached as largest`,
      file: () => fileName('statistics', ensemble.label),
      csv: () => csv(ensemble),
    },
    place,
  );
  const fill = (): void => {
    panel.refresh();
    place.replaceChildren(
      el(
        'table',
        { class: 'results' },
        el(
          'thead',
          {},
          el('tr', {}, ...['Quantity', 'Unit', ...columns.map(({ text }) => text), 'not defined'].map((text, i) => el('th', i === 1 ? { scope: 'col', class: 'unit' } : { scope: 'col' }, text))),
        ),
        el('tbody', {}, ...ensemble.quantities.map((quantity) => row(ensemble, quantity, selection.direction))),
      ),
    );
  };
  selection.onChange(fill);
  fill();
  return panel.root;
}

/** Mean of the main quantities in large letters, and between which values nine of ten bearings lie. */
export function statisticTiles(ensemble: Ensemble, selection: EnsembleSelection, quantities: Quantity[]): HTMLElement {
  const root = el('div', { class: 'tiles' });
  const fill = (): void =>
    root.replaceChildren(
      ...quantities.map((quantity) => {
        const [mean = NaN, low = NaN, high = NaN] = ['mean', 'p5', 'p95'].map((key) => numberOf(ensemble, quantity, selection.direction, key));
        const { factor, unit } = scaleFor(Math.abs(mean), quantity.unit);
        return el(
          'div',
          { class: 'tile', 'data-key': quantity.key, title: quantity.meaning },
          el('span', { class: 'what' }, `${quantity.label}, mean`),
          el('strong', {}, `${formatNumber(mean * factor)} ${unit}`.trimEnd()),
          el('span', { class: 'change' }, `90 % from ${formatNumber(low * factor)} to ${formatNumber(high * factor)}`),
        );
      }),
    );
  selection.onChange(fill);
  fill();
  return root;
}

function csv(ensemble: Ensemble): string {
  return toCsv(
    ['quantity', 'label', 'unit', ensemble.placeColumn.name, 'count', 'undefined', ...columns.map(({ key }) => key)],
    ensemble.placeColumn.cells.flatMap((place, direction) =>
      ensemble.quantities.map((quantity): Cell[] => {
        const { count, undefined: missing } = ensemble.statistics(quantity, direction) ?? { count: 0, undefined: 0 };
        return [quantity.key, capital(quantity.label), quantity.unit, place, count, missing, ...columns.map(({ key }) => numberOf(ensemble, quantity, direction, key))];
      }),
    ),
  );
}

function percent(part: number): string {
  return `${formatNumber(100 * part, 3)} %`;
}

/** The part that passes as a bar, and its interval as a line across its end. */
function yieldBar({ passed, samples, interval_95: [low = 0, high = 1] }: YieldData): SVGElement {
  const x = (part: number): number => 1 + 158 * part;
  const end = x(samples > 0 ? passed / samples : 0);
  return svg(
    'svg',
    { class: 'yield', width: 160, height: 14, viewBox: '0 0 160 14', 'aria-hidden': 'true' },
    svg('rect', { class: 'whole', x: 1, y: 2, width: 158, height: 10 }),
    svg('rect', { class: 'part-of-it', x: 1, y: 2, width: end - 1, height: 10 }),
    svg('path', { class: 'interval', d: `M${x(low)} 4V10M${x(low)} 7H${x(high)}M${x(high)} 4V10` }),
  );
}

/** How many bearings meet each of the given limits, and all of them together; nothing where there are none. */
export function yieldTable(ensemble: Ensemble): HTMLElement[] {
  const { limits, yield: all } = ensemble.data.summary;
  if (!all) return [];
  const everywhere = ensemble.directions.length > 1 ? ` in every ${ensemble.placeWord.toLowerCase()}` : '';
  const rows = [...limits.map((one) => ({ text: one.limit, ...one })), ...(limits.length > 1 ? [{ text: 'all together', ...all }] : [])];
  const panel = new Panel(
    {
      title: 'Yield',
      subject: () => `Bearings that meet the limits${everywhere}, with the 95 % interval · ${ensemble.label}`,
      file: () => fileName('yield', ensemble.label),
      csv: () => toCsv(['limit', 'passed', 'samples', 'low', 'high'], rows.map(({ text, passed, samples, interval_95: [low, high] }) => [text, passed, samples, low, high])),
    },
    scroller(
      'Table of yields',
      el(
        'table',
        { class: 'results' },
        el('thead', {}, el('tr', {}, ...['Limit', 'pass', 'of', 'yield', '95 % interval', ''].map((text) => (text === '' ? el('td', {}) : el('th', { scope: 'col' }, text))))),
        el(
          'tbody',
          {},
          ...rows.map((one) =>
            el(
              'tr',
              {},
              el('th', { scope: 'row' }, one.text),
              el('td', {}, String(one.passed)),
              el('td', {}, String(one.samples)),
              el('td', {}, one.samples > 0 ? percent(one.passed / one.samples) : '–'),
              el('td', {}, one.interval_95.map(percent).join(' to ')),
              el('td', {}, yieldBar(one)),
            ),
          ),
        ),
      ),
    ),
  );
  return [panel.root];
}
