/** Names of the parts in the drawings, each with a line to what it names. */
import { svg } from '../ui/dom';
import type { Look } from '../ui/theme';
import { text, type Place } from './drawing';

export interface PartName {
  content: string;
  at: Place;
  /** What it names; none where it stands in it. */
  to?: Place;
  anchor?: 'start' | 'middle' | 'end';
}

/** @param size  of their letters */
export function partNames(names: PartName[], current: Look, size = 12): SVGElement[] {
  return names.flatMap(({ content, at, to, anchor = 'start' }) => [
    ...(to
      ? [
          svg('line', { x1: at.x, y1: at.y - 4, x2: to.x, y2: to.y, stroke: current.muted, 'stroke-width': 0.8 }),
          svg('circle', { cx: to.x, cy: to.y, r: 1.8, fill: current.muted }),
        ]
      : []),
    // A rim in the colour of the ground keeps it readable across lines.
    text(at, content, current, {
      'text-anchor': anchor,
      'font-weight': 'bold',
      'font-size': size,
      class: 'part-name',
      stroke: current.background,
      'stroke-width': 3,
      'paint-order': 'stroke',
    }),
  ]);
}
