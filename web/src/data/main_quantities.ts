/** What people ask for first. */
import type { Quantity } from './format';

const most = 3;

/**
 * The two or three quantities of a case.
 * @param limited  names of those that limits are set on: all of them come first
 */
export function mainQuantities<Q extends Pick<Quantity, 'name' | 'first' | 'leads' | 'key_figure'>>(quantities: Q[], limited: string[] = []): Q[] {
  const own = limited.flatMap((name) => quantities.find((one) => one.name === name) ?? []);
  const others = [...quantities.filter(({ leads }) => leads), ...quantities.filter((one) => one.key_figure), ...quantities.filter(({ first }) => first), ...quantities];
  return [...new Set([...own, ...others])].slice(0, Math.max(own.length, most));
}
