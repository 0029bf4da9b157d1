import { describe, expect, it } from 'vitest';
import { countsOf, statisticsOf } from '../src/designer/spread';

describe('how numbers spread', () => {
  it('is told by mean, deviation and percentiles between neighbours', () => {
    const { count, mean, std, standard_error: error, mean_interval_95: interval, ...more } = statisticsOf([4, 1, 3, 2, 5]);
    expect([count, mean]).toEqual([5, 3]);
    expect(std).toBeCloseTo(Math.sqrt(2.5), 12);
    expect(error).toBeCloseTo(Math.sqrt(0.5), 12);
    expect(interval[1]).toBeCloseTo(3 + 1.959963984540054 * Math.sqrt(0.5), 12);
    expect(more['p50']).toBe(3);
    expect(more['p5']).toBeCloseTo(1.2, 12);
  });

  it('counts what is not known as largest', () => {
    const found = statisticsOf([1, null, 2]);
    expect([found.count, found.undefined, found.mean]).toEqual([2, 1, 1.5]);
    expect([found['p50'], found['p75'], found['p99']]).toEqual([2, null, null]);
  });

  it('is not known of nothing', () => {
    expect(statisticsOf([null])).toMatchObject({ count: 0, undefined: 1, mean: null, std: null, p50: null });
    expect(statisticsOf([7])).toMatchObject({ count: 1, mean: 7, std: null, mean_interval_95: [], p5: 7, p95: 7 });
  });

  it('is drawn by counts in intervals of equal width', () => {
    expect(countsOf([0, 0.9, 1, null, 2, 4], 0, 4, 4)).toEqual([2, 1, 1, 1]);
    expect(countsOf([3, 3], 3, 3, 4)).toEqual([2, 0, 0, 0]);
  });
});
