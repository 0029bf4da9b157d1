import { valueText } from '../data/case_values';
import type { Run } from '../data/run';
import { nameOf } from '../charts/curves';
import type { Comparison } from '../ui/comparison';
import { dropDown, el, tickBox } from '../ui/dom';
import { look, onLookChange, rampColour } from '../ui/theme';

/** From so many runs on, their list is searched. */
export const searched = 9;

/** "friction: coefficient 0.2", as it is searched for and shown beside the name. */
function familyText({ family }: Comparison, run: Run): string {
  const value = family?.values.get(run);
  if (!family || value === undefined) return '';
  return valueText(value, family.unit);
}

/** What the colours of a family stand for. */
export function familyScale(comparison: Comparison): HTMLElement[] {
  const { family } = comparison;
  if (!family) return [];
  const numbers = [...family.values.values()];
  const ends = [Math.min(...numbers), Math.max(...numbers)].map((number) => valueText(number, family.unit));
  const bar = el('span', { class: 'ramp', 'aria-hidden': 'true' });
  const stops = [0, 0.25, 0.5, 0.75, 1].map((fraction) => rampColour(look(), fraction));
  bar.style.background = `linear-gradient(to right, ${stops.join(', ')})`;
  return [el('span', {}, `${family.title} ${ends[0] ?? ''}`), bar, el('span', {}, ends[1] ?? '')];
}

/** Which runs are shown, with what they are compared, and what their colours stand for. */
export function runChooser(comparison: Comparison): HTMLElement {
  const { runs, families } = comparison;
  const boxes = runs.map((run) => {
    const box = el('input', { type: 'checkbox' });
    box.addEventListener('change', () => comparison.show(runs.filter((one) => (one === run ? box.checked : comparison.isShown(one)))));
    const colour = el('span', { class: 'key' });
    const words = el('span', {});
    return { run, box, colour, words, root: el('label', { class: 'control' }, box, colour, words) };
  });
  // No output element: these take the click from a summary.
  const count = el('span', { class: 'count', role: 'status' });
  const scalePlace = el('span', { class: 'scale' });
  const search = el('input', { type: 'search', placeholder: 'Search runs', 'aria-label': 'Search runs' });
  const matching = (): typeof boxes => {
    const words = search.value.toLowerCase().split(/\s+/);
    return boxes.filter(({ run }) => {
      const text = `${run.label} ${run.data.summary.solver} ${familyText(comparison, run)} ${run.outcome}`.toLowerCase();
      return words.every((word) => text.includes(word));
    });
  };
  const filter = (): void => {
    const found = new Set(matching());
    for (const one of boxes) one.root.hidden = !found.has(one);
    tell();
  };
  const tell = (): void => {
    const found = matching().length;
    count.textContent = `${comparison.shown.length} of ${runs.length} shown${found < runs.length ? `, ${found} found` : ''}`;
  };
  search.addEventListener('input', filter);
  const button = (text: string, choose: () => Run[]): HTMLElement => {
    const one = el('button', { type: 'button', class: 'quiet' }, text);
    one.addEventListener('click', () => comparison.show(choose()));
    return one;
  };
  const refresh = (): void => {
    for (const { run, box, colour, words } of boxes) {
      box.checked = comparison.isShown(run);
      colour.style.backgroundColor = comparison.colour(run, look());
      words.textContent = [nameOf(comparison, run), familyText(comparison, run), run.outcome].filter((text) => text !== '').join(' · ');
    }
    scalePlace.replaceChildren(...familyScale(comparison));
    tell();
  };
  const colours = dropDown(
    'Colours of runs',
    [{ value: undefined, text: 'one for each run' }, ...families.map((value) => ({ value, text: value.title }))],
    (family) => comparison.set({ family }),
  );
  colours.selectedIndex = comparison.family ? 1 + families.indexOf(comparison.family) : 0;
  const long = runs.length >= searched;
  const list = el(
    'details',
    {},
    el('summary', {}, 'Runs: ', count),
    el('div', { class: 'tools' }, search, button('Show those found', () => matching().map(({ run }) => run)), button('Show all', () => runs)),
    el('div', { class: 'run-list', role: 'group', 'aria-label': 'Runs' }, ...(long ? boxes.map(({ root }) => root) : [])),
  );
  comparison.onChange(refresh);
  onLookChange(refresh);
  refresh();
  return el(
    'section',
    { class: 'chooser', 'aria-label': 'Runs compared' },
    el(
      'div',
      { class: 'tools' },
      ...(long ? [list] : []),
      ...(families.length > 0 ? [el('label', { class: 'control' }, 'Colours', colours), scalePlace] : []),
      ...(long ? [] : [...boxes.map(({ root }) => root)]),
      tickBox('Same axes in compared charts', true, (same) => comparison.set({ ownAxes: !same })),
    ),
  );
}
