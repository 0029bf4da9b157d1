import { at, largest, type Run } from '../data/run';
import { toCsv, type Cell } from '../data/csv';
import { formatNumber, scaleFor } from '../data/units';
import { el } from '../ui/dom';
import { panel } from '../ui/panel';

interface Row {
  key: string;
  text: string;
  unit: string;
  digits?: number;
}

/** Keys of summary.json; what is not listed here stands there all the same. */
const rows: Row[] = [
  { key: 'max_force_N', text: 'Maximum force', unit: 'N' },
  { key: 'cross_force_at_max_N', text: 'Cross force at full displacement', unit: 'N' },
  { key: 'secant_stiffness_N_per_m', text: 'Secant stiffness', unit: 'N/m' },
  { key: 'tangent_stiffness_loading_N_per_m', text: 'Tangent stiffness, loading further', unit: 'N/m' },
  { key: 'tangent_stiffness_unloading_N_per_m', text: 'Tangent stiffness, unloading', unit: 'N/m' },
  { key: 'loop_energy_J', text: 'Loop energy', unit: 'J' },
  { key: 'loss_factor', text: 'Loss factor', unit: '' },
  { key: 'elastic_energy_at_max_J', text: 'Elastic energy at full displacement', unit: 'J' },
  { key: 'first_contact_m', text: 'First contact', unit: 'm' },
  { key: 'clearance_5N_m', text: 'Clearance at 5 N', unit: 'm' },
  { key: 'clearance_10N_m', text: 'Clearance at 10 N', unit: 'm' },
  { key: 'max_stress_top_foil_Pa', text: 'Largest bending stress, top foil', unit: 'Pa' },
  { key: 'max_stress_bump_foil_Pa', text: 'Largest bending stress, bump foil', unit: 'Pa' },
  { key: 'initial_displacement_m', text: 'Displacement at the start', unit: 'm' },
  { key: 'initial_force_N', text: 'Force at the start', unit: 'N' },
  { key: 'initial_journal_load_N', text: 'Sum of journal loads at the start', unit: 'N' },
  { key: 'initial_elastic_energy_J', text: 'Elastic energy of the assembly', unit: 'J' },
  { key: 'assembly_dissipation_J', text: 'Dissipated by the assembly', unit: 'J' },
];

const solverRows: Row[] = [
  { key: 'converged', text: 'Converged', unit: '' },
  { key: 'steps', text: 'Increments per branch', unit: '', digits: 0 },
  { key: 'iterations', text: 'Linear solves', unit: '', digits: 0 },
  { key: 'factorisations', text: 'Factorisations', unit: '', digits: 0 },
  { key: 'substeps', text: 'Extra solves of halved increments', unit: '', digits: 0 },
  { key: 'max_residual', text: 'Largest residual', unit: '', digits: 2 },
  { key: 'wall_time_s', text: 'Time taken', unit: 's', digits: 3 },
];

interface Column {
  run: Run;
  key: number;
  values: Record<string, unknown>;
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

function bodyRow({ key, text, unit, digits = 4 }: Row, columns: Column[]): HTMLElement {
  const scale = scaleFor(largest(columns.map((column) => numberOf(column.values[key]) ?? 0)), unit);
  const cell = (value: unknown): string => {
    if (typeof value === 'boolean') return value ? 'yes' : 'no';
    const number = numberOf(value);
    if (number !== null && digits === 0) return String(number);
    return formatNumber(number === null ? null : number * scale.factor, digits);
  };
  return el(
    'tr',
    { 'data-key': key },
    el('th', { scope: 'row' }, text),
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
  const known = ({ key }: Row): boolean => columns.some(({ values }) => values[key] !== undefined);
  const group = (name: string, members: Row[]): HTMLElement =>
    el(
      'tbody',
      {},
      ...(name === '' ? [] : [el('tr', { class: 'group' }, el('th', { scope: 'rowgroup', colspan: columns.length + 2 }, name))]),
      ...members.filter(known).map((row) => bodyRow(row, columns)),
    );
  const csv = (): string =>
    toCsv(
      ['quantity', ...columns.map(({ run, key: angle }) => `${several ? `${run.label} ` : ''}${kind.loops.name(angle)}`)],
      [...rows, ...solverRows].filter(known).map(({ key }): Cell[] => [
        key,
        ...columns.map(({ values }) => {
          const value = values[key];
          return typeof value === 'number' || typeof value === 'boolean' ? value : null;
        }),
      ]),
    );
  return panel(
    { title: `Results by ${kind.loops.title.toLowerCase()}`, file: () => 'results', csv },
    el(
      'div',
      { class: 'scroller', tabindex: 0, role: 'group', 'aria-label': 'Table of results' },
      el('table', { class: 'results' }, head(columns, several, kind.loops.name), group('', rows), group('Solver', solverRows)),
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
    if (size === 0) warnings.push(`${name} was not begun.`);
    else if (!summary?.converged) {
      warnings.push(`${name} did not converge; its last increment is ${at(increments, size - 1)} of ${loop.lastIncrement}.`);
    }
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
