/** What people ask for first. */
import type { Quantity } from './format';

/**
 * The few quantities of a case that are shown large.
 * @param limited  names of those that limits are set on: all of them come first
 * @param most     number of quantities, unless more are limited
 */
export function mainQuantities<Q extends Pick<Quantity, 'name' | 'first' | 'leads' | 'key_figure'>>(quantities: Q[], limited: string[] = [], most = 3): Q[] {
  const own = limited.flatMap((name) => quantities.find((one) => one.name === name) ?? []);
  const others = [...quantities.filter(({ leads }) => leads), ...quantities.filter((one) => one.key_figure), ...quantities.filter(({ first }) => first), ...quantities];
  return [...new Set([...own, ...others])].slice(0, Math.max(own.length, most));
}

/** Those that are numbers, wherever they are known. @param valuesOf  of a quantity by its key */
export function numbersAmong<Q extends Pick<Quantity, 'key'>>(quantities: Q[], valuesOf: (key: string) => unknown[]): Q[] {
  return quantities.filter(({ key }) => valuesOf(key).every((value) => typeof (value ?? 0) === 'number'));
}
