import { shortfallOf } from '../data/outcome';
import type { Quantity } from '../data/format';
import { mainQuantities, numbersAmong } from '../data/main_quantities';
import { at, type Cycle, type Run } from '../data/run';
import { formatNumber, formatQuantity } from '../data/units';
import type { Comparison } from '../ui/comparison';
import { el } from '../ui/dom';
import { roving } from '../ui/roving';
import { look, onLookChange } from '../ui/theme';
import { numberOf } from '../tables/results';
import { curvesOfRun } from '../charts/curves';

/** Number of quantities on a card, the first in large letters; fewer for several runs, which are side by side. */
const shown = { one: 4, several: 3 };

function quantitiesOf(runs: Run[], several: boolean): Quantity[] {
  const all = runs.flatMap((run) => numbersAmong(run.quantities, (key) => run.cycles.map(({ summary }) => summary?.[key])));
  const unique = all.filter((quantity, i) => all.findIndex(({ key }) => key === quantity.key) === i);
  return mainQuantities(unique, [], several ? shown.several : shown.one);
}

function valueText(run: Run, cycle: Cycle, { key, unit }: Quantity): string {
  const has = run.quantities.some((quantity) => quantity.key === key);
  const number = has ? numberOf(cycle.summary?.[key]) : null;
  return unit === '' ? formatNumber(number, 3) : formatQuantity(number, unit, 3);
}

/** The main results of one cycle; in columns where there are several runs. */
function result(comparison: Comparison, run: Run, cycle: Cycle, quantities: Quantity[]): HTMLElement {
  const { several } = comparison;
  const colour = el('span', { class: 'key' });
  const curve = curvesOfRun(run).find((one) => one.cycle === cycle);
  colour.style.backgroundColor = (several ? comparison.colour(run, look()) : curve?.colour(look())) ?? 'transparent';
  const shortfall = shortfallOf(run, cycle);
  const [first, ...rest] = quantities.map((quantity) => ({ quantity, text: valueText(run, cycle, quantity) }));
  const small = rest.map(({ quantity: { label, meaning }, text }) =>
    el('span', { title: meaning }, several ? text : `${label} `, ...(several ? [] : [el('span', { class: 'value' }, text)])),
  );
  return el(
    'span',
    { class: 'result' },
    el('span', { class: 'who' }, colour, several ? run.label : cycle.name),
    el('strong', { title: first ? `${first.quantity.label}: ${first.quantity.meaning}` : '' }, first?.text ?? '–'),
    ...(several ? small : [el('small', { class: 'headline' }, first?.quantity.label ?? ''), el('small', {}, ...small)]),
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
      const quantities = quantitiesOf(comparison.focus, several);
      const results = comparison.focus.flatMap((run) => {
        const cycle = run.cycle(key);
        return cycle ? [result(comparison, run, cycle, quantities)] : [];
      });
      card.style.setProperty('--columns', String(quantities.length));
      const columns = quantities.map(({ label }) => el('span', { class: 'column' }, label));
      const heading = several ? [el('span', { class: 'heading' }, kind.cycles.name(key)), ...columns] : [];
      card.replaceChildren(...heading, ...results);
    };
    const follow = (): void => card.setAttribute('aria-pressed', String(key === selection.cycle.key));
    comparison.onChange(fill);
    onLookChange(fill);
    selection.onChange(follow);
    fill();
    follow();
    return card;
  });
  return roving(el('div', { class: 'cards', role: 'group', 'aria-label': `${kind.cycles.title}: main results` }, ...buttons));
}
