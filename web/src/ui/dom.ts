import { roving } from './roving';

/** Elements are made here, and every text in them is a text node: nothing that a user wrote is ever parsed. */

export type Child = Node | string;
type Attributes = Record<string, string | number | boolean>;

function fill<E extends Element>(element: E, attributes: Attributes, children: Child[]): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) element.setAttribute(name, '');
    else if (value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  return fill(document.createElement(tag), attributes, children);
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  return fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

/** A group of buttons of which one is chosen. */
export function choice<T>(
  label: string,
  options: { value: T; text: string }[],
  chosen: T,
  choose: (value: T) => void,
): HTMLElement {
  const buttons = options.map(({ value, text }) => {
    const button = el('button', { type: 'button', 'aria-pressed': String(value === chosen) }, text);
    button.addEventListener('click', () => {
      for (const other of buttons) other.setAttribute('aria-pressed', String(other === button));
      choose(value);
    });
    return button;
  });
  return roving(el('div', { class: 'choice', role: 'group', 'aria-label': label }, ...buttons));
}

/** A box to tick, with its words. */
export function tickBox(text: string, ticked: boolean, change: (ticked: boolean) => void): HTMLLabelElement {
  const box = el('input', { type: 'checkbox', checked: ticked });
  box.addEventListener('change', () => change(box.checked));
  return el('label', { class: 'control' }, box, text);
}

/** A drop-down list. */
export function dropDown<T>(
  label: string,
  options: { value: T; text: string }[],
  choose: (value: T) => void,
): HTMLSelectElement {
  const list = el('select', { 'aria-label': label }, ...options.map(({ text }) => el('option', {}, text)));
  list.addEventListener('change', () => {
    const option = options[list.selectedIndex];
    if (option) choose(option.value);
  });
  return list;
}
