/** What is said of the case, beside its results; on a narrow page a sheet at the foot of the window, which is drawn up. */
import { el } from '../ui/dom';
import type { Form } from './fields';

export class Side {
  readonly root: HTMLElement;

  constructor(fields: Form, errors: HTMLElement) {
    const search = el('input', { type: 'search', placeholder: 'Search fields', 'aria-label': 'Search fields: key, title or unit' });
    const found = el('span', { class: 'unseen', role: 'status' });
    search.addEventListener('input', () => {
      const count = fields.search(search.value);
      found.textContent = search.value.trim() === '' ? '' : `${count} ${count === 1 ? 'field' : 'fields'} found`;
    });
    const fold = el('button', { type: 'button', class: 'quiet' }, 'Fold all');
    fold.addEventListener('click', () => {
      const open = fold.textContent !== 'Fold all';
      fields.fold(open);
      fold.textContent = open ? 'Fold all' : 'Unfold all';
    });
    const draw = el('button', { type: 'button', class: 'draw-up', 'aria-expanded': 'false', 'aria-controls': 'case-fields' }, 'The case');
    this.root = el('aside', { class: 'side', 'aria-label': 'The case' }, el('div', { class: 'side-head' }, draw, search, fold, found), el('div', { class: 'side-body', id: 'case-fields' }, errors, fields.root));
    const drawUp = (up: boolean): void => {
      this.root.classList.toggle('up', up);
      draw.setAttribute('aria-expanded', String(up));
    };
    draw.addEventListener('click', () => drawUp(!this.root.classList.contains('up')));
    search.addEventListener('focus', () => drawUp(true));
  }
}
