import type { Quantity } from '../data/format';
import { columnNameOf, placesOf, type Coordinate, type Grid, type Place } from '../data/grid';
import { largest } from '../data/run';
import { toCsv, type Cell } from '../data/csv';
import { formatNumber, scaleFor } from '../data/units';
import { choice, el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { term } from './glossary';
import { scroller } from '../ui/scroller';

export interface GridColumn {
  /** Of files. */
  key: string;
  /** Of the glossary. */
  name: string;
  label: string;
  unit: string;
  whole: boolean;
  meaning: string;
  /** What 0, 1, ... stand for; none for numbers. */
  words: string[];
  value: (place: Place) => number;
}

/** The column of a variable, if there is one of this name. */
export function columnOf(grid: Grid, name: string, label: string): GridColumn[] {
  const variable = grid.variable(name);
  if (!variable) return [];
  const { key, unit, text, words } = variable;
  return [{ key, name, label, unit, whole: variable.isWhole, meaning: text, words, value: (place) => variable.at(place) }];
}

/** A column in degrees says so in its label: angles take no prefixes. */
export function inDegrees(column: GridColumn): GridColumn {
  return column.unit === 'degree' ? { ...column, unit: '', label: `${column.label} (°)` } : column;
}

export interface GridTableContents {
  title: string;
  label: string;
  coordinates: Coordinate[];
  columns: GridColumn[];
  /** Names of those that are shown at first; all where they are none. */
  main: string[];
}

/** Rows that are shown at once; the others are found by searching. */
const mostRows = 200;

function cellText({ value, whole, words }: GridColumn, place: Place, factor: number): string {
  const number = value(place);
  if (words.length > 0) return words[number]?.replaceAll('_', ' ') ?? '–';
  return whole && Number.isFinite(number) ? String(number) : formatNumber(number * factor);
}

/** As it is searched for: without capitals and typographic signs. */
function plain(text: string): string {
  return text.toLowerCase().replaceAll('−', '-');
}

/** Of the quantities those that tables show at first. */
export function namesOfFirst(quantities: Quantity[]): string[] {
  return quantities.filter(({ first }) => first).map(({ name }) => name);
}

/** The quantities of every point of a grid, to be searched. */
export function gridTable({ title, label, coordinates, columns, main }: GridTableContents): HTMLElement {
  const places = placesOf(coordinates);
  const scales = new Map(columns.map((column) => [column, scaleFor(largest(places.map(column.value)), column.unit)]));
  const head = columns.filter(({ name }) => main.includes(name));
  let shown = head.length > 0 ? head : columns;
  const place = scroller(`Table: ${title}`);
  place.classList.add('points');
  const search = el('input', { type: 'search', placeholder: 'Search rows', 'aria-label': `Search rows: ${title}` });
  const count = el('output', { class: 'count' });
  const textsOf = (place: Place): string[] => [
    ...coordinates.map(({ name, texts }) => texts[place[name] ?? 0] ?? ''),
    ...shown.map((column) => cellText(column, place, scales.get(column)?.factor ?? 1)),
  ];
  const heads = (): HTMLElement[] => [
    ...coordinates.map(({ title: text }) => el('th', { scope: 'col' }, text)),
    ...shown.map((column) => {
      const { unit } = scales.get(column) ?? { unit: '' };
      return el('th', { scope: 'col' }, term(column.name, column.label, column.meaning), ...(unit === '' ? [] : [el('span', { class: 'unit' }, ` ${unit}`)]));
    }),
  ];
  const named = columns.filter(({ words }) => words.length > 0);
  /** By what rows are found: their point, and what is said in words. */
  const soughtIn = (place: Place): string =>
    plain([...coordinates.map(({ name, texts }) => texts[place[name] ?? 0] ?? ''), ...named.map((column) => cellText(column, place, 1))].join(' '));
  const fill = (): void => {
    const words = plain(search.value).split(/\s+/).filter((word) => word !== '');
    const found = places.filter((place) => {
      const text = soughtIn(place);
      const numbers = text.split(/[\s(),]+/);
      // 5 is not meant to find 50.
      return words.every((word) => (Number.isNaN(Number(word)) ? text.includes(word) : numbers.includes(word)));
    });
    const some = found.slice(0, mostRows).map(textsOf);
    count.textContent = `${some.length} of ${places.length} shown${some.length < found.length ? `, ${found.length} found` : ''}`;
    place.replaceChildren(
      el(
        'table',
        { class: 'results' },
        el('thead', {}, el('tr', {}, ...heads())),
        el(
          'tbody',
          {},
          ...some.map((texts) =>
            el('tr', {}, ...texts.map((text, i) => (i < coordinates.length ? el('th', { scope: 'row' }, text) : el('td', {}, text)))),
          ),
        ),
      ),
    );
  };
  search.addEventListener('input', fill);
  const controls: HTMLElement[] = [search, count];
  if (head.length > 0 && head.length < columns.length) {
    const options = [
      { value: head, text: 'Main' },
      { value: columns, text: 'All' },
    ];
    controls.push(
      choice(`Columns: ${title}`, options, head, (chosen) => {
        shown = chosen;
        fill();
      }),
    );
  }
  const panel = new Panel(
    {
      title,
      controls,
      subject: () => label,
      file: () => fileName(title.toLowerCase(), label),
      csv: () => csv(coordinates, columns, places),
    },
    place,
  );
  fill();
  return panel.root;
}

function csv(coordinates: Coordinate[], columns: GridColumn[], places: Place[]): string {
  return toCsv(
    [...coordinates.map(columnNameOf), ...columns.map(({ key }) => key)],
    places.map((place): Cell[] => [
      ...coordinates.map(({ name, numbers, texts }) => (numbers ?? texts)[place[name] ?? 0]),
      ...columns.map(({ value, words }) => (words.length > 0 ? words[value(place)] : value(place))),
    ]),
  );
}
