/** What is to be minded about a result. */
import type { GridData } from '../data/format';
import { el } from '../ui/dom';

/** What was not found, and where the answer is less than it seems. */
export function notesOf({ attributes }: Pick<GridData, 'attributes'>): string[] {
  return [attributes['status_message'] ?? '', ...(attributes['warnings'] ?? '').split('\n')].filter((text) => text !== '');
}

/** As a list; nothing where there are none. */
export function remarks(notes: string[]): HTMLElement[] {
  return notes.length > 0 ? [el('ul', { class: 'remarks' }, ...notes.map((note) => el('li', {}, `${note}.`)))] : [];
}
