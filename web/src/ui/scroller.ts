import { el, type Child } from './dom';
import { isPrinting, onPrint } from './theme';

/** What may be wider than its place: it scrolls sideways, and says so where there is more to be seen. */
export function scroller(label: string, ...children: Child[]): HTMLElement {
  const root = el('div', { class: 'scroller', tabindex: 0, role: 'group', 'aria-label': label }, ...children);
  const sizes = new ResizeObserver(() => void root.classList.toggle('wide', root.scrollWidth > root.clientWidth + 1));
  // Paper does not scroll: what is too wide for it is drawn smaller.
  const shrink = (): void => {
    root.style.zoom = '1';
    if (isPrinting()) root.style.zoom = String(Math.min(1, root.clientWidth / Math.max(1, root.scrollWidth)));
  };
  onPrint(shrink);
  const watch = (): void => {
    sizes.disconnect();
    for (const one of [root, ...root.children]) sizes.observe(one);
    if (isPrinting()) shrink();
  };
  watch();
  // What is in it may change. Sizes are looked at with the next layout, and force none.
  new MutationObserver(watch).observe(root, { childList: true });
  return root;
}
