/** Clearances are lists in the results: each force makes a quantity of its own for tables. */
import type { CycleSummary, Quantity, RunData } from './format';
import { formatQuantity } from './units';

interface Clearance {
  force: number;
  displacement: number | null;
}

function clearancesOf(cycle: CycleSummary): Clearance[] {
  if (!Array.isArray(cycle['clearances'])) return [];
  return (cycle['clearances'] as { force_N: number; displacement_m: number | null }[]).map((one) => ({ force: one.force_N, displacement: one.displacement_m }));
}

function keyOf(force: number): string {
  return `clearance_${force}N_m`;
}

/** A cycle with a key for each of its clearances. */
export function withClearances(cycle: CycleSummary): CycleSummary {
  return { ...cycle, ...Object.fromEntries(clearancesOf(cycle).map(({ force, displacement }) => [keyOf(force), displacement])) };
}

/** The quantities of a run with its clearances, where its other displacements are. */
export function quantitiesOf({ quantities, summary, meanings }: RunData): Quantity[] {
  const forces = new Set(summary.cycles.flatMap((cycle) => clearancesOf(cycle).map(({ force }) => force)));
  const clearances = [...forces].map((force): Quantity => ({
    name: 'clearance',
    key: keyOf(force),
    label: `clearance at ${formatQuantity(force, 'N').replace(/\.?0+ /, ' ')}`,
    unit: 'm',
    whole: false,
    of_solver: false,
    first: false,
    meaning: meanings['clearance']?.text ?? '',
  }));
  const before = 1 + Math.max(...['first_contact', 'take_up'].map((name) => quantities.findIndex((one) => one.name === name)));
  const place = before > 0 ? before : quantities.length;
  return [...quantities.slice(0, place), ...clearances, ...quantities.slice(place)];
}
