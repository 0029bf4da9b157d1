/** Where the bands of a map lie. */
import { at, largest } from './run';

/** A speed that varies by less than this part is one. */
const steadyPart = 0.01;

/** Of a band of a map, the lower and the upper end. */
export type Band = [from: number, to: number];

/** Bands that meet in the middle between numbers that rise. */
export function bandsOf(numbers: number[]): Band[] {
  const middle = (i: number): number => 0.5 * (at(numbers, i) + at(numbers, i + 1));
  return numbers.map((number, i): Band => {
    const [hasBefore, hasAfter] = [i > 0, i < numbers.length - 1];
    const [below, above] = [hasBefore ? middle(i - 1) : NaN, hasAfter ? middle(i) : NaN];
    if (!hasBefore && !hasAfter) return [number - 0.5, number + 0.5];
    return [hasBefore ? below : 2 * number - above, hasAfter ? above : 2 * number - below];
  });
}

/** Whether spectra lie one above the other by their speeds: these rise all the way, or fall. */
export function isMonotonous(speeds: number[]): boolean {
  const steps = speeds.slice(1).map((speed, i) => speed - at(speeds, i));
  return varies(speeds) && (steps.every((one) => one > 0) || steps.every((one) => one < 0));
}

/** Whether it is more than one speed. */
export function varies(speeds: number[]): boolean {
  return speeds.length > 0 && Math.max(...speeds) - Math.min(...speeds) > steadyPart * largest(speeds);
}
