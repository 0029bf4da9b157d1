/** How numbers of an ensemble spread, counted as `bumpfoil montecarlo` counts them (ensemble/statistics.hpp). */
import { percentiles } from '../data/ensemble';
import type { StatisticsData } from '../data/format';

/** Two-sided 95 % of a normal distribution, in standard deviations. */
const normal95 = 1.959963984540054;

function percentile(sorted: number[], part: number): number | null {
  const place = part * (sorted.length - 1);
  const below = sorted[Math.floor(place)] ?? NaN;
  const above = sorted[Math.ceil(place)] ?? NaN;
  const value = above === below ? below : below + (place % 1) * (above - below);
  return Number.isFinite(value) ? value : null;
}

/** What is not known of a bearing is never reached in it, and counts as largest. */
export function statisticsOf(values: (number | null)[]): StatisticsData {
  const known = values.filter((value): value is number => value !== null).sort((a, b) => a - b);
  const count = known.length;
  const mean = count > 0 ? known.reduce((sum, value) => sum + value, 0) / count : null;
  const std = mean !== null && count > 1 ? Math.sqrt(known.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (count - 1)) : null;
  const error = std === null ? null : std / Math.sqrt(count);
  const sorted = [...known, ...Array.from({ length: values.length - count }, () => Infinity)];
  return {
    count,
    undefined: values.length - count,
    mean,
    std,
    standard_error: error,
    mean_interval_95: mean === null || error === null ? [] : [mean - normal95 * error, mean + normal95 * error],
    ...Object.fromEntries(percentiles.map((percent) => [`p${percent}`, percentile(sorted, percent / 100)])),
  };
}

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
