/** The loops of a case, half of the directions in each of two workers. */
import { at } from '../data/run';
import type { CyclesAnswer, Faults } from './format';
import { isFaulty, type Solver } from './solver';

const parts = 2;

/** The answer; nothing where a later case came first. */
export async function askLoops(solver: Solver, text: string): Promise<CyclesAnswer | Faults | undefined> {
  const requests = Array.from({ length: parts }, (_, number) => ({ what: 'cycles', text, part: [number, parts] }));
  const answers = await solver.askTogether<CyclesAnswer>(requests);
  if (!answers) return undefined;
  return answers.find(isFaulty) ?? joined(answers.filter((answer): answer is CyclesAnswer => !isFaulty(answer)));
}

/** What is not of single directions all of them have alike, but for how they ended. */
function joined(answers: CyclesAnswer[]): CyclesAnswer {
  const runs = answers.map(({ run }) => run);
  const { summary, ...rest } = runs.find((run) => run.summary.status !== 'complete') ?? at(runs, 0);
  return { run: { ...rest, summary: { ...summary, cycles: runs.flatMap((run) => run.summary.cycles) }, cycles: runs.flatMap((run) => run.cycles) } };
}
