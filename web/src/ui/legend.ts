import { el, svg } from './dom';
import type { Look } from './theme';

/** What a colour, a dash or a marker means. */
export interface LegendEntry {
  /** In a box of this width, and of 12 px height or more. */
  width: number;
  height?: number;
  draw: (current: Look) => SVGElement[];
  text: string;
}

export function sampleOf(entry: LegendEntry, current: Look): SVGSVGElement {
  const { width, height = 12 } = entry;
  return svg('svg', { width, height, viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true' }, ...entry.draw(current));
}

/** Named samples; `look` is that of now, so they are to be made anew when it changes. */
export function legend(entries: LegendEntry[], current: Look): HTMLElement {
  return el('ul', { class: 'legend' }, ...entries.map((entry) => el('li', {}, sampleOf(entry, current), entry.text)));
}
