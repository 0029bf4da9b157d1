import type { CycleSummary, Quantity } from '../data/format';
import { at, capital, largest, type Run } from '../data/run';
import { toCsv, type Cell } from '../data/csv';
import { formatNumber, scaleFor } from '../data/units';
import { el } from '../ui/dom';
import { panel } from '../ui/panel';

interface Column {
  run: Run;
  key: number;
  values: Partial<CycleSummary>;
}

/** By direction, and in each by run, so that runs stand side by side. */
function columnsOf(runs: Run[], key: number[]): Column[] {
  return key.flatMap((angle) =>
    runs.flatMap((run) => {
      const loop = run.loop(angle);
      return loop ? [{ run, key: angle, values: loop.summary ?? {} }] : [];
    }),
  );
}

function numberOf(value: unknown): number | null {
  return typeof value === 'number' ? value : null;
}

/** What the results of the runs have, each once. */
function quantitiesOf(runs: Run[], columns: Column[]): Quantity[] {
  const all = new Map(runs.flatMap((run) => run.data.quantities.map((quantity): [string, Quantity] => [quantity.key, quantity])));
  return [...all.values()].filter(({ key }) => columns.some(({ values }) => values[key] !== undefined));
}

function bodyRow({ key, label, unit, whole }: Quantity, columns: Column[]): HTMLElement {
  const scale = scaleFor(largest(columns.map((column) => numberOf(column.values[key]) ?? 0)), unit);
  const cell = (value: unknown): string => {
    if (typeof value === 'boolean') return value ? 'yes' : 'no';
    if (typeof value === 'string') return value.replaceAll('_', ' ');
    const number = numberOf(value);
    if (number !== null && whole) return String(number);
    return formatNumber(number === null ? null : number * scale.factor);
  };
  return el(
    'tr',
    { 'data-key': key },
    el('th', { scope: 'row' }, capital(label)),
    el('td', { class: 'unit' }, scale.unit),
    ...columns.map((column) => el('td', {}, cell(column.values[key]))),
  );
}

function head(columns: Column[], several: boolean, name: (key: number) => string): HTMLElement {
  const spans = new Map<number, number>();
  for (const { key } of columns) spans.set(key, (spans.get(key) ?? 0) + 1);
  const first = el(
    'tr',
    {},
    el('th', { scope: 'col', rowspan: several ? 2 : 1 }, 'Quantity'),
    el('th', { scope: 'col', class: 'unit', rowspan: several ? 2 : 1 }, 'Unit'),
    ...[...spans].map(([key, span]) => el('th', { scope: 'col', colspan: span }, name(key))),
  );
  const second = el('tr', {}, ...columns.map(({ run }) => el('th', { scope: 'col', class: 'run' }, run.label)));
  return el('thead', {}, first, ...(several ? [second] : []));
}

/** Derived quantities of every direction and run, and how the solver fared. */
export function resultTable(runs: Run[], key: number[]): HTMLElement {
  const columns = columnsOf(runs, key);
  const several = runs.length > 1;
  const { kind } = at(runs, 0);
  const quantities = quantitiesOf(runs, columns);
  const group = (name: string, ofSolver: boolean): HTMLElement =>
    el(
      'tbody',
      {},
      ...(name === '' ? [] : [el('tr', { class: 'group' }, el('th', { scope: 'rowgroup', colspan: columns.length + 2 }, name))]),
      ...quantities.filter((quantity) => quantity.of_solver === ofSolver).map((quantity) => bodyRow(quantity, columns)),
    );
  const csv = (): string =>
    toCsv(
      ['quantity', ...columns.map(({ run, key: angle }) => `${several ? `${run.label} ` : ''}${kind.loops.name(angle)}`)],
      quantities.map(({ key }): Cell[] => [
        key,
        ...columns.map(({ values }) => {
          const value = values[key];
          return Array.isArray(value) ? null : value;
        }),
      ]),
    );
  return panel(
    { title: `Results by ${kind.loops.title.toLowerCase()}`, file: () => 'results', csv },
    el(
      'div',
      { class: 'scroller', tabindex: 0, role: 'group', 'aria-label': 'Table of results' },
      el('table', { class: 'results' }, head(columns, several, kind.loops.name), group('', false), group('Solver', true)),
    ),
  );
}

/** Where a run falls short of what was asked for. */
export function warningsOf(run: Run): string[] {
  const warnings: string[] = [];
  const { status } = run.data.summary;
  if (status !== 'complete') {
    warnings.push(`The results are partial: ${run.attribute('status_message') || status}.`);
  }
  for (const loop of run.loops) {
    const { name, size, summary, increments } = loop;
    if (!summary) warnings.push(`${name} was not begun.`);
    for (const foil of ['top foil', 'bump foil']) {
      if (summary?.[`above_yield_${foil.replace(' ', '_')}`] === true) {
        warnings.push(`${name}: the bending stress of the ${foil} exceeds its yield stress.`);
      }
    }
    const missing = size > 1 && at(increments, 1) > 1 ? at(increments, 1) : 0;
    if (missing > 0) warnings.push(`${name}: every ${missing}th increment is shown; result.nc has them all.`);
  }
  return warnings;
}
