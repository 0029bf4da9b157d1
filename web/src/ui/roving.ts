/** Groups that take one stop of the Tab key: arrows, Home and End move within them. */

function targetOf(key: string, place: number, count: number): number | undefined {
  switch (key) {
    case 'ArrowRight':
    case 'ArrowDown':
      return (place + 1) % count;
    case 'ArrowLeft':
    case 'ArrowUp':
      return (place - 1 + count) % count;
    case 'Home':
      return 0;
    case 'End':
      return count - 1;
    default:
      return undefined;
  }
}

/** Tab reaches the item last focused or chosen, at first the one that is pressed, or else the first. */
export function roving<E extends HTMLElement>(group: E): E {
  const items = (): HTMLElement[] => [...group.querySelectorAll<HTMLElement>('button, a')];
  const stopAt = (stop: HTMLElement | undefined): void => {
    for (const item of items()) item.tabIndex = item === stop ? 0 : -1;
  };
  group.addEventListener('keydown', (event) => {
    const all = items();
    const place = all.indexOf(document.activeElement as HTMLElement);
    const target = place < 0 ? undefined : targetOf(event.key, place, all.length);
    if (target === undefined) return;
    event.preventDefault();
    all[target]?.focus();
  });
  group.addEventListener('focusin', (event) => stopAt(event.target as HTMLElement));
  const all = items();
  stopAt(all.find((item) => item.getAttribute('aria-pressed') === 'true') ?? all[0]);
  return group;
}
