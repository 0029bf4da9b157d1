import { describe, expect, it } from 'vitest';
import { countsOf } from '../src/designer/counts';

describe('how numbers spread', () => {
  it('is drawn by counts in intervals of equal width', () => {
    expect(countsOf([0, 0.9, 1, null, 2, 4], 0, 4, 4)).toEqual([2, 1, 1, 1]);
    expect(countsOf([3, 3], 3, 3, 4)).toEqual([2, 0, 0, 0]);
  });
});
