/** Coordinates of grids, read off their variables. */
import { isSpeed, valueText } from './case_values';
import { numbersOf, type Coordinate, type Grid } from './grid';
import { directionName } from './kinds';
import { capital } from './run';
import { scaleFor } from './units';

/** A dimension with the values of its variable: speeds in rpm; of a dimension without one, its entries counted from 1. */
export function coordinateOf(grid: Grid, name: string): Coordinate {
  const title = capital(name.replaceAll('_', ' '));
  const variable = grid.variable(name);
  if (variable?.dims.join() !== name) {
    const counted = Array.from({ length: grid.size(name) }, (_, i) => i + 1);
    return { name, title, numbers: counted, texts: counted.map(String), unit: '' };
  }
  const { unit: si, words } = variable;
  const numbers = numbersOf(grid, name);
  const texts = (text: (number: number) => string): string[] => numbers.map((number) => (Number.isFinite(number) ? text(number) : '–'));
  if (words.length > 0) return { name, title, texts: texts((number) => words[number]?.replaceAll('_', ' ') ?? '–'), unit: '' };
  if (name === 'direction') return { name, title, texts: texts(directionName), unit: '' };
  if (si === 'degree') return { name, title: `${title} (°)`, numbers, texts: texts((number) => `${Number(number.toPrecision(6))}°`), unit: '' };
  const unit = si === 'rad/s' && isSpeed(name) ? 'rpm' : si;
  const { factor } = unit === 'rpm' ? scaleFor(1, unit) : { factor: 1 };
  return { name, title, numbers: numbers.map((number) => number * factor), texts: texts((number) => valueText(number, unit)), unit };
}
