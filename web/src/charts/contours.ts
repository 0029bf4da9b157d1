/** Contours of numbers on a grid: linear within triangles, so that bands and lines fit together. */

export interface Corner {
  x: number;
  y: number;
  /** What contours are of. */
  value: number;
}

function between(a: Corner, b: Corner, level: number): Corner {
  const part = (level - a.value) / (b.value - a.value);
  return { x: a.x + part * (b.x - a.x), y: a.y + part * (b.y - a.y), value: level };
}

/** What of a polygon lies at or above a level; below it with `sign` -1. */
function clipped(polygon: Corner[], level: number, sign: 1 | -1): Corner[] {
  const inside = ({ value }: Corner): boolean => sign * (value - level) >= 0;
  return polygon.flatMap((corner, i) => {
    const next = polygon[(i + 1) % polygon.length] ?? corner;
    const crossing = inside(corner) === inside(next) ? [] : [between(corner, next, level)];
    return inside(corner) ? [corner, ...crossing] : crossing;
  });
}

/**
 * Triangles between the points of a grid, four around the middle of each cell.
 * @param values  by row (y) and column (x); cells with a point that is not known have none
 */
export function trianglesOf(xs: number[], ys: number[], values: number[][]): Corner[][] {
  const corner = (i: number, j: number): Corner => ({ x: xs[i] ?? NaN, y: ys[j] ?? NaN, value: values[j]?.[i] ?? NaN });
  const triangles: Corner[][] = [];
  for (let j = 0; j + 1 < ys.length; j += 1) {
    for (let i = 0; i + 1 < xs.length; i += 1) {
      const cell = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
      if (!cell.every(({ value }) => Number.isFinite(value))) continue;
      const mean = (of: (one: Corner) => number): number => cell.reduce((sum, one) => sum + of(one), 0) / 4;
      const middle = { x: mean(({ x }) => x), y: mean(({ y }) => y), value: mean(({ value }) => value) };
      cell.forEach((one, k) => triangles.push([one, cell[(k + 1) % 4] ?? one, middle]));
    }
  }
  return triangles;
}

/** Polygons where values lie between two levels. */
export function bandOf(triangles: Corner[][], least: number, most: number): Corner[][] {
  return triangles.map((triangle) => clipped(clipped(triangle, least, 1), most, -1)).filter((polygon) => polygon.length > 2);
}

/** Pieces of the line along which values are at a level. */
export function lineOf(triangles: Corner[][], level: number): [Corner, Corner][] {
  return triangles.flatMap((triangle): [Corner, Corner][] => {
    const crossings = triangle.flatMap((corner, i) => {
      const next = triangle[(i + 1) % 3] ?? corner;
      return corner.value >= level === next.value >= level ? [] : [between(corner, next, level)];
    });
    const [a, b] = crossings;
    return a && b ? [[a, b]] : [];
  });
}
