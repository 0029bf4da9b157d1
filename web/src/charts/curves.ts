import { valueText } from '../data/case_values';
import { at, type Cycle, type Run } from '../data/run';
import type { Comparison } from '../ui/comparison';
import { svg } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { markers, rampColour, type Look } from '../ui/theme';

/** One cycle: a direction of a run, and how it is told from others of its chart. */
export interface Curve {
  run: Run;
  cycle: Cycle;
  label: string;
  colour: (current: Look) => string;
  marker: (typeof markers)[number];
  dash: 'solid' | number[];
}

const dashes: Curve['dash'][] = ['solid', [7, 3], [2, 2], [9, 3, 2, 3]];

/** The curves of some runs in one direction, told apart by run. */
export function curvesOf(comparison: Comparison, key: number, runs: Run[]): Curve[] {
  return runs.flatMap((run, i) => {
    const cycle = run.cycle(key);
    if (!cycle || cycle.size === 0) return [];
    const place = comparison.runs.indexOf(run);
    return [
      {
        run,
        cycle,
        label: run.label,
        colour: (current: Look) => comparison.colour(run, current),
        marker: at(markers, place % markers.length),
        dash: at(dashes, i % dashes.length),
      },
    ];
  });
}

/** The curves of one run, told apart by direction. */
export function curvesOfRun(run: Run): Curve[] {
  return run.cycles.flatMap((cycle, place) =>
    cycle.size === 0
      ? []
      : [
          {
            run,
            cycle,
            label: cycle.name,
            colour: (current: Look) => at(current.series, place % current.series.length),
            marker: at(markers, place % markers.length),
            dash: 'solid' as const,
          },
        ],
  );
}

export function colourSample(colour: (current: Look) => string, text: string): LegendEntry {
  return { width: 14, draw: (current) => [svg('rect', { x: 1, y: 1, width: 12, height: 10, rx: 2, fill: colour(current) })], text };
}

/** The colours of a family, with what they stand for. */
function familySample({ family }: Comparison): LegendEntry[] {
  if (!family) return [];
  const numbers = [...family.values.values()];
  const [least, most] = [Math.min(...numbers), Math.max(...numbers)].map((number) => valueText(number, family.unit));
  const pieces = Array.from({ length: 20 }, (_, i) => i);
  return [
    {
      width: 60,
      draw: (current) => pieces.map((i) => svg('rect', { x: 3 * i, y: 1, width: 3.2, height: 10, fill: rampColour(current, i / 19) })),
      text: `${family.title} ${least ?? ''} to ${most ?? ''}`,
    },
  ];
}

/** What tells the runs in focus apart, and the others as a family. */
export function runLegend(comparison: Comparison, runs = comparison.focus): LegendEntry[] {
  if (!comparison.several) return [];
  return [...runs.map((run) => colourSample((current) => comparison.colour(run, current), nameOf(comparison, run))), ...familySample(comparison)];
}

export function nameOf(comparison: Comparison, run: Run): string {
  return run === comparison.reference && comparison.shown.length > 1 ? `${run.label} (reference)` : run.label;
}
