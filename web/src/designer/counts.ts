/** Numbers in intervals of equal width from the least to the largest. */
export function countsOf(values: (number | null)[], from: number, to: number, count: number): number[] {
  const counts = Array.from({ length: count }, () => 0);
  for (const value of values) {
    if (value === null) continue;
    const place = to > from ? Math.min(count - 1, Math.floor((count * (value - from)) / (to - from))) : 0;
    counts[place] = (counts[place] ?? 0) + 1;
  }
  return counts;
}
