/** How lines over a grid are told apart: few by colour and marker, many by a scale of colours. */
import type { Coordinate } from '../data/grid';
import { fractionIn, rangeOf } from '../data/range';
import { at } from '../data/run';
import { svg } from '../ui/dom';
import { named } from '../ui/grid_selection';
import type { LegendEntry } from '../ui/legend';
import { rampColour, type Look } from '../ui/theme';

/** As many as legends list one by one. */
const mostListed = 8;

const shapes: Record<string, (fill: string) => SVGElement> = {
  circle: (fill) => svg('circle', { cx: 15, cy: 6, r: 3.5, fill }),
  triangle: (fill) => svg('path', { d: 'M15 2L19 9.5H11Z', fill }),
  rect: (fill) => svg('path', { d: 'M11.8 2.8H18.2V9.2H11.8Z', fill }),
  diamond: (fill) => svg('path', { d: 'M15 1.5L19 6L15 10.5L11 6Z', fill }),
};

export interface LineLook {
  colour: (current: Look) => string;
  marker: string;
  /** Lengths of dashes and gaps; none of a solid line. */
  dash?: number[];
}

/** Of one of several things that have no order. */
export function plainLook(index: number): LineLook {
  const names = Object.keys(shapes);
  return {
    colour: (current) => at(current.series, index % current.series.length),
    marker: at(names, index % names.length),
  };
}

/** Of the value of a coordinate: numbers go along a scale of colours. */
export function lookOf(coordinate: Coordinate, index: number): LineLook {
  const { numbers } = coordinate;
  const plain = plainLook(index);
  if (!numbers) return plain;
  const fraction = fractionIn(rangeOf(numbers), at(numbers, index));
  return { ...plain, colour: (current) => rampColour(current, fraction) };
}

export function lineEntry({ colour, marker, dash }: LineLook, text: string): LegendEntry {
  return {
    width: 30,
    draw: (current) => [
      svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: colour(current), 'stroke-width': 2, ...(dash ? { 'stroke-dasharray': dash.join(' ') } : {}) }),
      ...(shapes[marker] ? [shapes[marker](colour(current))] : []),
    ],
    text,
  };
}

/** Of marks without a line. */
export function markEntry({ colour, marker }: LineLook, text: string): LegendEntry {
  return { width: 30, draw: (current) => (shapes[marker] ? [shapes[marker](colour(current))] : []), text };
}

/** What the lines of a coordinate stand for. */
export function coordinateLegend(coordinate: Coordinate, withMarkers = true): LegendEntry[] {
  const { numbers, texts, title } = coordinate;
  if (!numbers || texts.length <= mostListed) {
    return texts.map((_, i) => {
      const one = lookOf(coordinate, i);
      return lineEntry(withMarkers ? one : { ...one, marker: '' }, named(coordinate, i));
    });
  }
  const order = [...numbers.keys()].sort((a, b) => at(numbers, a) - at(numbers, b));
  const ends = [at(order, 0), at(order, order.length - 1)].map((i) => at(texts, i));
  const parts = 24;
  return [
    {
      width: 5 * parts,
      draw: (current) =>
        Array.from({ length: parts }, (_, i) => svg('rect', { x: 5 * i, y: 1, width: 5.5, height: 10, fill: rampColour(current, i / (parts - 1)) })),
      text: `${title}: ${ends[0] ?? ''} to ${ends[1] ?? ''}`,
    },
  ];
}
