import { padQuantitiesOf, withPadForces } from './pad_forces';
import { kinds, type Kind } from './kinds';
import { countedFromWeld, numberText, type Counted } from './counted';
import { decodeFlags, decodeNumbers } from './decode';
import type { CycleSummary, CycleData, Quantity, RunData } from './format';
import { Result } from './result';

/** States of a contact, in the order of their flags. */
export const contactStates = ['open', 'stick', 'slip forward', 'slip backward'] as const;
export type ContactState = (typeof contactStates)[number];

/** Where two parts touch; `name` as in result.nc. */
export interface Interface {
  name: 'journal_top' | 'top_bump' | 'bump_sleeve';
  title: string;
  node: 'bump' | 'foot';
}

/** The item at an index that is known to be there. */
export function at<T>(items: ArrayLike<T>, index: number): T {
  const item = items[index];
  if (item === undefined) throw new RangeError(`no item ${index} of ${items.length}`);
  return item;
}

/** Values per increment and node. */
export class Field<Values extends ArrayLike<number>> {
  constructor(
    readonly values: Values,
    readonly width: number,
  ) {}

  at(index: number, node: number): number {
    return this.values[index * this.width + node] ?? NaN;
  }
}

/** Several increments in which the journal goes one way. */
export interface Branch {
  loading: boolean;
  /** With the last one of the branch before, so that curves hang together. */
  indices: number[];
}

/** One direction of a bearing or cycle of a strip: what was computed of it, increment by increment. Indices count the increments kept. */
export class Cycle {
  /** The direction in degrees, or the number of the cycle. */
  readonly key: number;
  readonly increments: number[];
  private readonly series = new Map<string, Float32Array>();
  private readonly numbers = new Map<string, Field<Float32Array>>();
  private readonly way: number[] = [];
  private readonly flags = new Map<string, Field<Int8Array>>();

  constructor(
    private readonly data: CycleData,
    private readonly nodes: RunData['nodes'],
    /** Number of the last increment that was requested. */
    readonly lastIncrement: number,
    readonly name: string,
    /** Absent if the cycle was never begun. */
    readonly summary: CycleSummary | undefined,
    /** Of the turning point. */
    readonly steps: number,
    readonly amplitude: number,
  ) {
    this.key = data.at;
    this.increments = data.increments;
  }

  get size(): number {
    return this.increments.length;
  }

  /** Index of the turning point, or of the last increment where the run ended before it. */
  get turning(): number {
    const index = this.increments.indexOf(this.steps);
    return index >= 0 ? index : Math.max(0, this.size - 1);
  }

  isLoading(index: number): boolean {
    return this.flagsOf('branch')[index] === 0;
  }

  /** Where the journal turns. */
  branches(): Branch[] {
    const branches: Branch[] = [];
    this.increments.forEach((_, index) => {
      const loading = this.isLoading(index);
      const last = branches[branches.length - 1];
      if (last?.loading === loading) last.indices.push(index);
      else branches.push({ loading, indices: last ? [index - 1, index] : [index] });
    });
    return branches;
  }

  /** Values per increment; NaN throughout where the result has no such variable. */
  values(name: string): Float32Array {
    let values = this.series.get(name);
    if (!values) {
      const encoded = this.data.series[name];
      values = encoded === undefined ? new Float32Array(this.size).fill(NaN) : decodeNumbers(encoded);
      this.series.set(name, values);
    }
    return values;
  }

  value(name: string, index: number): number {
    return this.values(name)[index] ?? NaN;
  }

  knows(name: string): boolean {
    return this.data.series[name] !== undefined;
  }

  /** Distance that the journal has moved up to an increment: it grows on after turning points, where the displacement goes back. */
  path(index: number): number {
    if (this.way.length === 0) {
      const displacement = this.values('displacement');
      let sum = 0;
      displacement.forEach((to, i) => this.way.push((sum += Math.abs(to - (displacement[i - 1] ?? to)))));
    }
    return this.way[index] ?? NaN;
  }

  field(name: string): Field<Float32Array> {
    let field = this.numbers.get(name);
    if (!field) {
      const data = this.data.fields[name];
      field = new Field(data ? decodeNumbers(data.values) : new Float32Array(0), data ? (this.nodes[data.at] ?? 0) : 0);
      this.numbers.set(name, field);
    }
    return field;
  }

  private flagsOf(name: string): Int8Array {
    let field = this.flags.get(name);
    if (!field) {
      field = new Field(decodeFlags(this.data.series[name] ?? ''), 1);
      this.flags.set(name, field);
    }
    return field.values;
  }

  states(interfaceName: string): Field<Int8Array> {
    let field = this.flags.get(interfaceName);
    if (!field) {
      const data = this.data.fields[`state_${interfaceName}`];
      field = new Field(data ? decodeFlags(data.values) : new Int8Array(0), data ? (this.nodes[data.at] ?? 0) : 0);
      this.flags.set(interfaceName, field);
    }
    return field;
  }
}

/** With a capital at its beginning, but for the symbols of coefficients. */
export function capital(word: string): string {
  if (/^c[xy]{2}\b/.test(word)) return word;
  return word.slice(0, 1).toUpperCase() + word.slice(1);
}

/** Cycles of one folder. */
export class Run extends Result<RunData> {
  readonly kind: Kind;
  readonly cycles: Cycle[];
  /** What tables show of a cycle, in their order. */
  readonly quantities: Quantity[];

  constructor(data: RunData) {
    super(data);
    const kind = kinds[data.kind];
    if (!kind) throw new Error(`results of the kind ${data.kind} cannot be shown`);
    this.kind = kind;
    this.quantities = [...data.quantities, ...padQuantitiesOf(data)];
    const settings = data.summary.case[data.kind] as { amplitude?: number; steps?: number } | undefined;
    this.cycles = data.cycles.map((cycle, i) => {
      const cycleSummary = data.summary.cycles[i];
      const summary = cycleSummary && withPadForces(cycleSummary);
      const steps = summary?.steps ?? settings?.steps ?? 0;
      return new Cycle(cycle, data.nodes, data.last_increment, kind.cycles.name(cycle.at), summary, steps, summary?.amplitude_m ?? settings?.amplitude ?? 0);
    });
  }

  /** It was measured, not computed: nothing is known of its foils. */
  get isMeasured(): boolean {
    return this.data.measured === true;
  }

  /** From the journal outwards; where it presses on the bumps themselves, without a top foil. */
  get interfaces(): Interface[] {
    const { journal, ground } = this.kind;
    const withTopFoil = this.cycles.some((cycle) => (cycle.states('journal_top').values[0] ?? -1) >= 0);
    const upper: Interface[] = withTopFoil
      ? [
          { name: 'journal_top', title: `${capital(journal)} on top foil`, node: 'bump' },
          { name: 'top_bump', title: 'Top foil on bumps', node: 'bump' },
        ]
      : [{ name: 'top_bump', title: `${capital(journal)} on bumps`, node: 'bump' }];
    return [...upper, { name: 'bump_sleeve', title: `Feet on ${ground}`, node: 'foot' }];
  }

  get bumps(): number {
    return this.data.nodes.bump;
  }

  get feet(): number {
    return this.data.nodes.foot;
  }

  get pads(): number {
    return this.data.nodes.pad ?? 1;
  }

  /** Where a bump or foot (from 0) is. */
  counted(node: Interface['node'], index: number): Counted {
    return countedFromWeld(this.perNode(`${node}_pad`), index);
  }

  /** "3", of several pads "3 of pad 2". */
  numberOf(node: Interface['node'], index: number): string {
    return numberText(this.counted(node, index));
  }

  /** A number of the geometry; 0 where it is not known. */
  scalar(name: string): number {
    const value = this.data.geometry[name];
    return typeof value === 'number' ? value : 0;
  }

  /** One number of the geometry per bump, foot or pad. */
  perNode(name: string): number[] {
    const value = this.data.geometry[name];
    return Array.isArray(value) ? value.map((number) => number ?? 0) : [];
  }

  cycle(key: number): Cycle | undefined {
    return this.cycles.find((cycle) => cycle.key === key);
  }
}

/** Keys of the cycles of all runs, each once, in their order. */
export function allKeys(runs: Run[]): number[] {
  return [...new Set(runs.flatMap((run) => run.cycles.map((cycle) => cycle.key)))];
}

/** Largest size of numbers that are known; 0 if none is. */
export function largest(...lists: ArrayLike<number>[]): number {
  let size = 0;
  for (const list of lists) {
    for (let i = 0; i < list.length; i += 1) size = Math.max(size, Math.abs(list[i] ?? 0) || 0);
  }
  return size;
}
