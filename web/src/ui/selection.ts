import { at, type Cycle, type Run } from '../data/run';

/** What the reader looks at: a run, one of its directions, and an increment of that. All views follow it. */
export class Selection {
  run: Run;
  cycle: Cycle;
  /** Of the increments kept. */
  index: number;
  private readonly listeners: (() => void)[] = [];

  constructor(public runs: Run[]) {
    this.run = runs.find((run) => run.cycles.some((cycle) => cycle.size > 0)) ?? at(runs, 0);
    this.cycle = this.run.cycles.find((cycle) => cycle.size > 0) ?? at(this.run.cycles, 0);
    this.index = this.cycle.turning;
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Shows an increment; the same part of the way when run or direction change alone. */
  show({ run = this.run, key = this.cycle.key, index }: { run?: Run; key?: number; index?: number }): void {
    this.look(run, key, index);
    this.tell();
  }

  private look(run: Run, key: number, index?: number): void {
    const cycle = run.cycle(key) ?? at(run.cycles, 0);
    const wanted = index ?? this.sameWay(cycle);
    this.run = run;
    this.cycle = cycle;
    this.index = Math.min(Math.max(0, wanted), Math.max(0, cycle.size - 1));
  }

  /** Looks at other runs, each in the place of one, in the same way as before. Listeners hear of it when tell() is called. */
  replace(runs: Run[]): void {
    const run = at(runs, Math.min(this.runs.indexOf(this.run), runs.length - 1));
    this.runs = runs;
    this.look(run, this.cycle.key);
  }

  tell(): void {
    for (const listener of this.listeners) listener();
  }

  /** The increment of another cycle at the same part of the way. */
  indexIn(cycle: Cycle): number {
    return Math.min(this.sameWay(cycle), Math.max(0, cycle.size - 1));
  }

  private sameWay(cycle: Cycle): number {
    if (cycle === this.cycle || this.cycle.size === 0) return this.index;
    const way = at(this.cycle.increments, this.index) / Math.max(1, this.cycle.steps);
    const next = cycle.increments.findIndex((increment) => increment >= way * cycle.steps);
    return next >= 0 ? next : cycle.size - 1;
  }
}
