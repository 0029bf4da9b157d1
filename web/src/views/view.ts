import type { CaseKeys, ResultData } from '../data/format';
import type { Entry } from '../tables/glossary';
import { el, type Child } from '../ui/dom';

/** What a report shows of the results of one kind. */
export interface View {
  /** Each with a heading, to which the head of the page links. */
  sections: HTMLElement[];
  /** Warnings of each of the results. */
  warnings: string[][];
  /** Of the glossary. */
  entries: Entry[];
}

/** @param alone  whether there is no other view, from whose sections these are to be told */
export type MakeView = (results: ResultData[], keys: CaseKeys, alone: boolean) => View;

/** A section with its heading. */
export function part(id: string, title: string, ...children: Child[]): HTMLElement {
  return el('section', { id, class: 'part', 'aria-labelledby': `${id}-title` }, el('h2', { id: `${id}-title` }, title), ...children);
}

/** Folded under a line that says what it is. */
export function fold(text: string, ...children: Child[]): HTMLDetailsElement {
  return el('details', { class: 'more' }, el('summary', {}, text), ...children);
}

/** What is said of the case of a sweep, which is that of its first point. */
export function foldCase(section: HTMLElement): HTMLDetailsElement {
  return fold('The case of the first point, and where the results come from', section);
}
