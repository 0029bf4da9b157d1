import { BearingPanels } from '../bearing/panel';
import { player } from '../bearing/player';
import { energySection } from '../charts/energies';
import { loadSection } from '../charts/loads';
import { curveColour, LoopPanel, type Curve } from '../charts/loops';
import { StatePanel } from '../charts/states';
import { allDirections, at, directionName, type Run } from '../data/run';
import { formatQuantity } from '../data/units';
import { caseTable, provenance } from '../tables/case';
import { resultTable } from '../tables/results';
import { el } from '../ui/dom';
import { Selection } from '../ui/selection';
import { onLookChange } from '../ui/theme';

/** Curves of each direction: by run where there are several, in the direction's own colour where there is one. */
function curvesByDirection(runs: Run[], degrees: number[]): Curve[][] {
  return degrees.map((angle, place) =>
    runs.flatMap((run, i) => {
      const direction = run.direction(angle);
      if (!direction || direction.size === 0) return [];
      return runs.length > 1
        ? [{ run, direction, label: run.label, style: i }]
        : [{ run, direction, label: direction.name, style: place }];
    }),
  );
}

/** Buttons with the main results of each direction, which choose it. */
function directionCards(groups: Curve[][], selection: Selection): HTMLElement {
  const cards = groups
    .filter((curves) => curves.length > 0)
    .map((curves) => {
      const { direction } = at(curves, 0);
      const results = curves.map(({ run, direction: one, label, style }) => {
        const result = (key: string): number | null => {
          const value = one.summary?.[key];
          return typeof value === 'number' ? value : null;
        };
        const colour = el('span', { class: 'key' });
        const paint = (): void => void (colour.style.backgroundColor = curveColour(style));
        paint();
        onLookChange(paint);
        return el(
          'span',
          { class: 'result' },
          el('span', { class: 'who' }, colour, selection.runs.length > 1 ? run.label : label),
          el('strong', {}, formatQuantity(result('max_force_N'), 'N', 3)),
          el('small', {}, `${formatQuantity(result('secant_stiffness_N_per_m'), 'N/m', 3)} · loss ${result('loss_factor')?.toFixed(3) ?? '–'}`),
        );
      });
      const heading = selection.runs.length > 1 ? [el('span', { class: 'heading' }, direction.name)] : [];
      const card = el('button', { type: 'button', class: 'card' }, ...heading, ...results);
      card.addEventListener('click', () => selection.show({ degrees: direction.degrees }));
      const follow = (): void => card.setAttribute('aria-pressed', String(direction.degrees === selection.direction.degrees));
      selection.onChange(follow);
      follow();
      return card;
    });
  return el('div', { class: 'cards', role: 'group', 'aria-label': 'Directions: maximum force, secant stiffness, loss factor' }, ...cards);
}

function part(id: string, title: string, ...children: Node[]): HTMLElement {
  return el('section', { id, class: 'part' }, el('h2', {}, title), ...children);
}

/** Sections of the report on cycles, and the bar that moves along them. */
export function cycleView(runs: Run[]): HTMLElement[] {
  const degrees = allDirections(runs);
  const groups = curvesByDirection(runs, degrees);
  const begun = groups.some((curves) => curves.length > 0);
  const ends = [
    part('results', 'Results', resultTable(runs, degrees)),
    part('case', 'Case and origin', caseTable(runs), el('div', { class: 'multiples' }, ...runs.map(provenance))),
  ];
  if (!begun) return ends;
  const selection = new Selection(runs);
  const loops =
    runs.length > 1
      ? groups.filter((curves) => curves.length > 0).map((curves) => new LoopPanel(`Loops, ${directionName(at(curves, 0).direction.degrees)}`, curves, selection))
      : [new LoopPanel('Loops', groups.flat(), selection)];
  const bearing = new BearingPanels(selection);
  const loopsPlace = el('div', { class: runs.length > 1 ? 'multiples' : '' }, ...loops.map((loop) => loop.root));
  return [
    part(
      'loops',
      'Loops and bearing',
      directionCards(groups, selection),
      ...(runs.length > 1
        ? [loopsPlace, el('div', { class: 'pair wide-right' }, bearing.round, bearing.unwrapped)]
        : [el('div', { class: 'pair' }, loopsPlace, bearing.round), bearing.unwrapped]),
    ),
    part('loads', 'Bump loads', loadSection(groups, selection)),
    part('contacts', 'Contacts', new StatePanel(selection).root),
    part('energies', 'Energies along the path', energySection(groups, selection)),
    ...ends,
    player(selection),
  ];
}
