import { at, type Loop, type Run } from '../data/run';

/** What the reader looks at: a run, one of its directions, and an increment of that. All views follow it. */
export class Selection {
  run: Run;
  loop: Loop;
  /** Of the increments kept. */
  index: number;
  private readonly listeners: (() => void)[] = [];

  constructor(readonly runs: Run[]) {
    this.run = runs.find((run) => run.loops.some((loop) => loop.size > 0)) ?? at(runs, 0);
    this.loop = this.run.loops.find((loop) => loop.size > 0) ?? at(this.run.loops, 0);
    this.index = this.loop.turning;
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Shows an increment; the same part of the way when run or direction change alone. */
  show({ run = this.run, key = this.loop.key, index }: { run?: Run; key?: number; index?: number }): void {
    const loop = run.loop(key) ?? at(run.loops, 0);
    const wanted = index ?? this.sameWay(loop);
    this.run = run;
    this.loop = loop;
    this.index = Math.min(Math.max(0, wanted), Math.max(0, loop.size - 1));
    for (const listener of this.listeners) listener();
  }

  /** The increment of another loop at the same part of the way. */
  indexIn(loop: Loop): number {
    return Math.min(this.sameWay(loop), Math.max(0, loop.size - 1));
  }

  private sameWay(loop: Loop): number {
    if (loop === this.loop || this.loop.size === 0) return this.index;
    const way = at(this.loop.increments, this.index) / Math.max(1, this.loop.steps);
    const next = loop.increments.findIndex((increment) => increment >= way * loop.steps);
    return next >= 0 ? next : loop.size - 1;
  }
}
