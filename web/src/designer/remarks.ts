/** What is to be minded about a result. */
import type { GridData } from '../data/format';
import { el } from '../ui/dom';

/** What was not found, and where the answer is less than it seems. */
export function notesOf({ attributes }: Pick<GridData, 'attributes'>): string[] {
  return [attributes['status_message'] ?? '', ...(attributes['warnings'] ?? '').split('\n')].filter((text) => text !== '');
}

/** As a list, folded where it is long; nothing where there are none. */
export function remarks(notes: string[]): HTMLElement[] {
  const each = [...new Set(notes)].map((note) => (note.endsWith('.') ? note : `${note}.`));
  const list = el('ul', { class: 'remarks' }, ...each.map((note) => el('li', {}, note)));
  if (each.length < 2) return each.length === 0 ? [] : [list];
  return [el('details', { class: 'remarks-fold' }, el('summary', {}, `${each.length} warnings: ${each[0] ?? ''}`), list)];
}
