/** What each of several pads takes, in results over coordinates. */
import { numbersOf, type Coordinate, type Grid } from '../data/grid';
import type { Part } from './over';

/** Several pads, one after the other; none where there is one. */
export function padCoordinate(grid: Grid): Coordinate[] {
  const numbers = numbersOf(grid, 'pad');
  return numbers.length > 0 ? [{ name: 'pad', title: 'Pad', texts: numbers.map(String), unit: '' }] : [];
}

/** A variable that tells pads apart, or the size of the vector of two. */
export function padParts(grid: Grid, names: string[], unit = ''): Part[] {
  const variables = names.flatMap((name) => grid.variable(name) ?? []);
  const [first] = variables;
  if (!first || variables.length < names.length) return [];
  return padCoordinate(grid).flatMap(({ texts }) =>
    texts.map((text, pad) => ({
      key: `pad_force_${text}${unit}`,
      text: `Pad ${text}`,
      has: (dimension) => dimension !== 'pad' && first.has(dimension),
      value: (place) => Math.hypot(...variables.map((variable) => variable.at({ ...place, pad }))),
    })),
  );
}
