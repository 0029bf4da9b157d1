/** Numbers in intervals of equal width from the least to the largest. */
export function countsOf(values: (number | null)[], from: number, to: number, intervals: number): number[] {
  const counts = Array.from({ length: intervals }, () => 0);
  for (const value of values) {
    if (value === null) continue;
    const place = to > from ? Math.min(intervals - 1, Math.floor((intervals * (value - from)) / (to - from))) : 0;
    counts[place] = (counts[place] ?? 0) + 1;
  }
  return counts;
}
