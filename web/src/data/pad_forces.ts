/** Forces of pads are lists in the results: each pad makes a quantity of its own for tables. */
import type { CycleSummary, Quantity, RunData } from './format';

function keyOf(pad: number): string {
  return `pad_force_${pad}_N`;
}

function components(cycle: CycleSummary): [(number | null)[], (number | null)[]] {
  const list = (key: string): (number | null)[] => (Array.isArray(cycle[key]) ? (cycle[key] as (number | null)[]) : []);
  return [list('pad_forces_x_N'), list('pad_forces_y_N')];
}

/** A cycle with a key for the size of the force that each of several pads takes at full displacement. */
export function withPadForces(cycle: CycleSummary): CycleSummary {
  const [along, across] = components(cycle);
  const sizes = along.map((x, i) => {
    const y = across[i] ?? null;
    return [keyOf(i + 1), x === null || y === null ? null : Math.hypot(x, y)];
  });
  return { ...cycle, ...Object.fromEntries(sizes) };
}

/** These of all cycles of a run. */
export function padQuantitiesOf({ nodes }: RunData): Quantity[] {
  return Array.from({ length: nodes.pad ?? 0 }, (_, i) => ({
    name: 'pad_force',
    key: keyOf(i + 1),
    label: `force of pad ${i + 1}`,
    unit: 'N',
    whole: false,
    of_solver: false,
    first: false,
    meaning: 'magnitude of the pad force at full displacement',
  }));
}
