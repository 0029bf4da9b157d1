import type { CycleSummary, Quantity, StressPlace } from '../data/format';
import { at, capital, largest, type Run } from '../data/run';
import { toCsv, type Cell } from '../data/csv';
import { differences, formatNumber, formatQuantity, scaleFor, type Scale } from '../data/units';
import { afterwards } from '../ui/afterwards';
import type { Comparison } from '../ui/comparison';
import { choice, dropDown, el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { isPrinting, onPrint } from '../ui/theme';
import { term } from './glossary';
import { scroller } from '../ui/scroller';

type Value = CycleSummary[string] | undefined;

interface Column {
  run: Run;
  key: number;
  values: Partial<CycleSummary>;
}

/** A cycle of every run that has it: the reference first. */
function columnsOf(runs: Run[], reference: Run, keys: number[]): Column[] {
  const order = [...runs].sort((a, b) => Number(b === reference) - Number(a === reference));
  return keys.flatMap((key) =>
    order.flatMap((run) => {
      const cycle = run.cycle(key);
      return cycle ? [{ run, key, values: cycle.summary ?? {} }] : [];
    }),
  );
}

export function numberOf(value: Value): number | null {
  return typeof value === 'number' ? value : null;
}

function quantityOf(run: Run, { key }: Quantity): Quantity | undefined {
  return run.quantities.find((one) => one.key === key);
}

/** What the results of the runs have, each once. */
function quantitiesOf(columns: Column[]): Quantity[] {
  const all = new Map<string, Quantity>();
  for (const { run, values } of columns) {
    for (const quantity of run.quantities) {
      if (values[quantity.key] !== undefined) all.set(quantity.key, all.get(quantity.key) ?? quantity);
    }
  }
  return [...all.values()];
}

function valueOf(column: Column, quantity: Quantity): Value {
  return quantityOf(column.run, quantity) ? column.values[quantity.key] : undefined;
}

function placeOf(column: Column, { name }: Quantity): StressPlace | undefined {
  const place = column.values[`${name}_at`];
  return typeof place === 'object' && place !== null && !Array.isArray(place) ? place : undefined;
}

/** "crest of bump 14, increment 100, 79.5 µm" */
export function placeText({ place, bump, pad, increment, displacement_m: displacement }: StressPlace, run: Run): string {
  const weld = pad === undefined ? place : `${place} of pad ${pad}`;
  const where = bump === null ? weld : `${place} of bump ${run.numberOf('bump', bump - 1)}`;
  return `${where}, increment ${increment}, ${formatQuantity(displacement, 'm', 3)}`;
}

function text(value: Value, { whole }: Quantity, scale: Scale): string {
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value === 'string') return value.replaceAll('_', ' ');
  const number = numberOf(value);
  if (number !== null && whole) return String(number);
  return formatNumber(number === null ? null : number * scale.factor);
}

function bodyRow(quantity: Quantity, columns: Column[], reference: Run | undefined): HTMLElement {
  const numbers = columns.map((column) => numberOf(valueOf(column, quantity)));
  const scale = scaleFor(largest(numbers.map((number) => number ?? 0)), quantity.unit);
  const first = at(columns, 0);
  // The reference need not have this cycle.
  const compared = first.run === reference ? numberOf(valueOf(first, quantity)) : null;
  const cells = columns.flatMap((column, i) => {
    const place = placeOf(column, quantity);
    const value = el('td', {}, text(valueOf(column, quantity), quantity, scale), ...(place ? [el('small', { class: 'place' }, placeText(place, column.run))] : []));
    if (!reference || i === 0) return [value];
    return [value, ...differences(at(numbers, i), compared, scale).map((difference) => el('td', { class: 'difference' }, difference))];
  });
  return el(
    'tr',
    { 'data-key': quantity.key },
    el('th', { scope: 'row' }, term(quantity.name, quantity.label, quantity.meaning)),
    el('td', { class: 'unit' }, numbers.some((number) => number !== null) ? scale.unit : ''),
    ...cells,
  );
}

function head(columns: Column[], reference: Run | undefined, name: (key: number) => string): HTMLElement {
  const corner = [el('th', { scope: 'col' }, 'Quantity'), el('th', { scope: 'col', class: 'unit' }, 'Unit')];
  const cells = columns.flatMap(({ run, key }, i) => {
    if (!reference) return [el('th', { scope: 'col' }, name(key))];
    if (i === 0) return [el('th', { scope: 'col', class: 'run' }, run === reference ? `${run.label} (reference)` : run.label)];
    return [
      el('th', { scope: 'col', class: 'run' }, run.label),
      el('th', { scope: 'col', class: 'difference' }, 'difference'),
      el('th', { scope: 'col', class: 'difference' }, 'in %'),
    ];
  });
  return el('thead', {}, el('tr', {}, ...corner, ...cells));
}

function table(columns: Column[], reference: Run | undefined, name: (key: number) => string): HTMLElement {
  const quantities = quantitiesOf(columns);
  const group = (title: string, ofSolver: boolean): HTMLElement =>
    el(
      'tbody',
      {},
      ...(title === '' ? [] : [el('tr', { class: 'group' }, el('th', { scope: 'rowgroup', colspan: 2 + (reference ? 3 * columns.length - 2 : columns.length) }, title))]),
      ...quantities.filter((quantity) => quantity.of_solver === ofSolver).map((quantity) => bodyRow(quantity, columns, reference)),
    );
  return el('table', { class: 'results' }, head(columns, reference, name), group('', false), group('Solver', true));
}

/** Derived quantities of every direction, and how the solver fared; several runs by direction, with differences. */
export function resultTable(comparison: Comparison, keys: number[]): HTMLElement {
  const { kind } = at(comparison.runs, 0);
  const { several, selection } = comparison;
  const place = scroller('Table of results');
  let key = selection.cycle.key;
  // Paper has no room for more than can be told apart: of many runs, the reference and the one looked at.
  const runs = (): Run[] => (isPrinting() ? comparison.focus : comparison.shown);
  const columns = (): Column[] => columnsOf(runs(), comparison.reference, several ? [key] : keys);
  const controls: HTMLElement[] = [];
  const references = dropDown(
    'Reference run',
    comparison.runs.map((run) => ({ value: run, text: run.label })),
    (reference) => comparison.set({ reference }),
  );
  if (several) {
    const options = keys.map((value) => ({ value, text: kind.cycles.name(value) }));
    const keyChoice = choice(`${kind.cycles.title} of the results`, options, key, (chosen) => {
      key = chosen;
      panel.refresh();
      fill();
    });
    controls.push(...(keys.length > 1 ? [keyChoice] : []), el('label', { class: 'control' }, 'Reference', references));
  }
  const fill = (): void => {
    references.selectedIndex = comparison.runs.indexOf(comparison.reference);
    place.replaceChildren(table(columns(), several ? comparison.reference : undefined, kind.cycles.name));
  };
  const panel = new Panel(
    {
      title: `Results by ${kind.cycles.title.toLowerCase()}`,
      controls,
      subject: () => {
        if (!several) return comparison.names;
        const names = isPrinting() && comparison.many ? `${runs().map(({ label }) => label).join(', ')}, of ${comparison.names}` : comparison.names;
        return `${kind.cycles.name(key)} · ${names} · reference ${comparison.reference.label}`;
      },
      file: () => fileName('results', comparison.names),
      csv: () => csv(columnsOf(comparison.shown, comparison.reference, keys), several, kind.cycles.name),
    },
    place,
  );
  const refresh = (): void => {
    panel.refresh();
    fill();
  };
  comparison.onChange(() => afterwards(refresh));
  onPrint(() => {
    if (comparison.many) refresh();
  });
  fill();
  return panel.root;
}

function csv(columns: Column[], several: boolean, name: (key: number) => string): string {
  return toCsv(
    ['quantity', 'label', 'unit', ...columns.map(({ run, key }) => `${several ? `${run.label} ` : ''}${name(key)}`)],
    quantitiesOf(columns).map((quantity): Cell[] => [
      quantity.key,
      capital(quantity.label),
      quantity.unit,
      ...columns.map((column) => {
        const value = valueOf(column, quantity);
        return typeof value === 'object' ? null : value;
      }),
    ]),
  );
}
