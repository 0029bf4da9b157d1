import { BearingPanels } from '../bearing/panel';
import { player } from '../bearing/player';
import { energies, pathSection, stresses } from '../charts/along_path';
import { curvesOf, curvesOfRun } from '../charts/curves';
import { loadSection } from '../charts/loads';
import { LoopPanel } from '../charts/loops';
import { StatePanel } from '../charts/states';
import { sweptKeys } from '../data/case_values';
import type { CaseKeys } from '../data/format';
import { allKeys, at, type Run } from '../data/run';
import { caseSection } from '../tables/case';
import { resultTable } from '../tables/results';
import { Comparison } from '../ui/comparison';
import { el, tickBox } from '../ui/dom';
import { Selection } from '../ui/selection';
import { cards } from './cards';
import { runChooser } from './chooser';

/** The cycles of one run in one chart; of several in one for each direction, in the same axes. */
function loopPanels(comparison: Comparison, begun: number[]): LoopPanel[] {
  const run = at(comparison.runs, 0);
  if (!comparison.several) {
    const curves = curvesOfRun(run);
    return [new LoopPanel({ title: 'Loops', curves: () => curves, focus: () => curves }, comparison)];
  }
  return begun.map(
    (key) =>
      new LoopPanel(
        {
          title: `Loops, ${run.kind.cycles.name(key)}`,
          curves: () => curvesOf(comparison, key, comparison.shown),
          focus: () => curvesOf(comparison, key, comparison.focus),
        },
        comparison,
      ),
  );
}

/**
 * Sections of the report on cycles, of a bearing or of a strip, and the bar that moves along them.
 * @param alone  whether there is no other view, from whose sections these are to be told
 */
export function loopView(runs: Run[], caseKeys: CaseKeys, alone: boolean): HTMLElement[] {
  const { kind, data } = at(runs, 0);
  const keys = allKeys(runs);
  const selection = new Selection(runs);
  const comparison = new Comparison(selection, runs.length > 1 ? sweptKeys(runs, caseKeys) : []);
  const part = (name: string, title: string, ...children: Node[]): HTMLElement =>
    el('section', { id: `${data.kind}-${name}`, class: 'part', 'aria-labelledby': `${data.kind}-${name}-title` },
      el('h2', { id: `${data.kind}-${name}-title` }, alone || name === 'loops' ? title : `${title}, ${kind.name}`), ...children);
  const ends = [
    part('results', 'Results', resultTable(comparison, keys)),
    part('case', 'Case and origin', caseSection(comparison, caseKeys)),
  ];
  const begun = keys.filter((key) => runs.some((run) => (run.cycle(key)?.size ?? 0) > 0));
  if (begun.length === 0) return ends;
  const named = begun.map((key) => ({ key, name: kind.cycles.name(key) }));
  const cycles = loopPanels(comparison, begun);
  const bearing = new BearingPanels(selection);
  const section = stresses(comparison.shownLoops);
  const sameAxes = comparison.several
    ? []
    : [el('div', { class: 'tools' }, tickBox('Same axes in compared charts', true, (same) => comparison.set({ ownAxes: !same })))];
  return [
    player(selection, comparison),
    part(
      'loops',
      kind.title,
      ...(comparison.several ? [runChooser(comparison)] : []),
      cards(keys, comparison),
      el(
        'div',
        { class: 'beside' },
        el('div', { class: comparison.several ? 'multiples' : 'single' }, ...cycles.map((cycle) => cycle.root)),
        el('div', { class: 'in-sight' }, kind.flat ? bearing.unwrapped : bearing.round),
      ),
      ...(kind.flat ? [] : [bearing.unwrapped]),
    ),
    part('loads', 'Bump loads', ...sameAxes, loadSection(named, comparison)),
    part('contacts', 'Contacts', new StatePanel(selection).root),
    part('energies', 'Energies along the path', pathSection(energies, named, comparison)),
    ...(section.quantities.length > 0 ? [part('stresses', 'Stress along the path', pathSection(section, named, comparison))] : []),
    ...ends,
  ];
}
