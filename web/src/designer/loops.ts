/** The loops of a case, half of the directions in each of two workers. */
import { at } from '../data/run';
import type { CaseKey, CyclesAnswer, InputErrors } from './format';
import { isRefused, type Solver } from './solver';
import { outlineOf } from './toml';

const parts = 2;

/** Of a case that says nothing of cycles: those of the reference case. */
export function withCycle(text: string, keys: CaseKey[]): string {
  if (outlineOf(text).tables.has('cycle')) return text;
  const usual = keys.filter(({ path }) => path === 'cycle.directions' || path === 'cycle.amplitude');
  return `${text.replace(/\s*$/, '')}\n\n[cycle]\n${usual.map(({ path, value }) => `${path.replace('cycle.', '')} = ${JSON.stringify(value)}`).join('\n')}\n`;
}

/** The answer; nothing where a later case came first. */
export async function askLoops(solver: Solver, text: string): Promise<CyclesAnswer | InputErrors | undefined> {
  const requests = Array.from({ length: parts }, (_, number) => ({ what: 'cycles', text, part: [number, parts] }));
  const answers = await solver.askTogether<CyclesAnswer>(requests);
  if (!answers) return undefined;
  return answers.find(isRefused) ?? joined(answers.filter((answer): answer is CyclesAnswer => !isRefused(answer)));
}

/** What is not of single directions all of them have alike, but for how they ended. */
function joined(answers: CyclesAnswer[]): CyclesAnswer {
  const runs = answers.map(({ run }) => run);
  const { summary, ...rest } = runs.find((run) => run.summary.status !== 'complete') ?? at(runs, 0);
  return { run: { ...rest, summary: { ...summary, cycles: runs.flatMap((run) => run.summary.cycles) }, cycles: runs.flatMap((run) => run.cycles) } };
}
