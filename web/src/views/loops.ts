import { BearingPanels } from '../bearing/panel';
import { player } from '../bearing/player';
import { energies, padForces, pathSection, stresses } from '../charts/along_path';
import { curvesOf, curvesOfRun } from '../charts/curves';
import { loadSection } from '../charts/loads';
import { LoopPanel } from '../charts/loops';
import { StatePanel } from '../charts/states';
import { sweptKeys } from '../data/case_values';
import type { CaseKeys, ResultData, RunData } from '../data/format';
import { shortfallsOf, thinningOf, warningsOf } from '../data/outcome';
import { allKeys, at, Run } from '../data/run';
import { caseSection, type ComparedCases } from '../tables/case';
import { entriesOf } from '../tables/glossary';
import { resultTable } from '../tables/results';
import { Comparison } from '../ui/comparison';
import { el, tickBox } from '../ui/dom';
import { Selection } from '../ui/selection';
import { cards } from './cards';
import { runChooser, searched } from './chooser';
import { part as section, type View } from './view';

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

/** What was measured has no case. */
function casesOf(comparison: Comparison): ComparedCases {
  return {
    several: comparison.selection.runs.length > 1,
    get focus() {
      return comparison.focusFoils;
    },
    get shown() {
      return comparison.shownFoils;
    },
    get names() {
      return comparison.many ? comparison.names : comparison.shownFoils.map(({ label }) => label).join(', ');
    },
    onChange: (listener) => comparison.onChange(listener),
  };
}

/** Many runs that stand as file names are sorted, in the order of the numbers in their names: mu2 before mu10. */
function inOrder(runs: Run[]): Run[] {
  const asListed = runs.length >= searched && runs.every((run, i) => i === 0 || at(runs, i - 1).label <= run.label);
  return asListed ? [...runs].sort((a, b) => a.label.localeCompare(b.label, 'en', { numeric: true })) : runs;
}

/** Cycles, of a bearing or of a strip; runs of one kind are compared, with each other and with measured loops. */
export function loopView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const runs = results.map((data) => new Run(data as RunData));
  return {
    sections: sectionsOf(
      inOrder(runs.filter((run) => !run.isMeasured)),
      runs.filter((run) => run.isMeasured),
      caseKeys,
      alone,
    ),
    warnings: runs.map((run) => warningsOf(run)),
    entries: entriesOf(runs),
  };
}

/** Sections on cycles, and the bar that moves along them. */
function sectionsOf(runs: Run[], measured: Run[], caseKeys: CaseKeys, alone: boolean): HTMLElement[] {
  const { kind, data } = at(runs, 0);
  const keys = allKeys(runs);
  const selection = new Selection(runs);
  const comparison = new Comparison(selection, runs.length > 1 ? sweptKeys(runs, caseKeys) : [], measured);
  const part = (name: string, title: string, ...children: Node[]): HTMLElement =>
    section(`${data.kind}-${name}`, alone || name === 'loops' ? title : `${title}, ${kind.name}`, ...children);
  const ends = [
    part('results', 'Results', resultTable(comparison, keys)),
    part('case', 'Case and origin', caseSection(casesOf(comparison), caseKeys, {
    shortfalls: (run) => shortfallsOf(run as Run),
    note: runs.length > 1 ? 'Rows in which the runs differ are marked.' : '',
  })),
  ];
  const begun = keys.filter((key) => runs.some((run) => (run.cycle(key)?.size ?? 0) > 0));
  if (begun.length === 0) return ends;
  const named = begun.map((key) => ({ key, name: kind.cycles.name(key) }));
  const cycles = loopPanels(comparison, begun);
  const bearing = new BearingPanels(selection);
  const stress = stresses(comparison.shownLoops);
  const thinning = thinningOf(runs);
  const pads = Math.max(...runs.map((run) => run.pads));
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
      ...(thinning === '' ? [] : [el('p', { class: 'note thinning' }, thinning)]),
      ...(kind.flat ? [] : [bearing.unwrapped]),
    ),
    part('loads', 'Bump loads', ...sameAxes, loadSection(named, comparison)),
    ...(pads > 1 ? [part('pads', 'Forces of the pads along the path', pathSection(padForces(pads), named, comparison))] : []),
    part('contacts', 'Contacts', new StatePanel(selection).root),
    part('energies', 'Energies along the path', pathSection(energies, named, comparison)),
    ...(stress.quantities.length > 0 ? [part('stresses', 'Stress along the path', pathSection(stress, named, comparison))] : []),
    ...ends,
  ];
}
