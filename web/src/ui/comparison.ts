import { fractionIn, rangeOf } from '../data/range';
import { at, type Cycle, type Run } from '../data/run';
import type { SweptKey } from '../data/case_values';
import type { Selection } from './selection';
import { rampColour, type Look } from './theme';

/** As many runs as charts can tell apart one by one. */
const mostInFocus = 4;
/** As many as have a colour of their own. */
const mostInColours = 8;

/** Which runs are compared, with which one, and how they are told apart. All views follow it. */
export class Comparison {
  runs: Run[];
  reference: Run;
  /** What the colours stand for; one for each run where it is absent. */
  family: SweptKey | undefined;
  /** Whether every chart has axes of its own, and not the same as those it is compared with. */
  ownAxes = false;
  private readonly chosen: Set<Run>;
  private readonly listeners: (() => void)[] = [];

  /** @param measured  loops that are compared with the runs, by default as their reference */
  constructor(
    readonly selection: Selection,
    readonly families: SweptKey[],
    measured: Run[] = [],
  ) {
    this.runs = [...selection.runs, ...measured];
    this.reference = measured[0] ?? selection.run;
    this.chosen = new Set(this.runs);
    this.family = this.runs.length > mostInColours ? families[0] : undefined;
    let run = selection.run;
    selection.onChange(() => {
      if (run === selection.run) return;
      run = selection.run;
      // Where few are told apart, the run that is looked at is one of them.
      if (this.isShown(run) ? this.many : this.chosen.add(run)) this.tell();
    });
  }

  get several(): boolean {
    return this.runs.length > 1;
  }

  get shown(): Run[] {
    return this.runs.filter((run) => this.chosen.has(run));
  }

  /** More than can be told apart one by one. */
  get many(): boolean {
    return this.chosen.size > mostInFocus;
  }

  /** The runs that are told apart one by one: all shown, or, of many, the reference and the one looked at. */
  get focus(): Run[] {
    if (!this.many) return this.shown;
    return this.runs.filter((run) => run === this.reference || run === this.selection.run);
  }

  /** Those shown whose foils are known. */
  get shownFoils(): Run[] {
    return this.shown.filter((run) => !run.isMeasured);
  }

  get focusFoils(): Run[] {
    return this.focus.filter((run) => !run.isMeasured);
  }

  get shownLoops(): Cycle[] {
    return this.shown.flatMap((run) => run.cycles.filter((cycle) => cycle.size > 0));
  }

  isShown(run: Run): boolean {
    return this.chosen.has(run);
  }

  /** Names of the runs in a title; their number where there are many. */
  get names(): string {
    return this.many ? `${this.shown.length} runs` : this.shown.map(({ label }) => label).join(', ');
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Shows these runs; where the foils of none are known, the reference stays, or the run that is looked at. */
  show(runs: Run[]): void {
    this.chosen.clear();
    for (const run of runs) this.chosen.add(run);
    if (this.shownFoils.length === 0) this.chosen.add(this.reference.isMeasured ? this.selection.run : this.reference);
    if (!this.isShown(this.reference)) this.reference = at(this.shown, 0);
    if (this.isShown(this.selection.run)) this.tell();
    else this.selection.show({ run: at(this.shownFoils, 0) });
  }

  /** Changes what is told apart, and how. */
  set(change: Partial<Pick<Comparison, 'reference' | 'family' | 'ownAxes'>>): void {
    Object.assign(this, change);
    this.chosen.add(this.reference);
    this.tell();
  }

  /** Compares other runs, all of them. */
  replace(runs: Run[], reference: Run): void {
    this.runs = runs;
    this.chosen.clear();
    for (const run of runs) this.chosen.add(run);
    this.reference = reference;
    this.selection.replace(runs);
    this.tell();
    this.selection.tell();
  }

  colour(run: Run, current: Look): string {
    if (run.isMeasured) return current.text;
    const values = this.family?.values;
    if (!values) return at(current.series, this.runs.indexOf(run) % current.series.length);
    const range = rangeOf([...values.values()]);
    return rampColour(current, fractionIn(range, values.get(run) ?? range[0]));
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
