/** What people ask for first. */
import type { Quantity } from './format';

/** Of all kinds of results; those that results have, in this order. */
const asked = ['onset_speed', 'stable_up_to', 'largest_amplitude', 'h_min', 'power', 'critical_mass', 'loaded_stiffness', 'max_force', 'loss_factor', 'stiffness'];
const most = 3;

/**
 * The two or three quantities of a case.
 * @param limited  names of those that limits are set on: all of them come first
 */
export function mainQuantities<Q extends Pick<Quantity, 'name' | 'first' | 'leads'>>(quantities: Q[], limited: string[] = []): Q[] {
  const named = (names: string[]): Q[] => names.flatMap((name) => quantities.find((one) => one.name === name) ?? []);
  const own = named(limited);
  const others = [...named(asked), ...quantities.filter(({ leads }) => leads), ...quantities.filter(({ first }) => first), ...quantities];
  return [...new Set([...own, ...others])].slice(0, Math.max(own.length, most));
}
