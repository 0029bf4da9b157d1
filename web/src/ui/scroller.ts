import { el, type Child } from './dom';

/** What may be wider than its place: it scrolls sideways, and says so where there is more to be seen. */
export function scroller(label: string, ...children: Child[]): HTMLElement {
  const root = el('div', { class: 'scroller', tabindex: 0, role: 'group', 'aria-label': label }, ...children);
  const follow = (): void => void root.classList.toggle('wide', root.scrollWidth > root.clientWidth + 1);
  new ResizeObserver(follow).observe(root);
  // What is in it may change its width.
  new MutationObserver(follow).observe(root, { childList: true });
  return root;
}
