import { decodeFlags, decodeNumbers } from './decode';
import type { CycleSummary, DirectionData, ReportData, RunData } from './format';

/** States of a contact, in the order of their flags. */
export const contactStates = ['open', 'stick', 'slip forward', 'slip backward'] as const;
export type ContactState = (typeof contactStates)[number];

/** Interfaces by their names in result.nc, from the journal outwards. */
export const interfaces = [
  { name: 'journal_top', title: 'Journal on top foil', node: 'bump', friction: false },
  { name: 'top_bump', title: 'Top foil on bump', node: 'bump', friction: true },
  { name: 'bump_sleeve', title: 'Feet on sleeve', node: 'foot', friction: true },
] as const;
export type Interface = (typeof interfaces)[number];

/** The item at an index that is known to be there. */
export function at<T>(items: ArrayLike<T>, index: number): T {
  const item = items[index];
  if (item === undefined) throw new RangeError(`no item ${index} of ${items.length}`);
  return item;
}

/** "+X", "−Y", or the angle itself. */
export function directionName(degrees: number): string {
  const axes: Record<number, string> = { 0: '+X', 90: '+Y', 180: '−X', 270: '−Y' };
  return axes[((degrees % 360) + 360) % 360] ?? `${Number(degrees.toPrecision(6))}°`;
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

/** One direction of a run: what was computed of it, increment by increment. Indices count the increments kept. */
export class Direction {
  readonly name: string;
  readonly degrees: number;
  readonly increments: number[];
  private readonly series = new Map<string, Float32Array>();
  private readonly numbers = new Map<string, Field<Float32Array>>();
  private readonly flags = new Map<string, Field<Int8Array>>();

  constructor(
    private readonly data: DirectionData,
    private readonly nodes: RunData['nodes'],
    /** Absent if the direction was never begun. */
    readonly summary: CycleSummary | undefined,
    /** Of the turning point. */
    readonly steps: number,
    readonly amplitude: number,
  ) {
    this.degrees = data.direction_deg;
    this.name = directionName(data.direction_deg);
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
    return at(this.increments, index) <= this.steps;
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

  /** Way of the journal up to an increment: onwards after the turning point, where the displacement goes back. */
  path(index: number): number {
    const displacement = this.value('displacement', index);
    return this.isLoading(index) ? displacement : 2 * this.amplitude - displacement;
  }

  field(name: string): Field<Float32Array> {
    let field = this.numbers.get(name);
    if (!field) {
      const data = this.data.fields[name];
      field = new Field(data ? decodeNumbers(data.values) : new Float32Array(0), data ? this.nodes[data.at] : 0);
      this.numbers.set(name, field);
    }
    return field;
  }

  states(interfaceName: string): Field<Int8Array> {
    let field = this.flags.get(interfaceName);
    if (!field) {
      const data = this.data.fields[`state_${interfaceName}`];
      field = new Field(data ? decodeFlags(data.values) : new Int8Array(0), data ? this.nodes[data.at] : 0);
      this.flags.set(interfaceName, field);
    }
    return field;
  }
}

/** The results of one folder. */
export class Run {
  readonly directions: Direction[];

  constructor(
    readonly data: RunData,
    /** Tells the run from the others of the report. */
    readonly label: string,
  ) {
    const cycle = data.summary.case['cycle'] as { amplitude?: number; steps?: number } | undefined;
    this.directions = data.directions.map((direction, i) => {
      const summary = data.summary.cycles[i];
      const steps = summary?.steps ?? cycle?.steps ?? 0;
      return new Direction(direction, data.nodes, summary, steps, summary?.amplitude_m ?? cycle?.amplitude ?? 0);
    });
  }

  get bumps(): number {
    return this.data.nodes.bump;
  }

  get feet(): number {
    return this.data.nodes.foot;
  }

  attribute(name: string): string {
    return this.data.attributes[name] ?? '';
  }

  /** A number of the geometry; 0 where it is not known. */
  scalar(name: string): number {
    const value = this.data.geometry[name];
    return typeof value === 'number' ? value : 0;
  }

  /** One number of the geometry per bump or foot. */
  perNode(name: string): number[] {
    const value = this.data.geometry[name];
    return Array.isArray(value) ? value.map((number) => number ?? 0) : [];
  }

  direction(degrees: number): Direction | undefined {
    return this.directions.find((direction) => direction.degrees === degrees);
  }
}

/** Last parts of the paths, as many as it takes to tell them apart; with a number where nothing does. */
export function shortNames(paths: string[]): string[] {
  const parts = paths.map((path) => path.split('/').filter((part) => part !== ''));
  const longest = Math.max(...parts.map((part) => part.length));
  for (let count = 1; count <= longest; count += 1) {
    const names = parts.map((part) => part.slice(-count).join('/'));
    if (new Set(names).size === names.length) return names;
  }
  return paths.map((path, i) => `${path} (${i + 1})`);
}

export function readRuns(report: ReportData): Run[] {
  const names = shortNames(report.runs.map((run) => run.name));
  return report.runs.map((run, i) => new Run(run, at(names, i)));
}

/** Directions of all runs, each once, in their order. */
export function allDirections(runs: Run[]): number[] {
  return [...new Set(runs.flatMap((run) => run.directions.map((direction) => direction.degrees)))];
}

/** Largest size of numbers that are known; 0 if none is. */
export function largest(...lists: ArrayLike<number>[]): number {
  let size = 0;
  for (const list of lists) {
    for (let i = 0; i < list.length; i += 1) size = Math.max(size, Math.abs(list[i] ?? 0) || 0);
  }
  return size;
}
