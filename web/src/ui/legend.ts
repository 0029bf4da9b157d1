import { el, svg } from './dom';
import type { Look } from './theme';

/** What a colour, a dash or a marker means. */
export interface LegendEntry {
  /** In a box of this width and 12 px height. */
  width: number;
  draw: (current: Look) => SVGElement[];
  text: string;
}

export function sampleOf(entry: LegendEntry, current: Look): SVGSVGElement {
  return svg('svg', { width: entry.width, height: 12, viewBox: `0 0 ${entry.width} 12`, 'aria-hidden': 'true' }, ...entry.draw(current));
}

/** Named samples; `look` is that of now, so they are to be made anew when it changes. */
export function legend(entries: LegendEntry[], current: Look): HTMLElement {
  return el('ul', { class: 'legend' }, ...entries.map((entry) => el('li', {}, sampleOf(entry, current), entry.text)));
}
