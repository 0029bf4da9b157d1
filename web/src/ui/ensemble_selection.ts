import type { Run } from '../data/run';

/** What the reader looks at of an ensemble: a direction, by its place, and one of the bearings that can be looked at. */
export class EnsembleSelection {
  direction = 0;
  private readonly listeners: (() => void)[] = [];

  constructor(public run: Run | undefined) {}

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  show({ direction = this.direction, run = this.run }: { direction?: number; run?: Run | undefined }): void {
    if (direction === this.direction && run === this.run) return;
    this.direction = direction;
    this.run = run;
    for (const listener of this.listeners) listener();
  }
}
