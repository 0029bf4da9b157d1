/** The main numbers of one direction in large letters, and by how much they differ from those before. */
import { mainQuantities, numbersAmong } from '../data/main_quantities';
import { at } from '../data/run';
import { differences, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { numberOf } from '../tables/results';
import type { Comparison } from '../ui/comparison';
import { el } from '../ui/dom';
import { roving } from '../ui/roving';

/** Number of tiles. */
const shown = 7;

export function numberTiles(keys: number[], comparison: Comparison): HTMLElement {
  const { selection } = comparison;
  const { kind } = at(comparison.runs, 0);
  const tiles = el('div', { class: 'tiles' });
  const buttons = keys.map((key) => {
    const button = el('button', { type: 'button' }, kind.cycles.name(key));
    button.addEventListener('click', () => selection.show({ key }));
    return button;
  });
  const fill = (): void => {
    const { key } = selection.cycle;
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(keys[i] === key)));
    const [now, before] = [at(comparison.runs, 0), comparison.runs[1]];
    const numbers = numbersAmong(now.quantities, (name) => now.cycles.map(({ summary }) => summary?.[name]));
    tiles.replaceChildren(
      ...mainQuantities(numbers, [], shown).map((quantity) => {
        const value = numberOf(now.cycle(key)?.summary?.[quantity.key]);
        const old = numberOf(before?.cycle(key)?.summary?.[quantity.key]);
        const [, percent] = before ? differences(value, old, scaleFor(Math.abs(old ?? 0), quantity.unit)) : ['', ''];
        return el(
          'div',
          { class: 'tile', 'data-key': quantity.key, title: quantity.meaning },
          el('span', { class: 'what' }, quantity.label),
          el('strong', {}, quantity.unit === '' ? formatNumber(value, 3) : formatQuantity(value, quantity.unit)),
          el('span', { class: 'change' }, before ? (percent === '0 %' ? 'unchanged' : `${percent ?? ''} vs. baseline`) : ''),
        );
      }),
    );
  };
  comparison.onChange(fill);
  selection.onChange(fill);
  fill();
  return el(
    'div',
    { class: 'numbers' },
    roving(el('div', { class: 'choice', role: 'group', 'aria-label': `${kind.cycles.title} of the numbers and of the bearing` }, ...buttons)),
    tiles,
  );
}

/** A number in large letters, and what is said of it. */
export function tile(key: string, what: string, value: string, ...more: string[]): HTMLElement {
  const text = more.filter((one) => one !== '').join(', ');
  return el('div', { class: 'tile', 'data-key': key }, el('span', { class: 'what' }, what), el('strong', {}, value), el('span', { class: 'change' }, text));
}

/** Difference of a number from that of the baseline; empty where either is not known. */
export function compared(value: number, old: number): string {
  const [, percent] = differences(Number.isFinite(value) ? value : null, Number.isFinite(old) ? old : null, { factor: 1, unit: '' });
  return percent === '–' ? '' : percent === '0 %' ? 'unchanged' : `${percent} vs. baseline`;
}
