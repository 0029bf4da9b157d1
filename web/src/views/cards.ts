import { shortfallOf } from '../data/outcome';
import type { Quantity } from '../data/format';
import { at, type Loop, type Run } from '../data/run';
import { formatNumber, formatQuantity } from '../data/units';
import type { Comparison } from '../ui/comparison';
import { el } from '../ui/dom';
import { roving } from '../ui/roving';
import { look, onLookChange } from '../ui/theme';
import { numberOf } from '../tables/results';
import { curvesOfRun } from '../charts/curves';

/** What cards tell, those of it that the results have; the first in large letters. */
const told = ['max_force', 'secant_stiffness', 'loss_factor'];

function quantitiesOf(run: Run): Quantity[] {
  return told.flatMap((name) => run.data.quantities.find((quantity) => quantity.name === name) ?? []);
}

function valueText({ key, unit }: Quantity, loop: Loop): string {
  const number = numberOf(loop.summary?.[key]);
  return unit === '' ? formatNumber(number, 3) : formatQuantity(number, unit, 3);
}

/** The main results of one loop; in columns where there are several runs. */
function result(comparison: Comparison, run: Run, loop: Loop): HTMLElement {
  const { several } = comparison;
  const colour = el('span', { class: 'key' });
  const curve = curvesOfRun(run).find((one) => one.loop === loop);
  colour.style.backgroundColor = (several ? comparison.colour(run, look()) : curve?.colour(look())) ?? 'transparent';
  const shortfall = shortfallOf(run, loop);
  const [first, ...rest] = quantitiesOf(run).map((quantity) => ({ quantity, text: valueText(quantity, loop) }));
  const small = rest.map(({ quantity, text }) => el('span', { title: quantity.meaning }, several ? text : `${quantity.label} ${text}`));
  return el(
    'span',
    { class: 'result' },
    el('span', { class: 'who' }, colour, several ? run.label : loop.name),
    el('strong', { title: first?.quantity.meaning ?? '' }, first?.text ?? '–'),
    ...(several ? small : [el('small', {}, ...small)]),
    ...(shortfall === undefined ? [] : [el('small', { class: 'shortfall' }, shortfall.split(':')[0] ?? '')]),
  );
}

/** Buttons with the main results of each direction or cycle, which choose it. */
export function cards(keys: number[], comparison: Comparison): HTMLElement {
  const { selection, several } = comparison;
  const { kind } = at(comparison.runs, 0);
  const buttons = keys.map((key) => {
    const card = el('button', { type: 'button', class: several ? 'card several' : 'card' });
    card.addEventListener('click', () => selection.show({ key }));
    const fill = (): void => {
      const results = comparison.focus.flatMap((run) => {
        const loop = run.loop(key);
        return loop ? [result(comparison, run, loop)] : [];
      });
      const columns = quantitiesOf(comparison.reference).map(({ label }) => el('span', { class: 'column' }, label));
      const heading = several ? [el('span', { class: 'heading' }, kind.loops.name(key)), ...columns] : [];
      card.replaceChildren(...heading, ...results);
    };
    const follow = (): void => card.setAttribute('aria-pressed', String(key === selection.loop.key));
    comparison.onChange(fill);
    onLookChange(fill);
    selection.onChange(follow);
    fill();
    follow();
    return card;
  });
  return roving(el('div', { class: 'cards', role: 'group', 'aria-label': `${kind.loops.title}: maximum force and other main results` }, ...buttons));
}
