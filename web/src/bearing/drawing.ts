/** Pieces that both views of the bearing are drawn with. */
import { contactStates, type Cycle, type Interface } from '../data/run';
import { svg } from '../ui/dom';
import { fontFamily, type Look } from '../ui/theme';

export interface Place {
  x: number;
  y: number;
}

export function pathOf(points: Place[], closed = false): string {
  const text = points.map(({ x, y }, i) => `${i === 0 ? 'M' : 'L'}${x.toFixed(2)} ${y.toFixed(2)}`).join('');
  return closed ? `${text}Z` : text;
}

/** An arrow from one place to another, as one filled outline; nothing if it is too short to be seen. */
export function arrowPath(from: Place, to: Place, width = 1.6): string {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const length = Math.hypot(dx, dy);
  if (!(length >= 1.5)) return '';
  const [ux, uy] = [dx / length, dy / length];
  const head = Math.min(3.4 * width, 0.6 * length);
  const point = (along: number, aside: number): Place => ({
    x: from.x + along * ux - aside * uy,
    y: from.y + along * uy + aside * ux,
  });
  const neck = length - head;
  return pathOf(
    [
      point(0, width / 2),
      point(neck, width / 2),
      point(neck, 1.5 * width),
      to,
      point(neck, -1.5 * width),
      point(neck, -width / 2),
      point(0, -width / 2),
    ],
    true,
  );
}

/** On the screen, px. */
const letterHeight = 11;

/**
 * Height of letters that are as high on the screen, however large the drawing is there.
 * @param shown  size of the drawing on the screen, px; 0 where it is not known
 */
export function letters(size: number, shown: number): number {
  return letterHeight * (shown > 0 ? size / shown : 1);
}

export function text(place: Place, content: string, current: Look, more: Record<string, string | number> = {}): SVGElement {
  return svg(
    'text',
    { x: place.x, y: place.y, fill: current.muted, 'font-size': 12, 'font-family': fontFamily, ...more },
    content,
  );
}

/** State of a contact as a mark: ring, square, or a triangle that points where it slips to. */
export function stateMark(
  place: Place,
  cycle: Cycle,
  interfaceName: Interface['name'],
  index: number,
  node: number,
  current: Look,
  /** Way of increasing place along the foil on the drawing. */
  forward: Place,
): SVGElement {
  const state = contactStates[cycle.states(interfaceName).at(index, node)] ?? 'open';
  const { x, y } = place;
  if (state === 'open') {
    return svg('circle', { cx: x, cy: y, r: 2.2, fill: current.background, stroke: current.muted });
  }
  if (state === 'stick') {
    return svg('rect', { x: x - 2.6, y: y - 2.6, width: 5.2, height: 5.2, fill: current.states.stick, stroke: current.background, 'stroke-width': 0.8 });
  }
  const sign = state === 'slip forward' ? 1 : -1;
  const [ux, uy] = [sign * forward.x, sign * forward.y];
  const corners = [
    { x: x + 4.6 * ux, y: y + 4.6 * uy },
    { x: x - 3.2 * ux - 4 * uy, y: y - 3.2 * uy + 4 * ux },
    { x: x - 3.2 * ux + 4 * uy, y: y - 3.2 * uy - 4 * ux },
  ];
  return svg('path', { d: pathOf(corners, true), fill: current.states[state], stroke: current.background, 'stroke-width': 0.8 });
}
