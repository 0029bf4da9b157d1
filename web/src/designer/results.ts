/** What the design does, beside what the one before did: loops, bearing, loads and numbers. */
import { BearingPanels } from '../bearing/panel';
import { player } from '../bearing/player';
import { curvesOfRun, type Curve } from '../charts/curves';
import { loadSection } from '../charts/loads';
import { LoopPanel } from '../charts/loops';
import { allKeys, at, type Run } from '../data/run';
import { warningsOf } from '../data/outcome';
import { resultTable } from '../tables/results';
import { inTwoSteps } from '../ui/afterwards';
import { Comparison } from '../ui/comparison';
import { el, svg } from '../ui/dom';
import { Selection } from '../ui/selection';
import { remarks } from './remarks';
import { numberTiles } from './tiles';

/** The loops of the baseline: pale, without marks. */
function ghosts(run: Run | undefined): Curve[] {
  if (!run) return [];
  return curvesOfRun(run).map((curve) => ({ ...curve, colour: (current) => current.muted }));
}

/** What decides on how the views are laid out: where it changes they are made anew. */
export function layoutOf(runs: Run[]): string {
  return JSON.stringify(runs.map((run) => [allKeys([run]), run.interfaces.map(({ name }) => name)]));
}

export interface Results {
  root: HTMLElement;
  /** Shows others of the same layout, what is above the fold first. @return what draws the rest */
  show: (runs: Run[]) => () => void;
  readonly comparison: Comparison;
}

/** @param runs  the design, and the one before where there is any */
export function results(runs: Run[]): Results {
  const selection = new Selection(runs);
  const comparison = new Comparison(selection, []);
  comparison.set({ reference: at(runs, runs.length - 1) });
  const keys = allKeys(runs);
  const named = keys.map((key) => ({ key, name: at(runs, 0).kind.cycles.name(key) }));
  const loops = new LoopPanel(
    {
      title: 'Loops',
      curves: () => [...curvesOfRun(at(comparison.runs, 0)), ...ghosts(comparison.runs[1])],
      focus: () => curvesOfRun(at(comparison.runs, 0)),
      legend: () =>
        comparison.several
          ? [{ width: 26, draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 26, y2: 6, stroke: current.muted, 'stroke-width': 1.1 })], text: 'baseline' }]
          : [],
    },
    comparison,
  );
  const bearing = new BearingPanels(selection);
  const notes = el('div', { class: 'notes', role: 'status' });
  const warn = (): void => notes.replaceChildren(...remarks(warningsOf(at(comparison.runs, 0))));
  comparison.onChange(warn);
  warn();
  return {
    root: el(
      'div',
      { class: 'loops' },
      numberTiles(keys, comparison),
      notes,
      el('div', { class: 'views' }, loops.root, bearing.round),
      loadSection(named, comparison),
      bearing.unwrapped,
      resultTable(comparison, keys),
      // At the foot of the window.
      player(selection, comparison),
    ),
    show: (next) => inTwoSteps(() => comparison.replace(next, at(next, next.length - 1))),
    comparison,
  };
}
