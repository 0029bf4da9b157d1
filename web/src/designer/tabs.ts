import { el } from '../ui/dom';

interface Tab {
  name: string;
  title: string;
  body: HTMLElement;
  /** Told when it comes into sight. */
  shown?: () => void;
}

/** Whether it is on the page, and no other tab in its place. Nothing is laid out for that. */
export function isSeen(element: HTMLElement): boolean {
  return element.isConnected && element.closest('[hidden]') === null;
}

/** The one last chosen, so that it stays when the views are made anew. */
let chosen = '';

/** Views of which one is shown, the first unless one was chosen; arrows, Home and End go from tab to tab. */
export function tabs(all: Tab[]): HTMLElement {
  const buttons = all.map(({ name, title }) => el('button', { type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `view-${name}` }, title));
  const bodies = all.map(({ name, body }) => el('section', { role: 'tabpanel', id: `view-${name}`, 'aria-labelledby': `tab-${name}` }, body));
  const show = (place: number): void => {
    buttons.forEach((button, i) => {
      button.setAttribute('aria-selected', String(i === place));
      button.tabIndex = i === place ? 0 : -1;
    });
    bodies.forEach((body, i) => (body.hidden = i !== place));
    all[place]?.shown?.();
  };
  const choose = (place: number): void => {
    chosen = all[place]?.name ?? '';
    show(place);
  };
  buttons.forEach((button, i) => {
    button.addEventListener('click', () => choose(i));
    button.addEventListener('keydown', ({ key }) => {
      const last = buttons.length - 1;
      const to = { ArrowRight: i === last ? 0 : i + 1, ArrowLeft: i === 0 ? last : i - 1, Home: 0, End: last }[key];
      if (to === undefined) return;
      choose(to);
      buttons[to]?.focus();
    });
  });
  show(Math.max(0, all.findIndex(({ name }) => name === chosen)));
  return el('div', { class: 'tabs' }, el('div', { class: 'tab-list', role: 'tablist', 'aria-label': 'Results' }, ...buttons), ...bodies);
}
