import { at, type Direction, type Run } from '../data/run';

/** What the reader looks at: a run, one of its directions, and an increment of that. All views follow it. */
export class Selection {
  run: Run;
  direction: Direction;
  /** Of the increments kept. */
  index: number;
  private readonly listeners: (() => void)[] = [];

  constructor(readonly runs: Run[]) {
    this.run = runs.find((run) => run.directions.some((direction) => direction.size > 0)) ?? at(runs, 0);
    this.direction = this.run.directions.find((direction) => direction.size > 0) ?? at(this.run.directions, 0);
    this.index = this.direction.turning;
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Shows an increment; the same part of the way when run or direction change alone. */
  show({ run = this.run, degrees = this.direction.degrees, index }: { run?: Run; degrees?: number; index?: number }): void {
    const direction = run.direction(degrees) ?? at(run.directions, 0);
    const wanted = index ?? this.sameWay(direction);
    this.run = run;
    this.direction = direction;
    this.index = Math.min(Math.max(0, wanted), Math.max(0, direction.size - 1));
    for (const listener of this.listeners) listener();
  }

  private sameWay(direction: Direction): number {
    if (direction === this.direction || this.direction.size === 0) return this.index;
    const way = at(this.direction.increments, this.index) / Math.max(1, this.direction.steps);
    const next = direction.increments.findIndex((increment) => increment >= way * direction.steps);
    return next >= 0 ? next : direction.size - 1;
  }
}
