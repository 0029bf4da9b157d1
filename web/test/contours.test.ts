import { describe, expect, it } from 'vitest';
import { bandOf, lineOf, trianglesOf, type Corner } from '../src/charts/contours';

function areaOf(polygon: Corner[]): number {
  return 0.5 * Math.abs(polygon.reduce((sum, { x, y }, i) => sum + x * (polygon[(i + 1) % polygon.length]?.y ?? 0) - y * (polygon[(i + 1) % polygon.length]?.x ?? 0), 0));
}

const [xs, ys] = [[0, 1, 3], [0, 2]];
const slope = ys.map((y) => xs.map((x) => x + 0.5 * y));

describe('contours', () => {
  it('cover the grid once, whatever the levels', () => {
    const triangles = trianglesOf(xs, ys, slope);
    const area = (least: number, most: number): number => bandOf(triangles, least, most).reduce((sum, polygon) => sum + areaOf(polygon), 0);
    expect(area(-Infinity, Infinity)).toBeCloseTo(6, 12);
    expect(area(0, 1.3) + area(1.3, 2) + area(2, 4)).toBeCloseTo(6, 12);
    // Below x + y/2 = 1 lies a triangle with legs of 1 and 2.
    expect(area(0, 1)).toBeCloseTo(1, 12);
  });

  it('are straight lines of a plane', () => {
    const pieces = lineOf(trianglesOf(xs, ys, slope), 1.5);
    for (const { x, y } of pieces.flat()) expect(x + 0.5 * y).toBeCloseTo(1.5, 12);
    const length = pieces.reduce((sum, [a, b]) => sum + Math.hypot(a.x - b.x, a.y - b.y), 0);
    expect(length).toBeCloseTo(Math.hypot(1, 2), 12);
  });

  it('leave out cells with a point that is not known', () => {
    const triangles = trianglesOf(xs, ys, [[0, NaN, 1], [0, 1, 1]]);
    expect(triangles).toEqual([]);
    expect(trianglesOf(xs, ys, [[NaN, 0, 1], [0, 1, 1]])).toHaveLength(4);
  });
});
