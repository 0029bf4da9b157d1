import { BearingPanels } from '../bearing/panel';
import { player } from '../bearing/player';
import { energySection } from '../charts/energies';
import { loadSection } from '../charts/loads';
import { curveColour, LoopPanel, type Curve } from '../charts/loops';
import { StatePanel } from '../charts/states';
import type { CaseKeys } from '../data/format';
import { allKeys, at, type Run } from '../data/run';
import { formatQuantity } from '../data/units';
import { caseTable, provenance } from '../tables/case';
import { resultTable } from '../tables/results';
import { el } from '../ui/dom';
import { Selection } from '../ui/selection';
import { onLookChange } from '../ui/theme';

/** Curves of each direction or cycle: by run where there are several, in its own colour where there is one. */
function curvesByKey(runs: Run[], keys: number[]): Curve[][] {
  return keys.map((key, place) =>
    runs.flatMap((run, i) => {
      const loop = run.loop(key);
      if (!loop || loop.size === 0) return [];
      return runs.length > 1
        ? [{ run, loop, label: run.label, style: i }]
        : [{ run, loop, label: loop.name, style: place }];
    }),
  );
}

/** Buttons with the main results of each direction or cycle, which choose it. */
function loopCards(groups: Curve[][], selection: Selection): HTMLElement {
  const cards = groups
    .filter((curves) => curves.length > 0)
    .map((curves) => {
      const { loop } = at(curves, 0);
      const results = curves.map(({ run, loop: one, label, style }) => {
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
      const heading = selection.runs.length > 1 ? [el('span', { class: 'heading' }, loop.name)] : [];
      const card = el('button', { type: 'button', class: 'card' }, ...heading, ...results);
      card.addEventListener('click', () => selection.show({ key: loop.key }));
      const follow = (): void => card.setAttribute('aria-pressed', String(loop.key === selection.loop.key));
      selection.onChange(follow);
      follow();
      return card;
    });
  return el('div', { class: 'cards', role: 'group', 'aria-label': `${at(selection.runs, 0).kind.loops.title}: maximum force, secant stiffness, loss factor` }, ...cards);
}

/** Sections of the report on loops, of a bearing or of a strip, and the bar that moves along them. */
export function loopView(runs: Run[], caseKeys: CaseKeys): HTMLElement[] {
  const { kind, data } = at(runs, 0);
  const keys = allKeys(runs);
  const groups = curvesByKey(runs, keys);
  const part = (name: string, title: string, ...children: Node[]): HTMLElement =>
    el('section', { id: `${data.kind}-${name}`, class: 'part' }, el('h2', {}, title), ...children);
  const begun = groups.some((curves) => curves.length > 0);
  const ends = [
    part('results', 'Results', resultTable(runs, keys)),
    part('case', 'Case and origin', caseTable(runs, caseKeys), el('div', { class: 'multiples' }, ...runs.map(provenance))),
  ];
  if (!begun) return ends;
  const selection = new Selection(runs);
  const loops =
    runs.length > 1
      ? groups.filter((curves) => curves.length > 0).map((curves) => new LoopPanel(`Loops, ${at(curves, 0).loop.name}`, curves, selection))
      : [new LoopPanel('Loops', groups.flat(), selection)];
  const bearing = new BearingPanels(selection);
  const loopsPlace = el('div', { class: runs.length > 1 ? 'multiples' : '' }, ...loops.map((loop) => loop.root));
  const several = runs.length > 1;
  const arrangement = kind.flat
    ? [several ? loopsPlace : el('div', { class: 'narrow' }, loopsPlace), bearing.unwrapped]
    : several
      ? [loopsPlace, el('div', { class: 'pair wide-right' }, bearing.round, bearing.unwrapped)]
      : [el('div', { class: 'pair' }, loopsPlace, bearing.round), bearing.unwrapped];
  return [
    part(
      'loops',
      kind.title,
      loopCards(groups, selection),
      ...arrangement,
    ),
    part('loads', 'Bump loads', loadSection(groups, selection)),
    part('contacts', 'Contacts', new StatePanel(selection).root),
    part('energies', 'Energies along the path', energySection(groups, selection)),
    ...ends,
    player(selection),
  ];
}
