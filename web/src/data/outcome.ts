/** How runs and their cycles ended, in words. */
import type { CycleSummary, GridData } from './format';
import type { Result } from './result';
import { at, type Cycle, type Run } from './run';
import { formatQuantity } from './units';

/** What keeps a cycle from being complete; undefined where nothing does. */
export function shortfallOf(run: Run, cycle: Cycle): string | undefined {
  const { summary, size, lastIncrement } = cycle;
  if (!summary) return run.data.summary.status === 'interrupted' ? 'not started: the run was interrupted' : 'not started';
  if (summary.converged) return undefined;
  const { status, failed_increment: failed, failed_displacement_m: displacement, reason } = summary;
  if (status === 'interrupted' || (status === undefined && run.data.summary.status === 'interrupted')) {
    return size === 0
      ? 'interrupted before the first increment'
      : `interrupted after increment ${at(cycle.increments, size - 1)} of ${lastIncrement}, ${formatQuantity(cycle.value('displacement', size - 1), 'm', 3)}`;
  }
  const why = typeof reason === 'string' ? `: ${reason}` : '';
  if (typeof failed !== 'number') return `failed${why}`;
  const where = typeof displacement === 'number' ? `, ${formatQuantity(displacement, 'm', 3)}` : '';
  return `failed at increment ${failed} of ${lastIncrement}${where}${why}`;
}

/** What keeps the cycles of a run from being complete. */
export function shortfallsOf(run: Run): string[] {
  return run.cycles.flatMap((cycle) => {
    const shortfall = shortfallOf(run, cycle);
    return shortfall === undefined ? [] : [`${cycle.name}: ${shortfall}`];
  });
}

/** Where the answer leaves what the model is valid for. */
function ownWarnings(summary: CycleSummary): string[] {
  return Array.isArray(summary['warnings']) ? summary['warnings'].map(String) : [];
}

/** That results are not all there. */
export function partialWarning({ outcome }: Result): string[] {
  return outcome === '' ? [] : [`The run ${outcome === 'failed' ? 'failed' : 'was interrupted'}; its results are partial.`];
}

/** Warnings of results that are not cycles: their files have them. */
export function gridWarnings(result: Result<GridData>): string[] {
  const messages = [result.attribute('status_message'), ...result.attribute('warnings').split('\n')];
  const { left_out: leftOut } = result.data;
  const missing = leftOut.length === 0 ? [] : [`Too large for a report, and left out: ${leftOut.join(', ')}.`];
  return [...partialWarning(result), ...messages.filter((text) => text !== '').map((text) => `${text}.`), ...missing];
}

/** Warnings of a run: each once, with the cycles that it concerns. */
export function warningsOf(run: Run): string[] {
  const saidOf = new Map<string, string[]>();
  for (const cycle of run.cycles) {
    const shortfall = shortfallOf(run, cycle);
    for (const text of [...(shortfall === undefined ? [] : [shortfall]), ...(cycle.summary ? ownWarnings(cycle.summary) : [])]) {
      saidOf.set(text, [...(saidOf.get(text) ?? []), cycle.name]);
    }
  }
  return [...partialWarning(run), ...[...saidOf].map(([text, names]) => `${names.join(', ')}: ${text}.`)];
}

/** That not all increments of the runs are there to be looked at; empty where they are. */
export function thinningOf(runs: Run[]): string {
  const strides = runs.flatMap(({ cycles }) => cycles.filter(({ size }) => size > 1).map(({ increments }) => at(increments, 1)));
  const [least, most] = [Math.min(...strides), Math.max(...strides)];
  if (!(most > 1)) return '';
  return `Of ${least > 1 ? 'all' : 'some'} loops one increment in ${least > 1 && least < most ? `${least} to ${most}` : most} is shown; result.nc has them all.`;
}
