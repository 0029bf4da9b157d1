/** What values span, and where one of them lies within. */
export type Range = [least: number, most: number];

/** Of the values that are known. */
export function rangeOf(values: number[]): Range {
  // A million arguments would be too many.
  return values.filter(Number.isFinite).reduce<Range>(([least, most], value) => [Math.min(least, value), Math.max(most, value)], [Infinity, -Infinity]);
}

/** 0 at the least, 1 at the greatest; 0 where all values are the same. */
export function fractionIn([least, most]: Range, value: number): number {
  return most > least ? (value - least) / (most - least) : 0;
}
