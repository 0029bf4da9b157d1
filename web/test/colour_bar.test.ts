import { describe, expect, it } from 'vitest';
import { roundTicks } from '../src/charts/ticks';

describe('ticks of a colour bar', () => {
  it('are round, and lie between the ends', () => {
    expect(roundTicks(87.7, 262.8)).toEqual([100, 150, 200, 250]);
    expect(roundTicks(-0.3, 0.3)).toEqual([-0.2, 0, 0.2]);
    expect(roundTicks(5, 5)).toEqual([5]);
  });
});
