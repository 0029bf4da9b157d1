import { decodeNumbers } from './decode';
import type { GridData, VariableData } from './format';
import { Result } from './result';
import { largest } from './run';
import { scaleFor, type Scale } from './units';

/** Index along each dimension, by its name. */
export type Place = Readonly<Record<string, number>>;

/** Numbers over some dimensions. */
export class Variable {
  private numbers: Float32Array | undefined;

  constructor(
    readonly name: string,
    private readonly data: VariableData,
    private readonly extents: number[],
  ) {}

  get unit(): string {
    return this.data.unit;
  }

  /** What columns of tables are called. */
  get key(): string {
    return this.data.key;
  }

  /** What it is. */
  get text(): string {
    return this.data.text;
  }

  /** What 0, 1, ... stand for; none for numbers. */
  get words(): string[] {
    return this.data.words === '' ? [] : this.data.words.split(' ');
  }

  /** Whether it counts something: all of it is whole numbers. */
  get isWhole(): boolean {
    return this.unit === '' && this.values.every((value) => Number.isNaN(value) || Number.isInteger(value));
  }

  get values(): Float32Array {
    return (this.numbers ??= decodeNumbers(this.data.values));
  }

  /** Its dimensions, the last running fastest. */
  get dims(): string[] {
    return this.data.dims;
  }

  has(dimension: string): boolean {
    return this.dims.includes(dimension);
  }

  private offset(place: Place, dims: string[]): number {
    return dims.reduce((offset, dim, i) => offset * (this.extents[i] ?? 1) + (place[dim] ?? 0), 0);
  }

  /** NaN where it is not known. */
  at(place: Place): number {
    return this.values[this.offset(place, this.dims)] ?? NaN;
  }

  /** What is known along its last dimension: from the first on, up to what is absent. */
  along(place: Place): number[] {
    const { dims } = this;
    const length = this.extents[dims.length - 1] ?? 1;
    const first = this.offset(place, dims.slice(0, -1)) * length;
    const row = [...this.values.subarray(first, first + length)];
    const end = row.findIndex(Number.isNaN);
    return end < 0 ? row : row.slice(0, end);
  }
}

function variablesOf({ variables, dimensions }: GridData): Map<string, Variable> {
  return new Map(Object.entries(variables).map(([name, one]) => [name, new Variable(name, one, one.dims.map((dim) => dimensions[dim] ?? 0))]));
}

/** Results over coordinates: the keys of a sweep, the loads and amplitudes of vibrations. */
export class Grid extends Result<GridData> {
  private variables: Map<string, Variable>;

  constructor(data: GridData) {
    super(data);
    this.variables = variablesOf(data);
  }

  /** Takes others in the place of these, which charts draw when they are told to. */
  replace(data: GridData): void {
    this.data = data;
    this.variables = variablesOf(data);
  }

  size(dimension: string): number {
    return this.data.dimensions[dimension] ?? 0;
  }

  variable(name: string): Variable | undefined {
    return this.variables.get(name);
  }
}

/** A dimension that results are chosen along. */
export interface Coordinate {
  name: string;
  title: string;
  /** One for each index, as people write them. */
  texts: string[];
  /** What they are on an axis, SI, where they lie on one: directions do not. */
  numbers?: number[];
  unit: string;
}

/** What its column in files is called. */
export function columnNameOf({ name, numbers, unit }: Coordinate): string {
  return numbers && unit !== '' ? `${name}_${unit.replace('degree', 'deg').replaceAll(' ', '_').replaceAll('/', '_per_')}` : name;
}

/** Places of all combinations of their values, the last fastest. */
export function placesOf(coordinates: Coordinate[]): Place[] {
  return coordinates.reduce<Place[]>(
    (places, { name, texts }) => places.flatMap((place) => texts.map((_, i) => ({ ...place, [name]: i }))),
    [{}],
  );
}

/** As an axis shows them: radians in degrees. */
export function axisScale({ numbers = [], unit }: Coordinate): Scale {
  if (unit === 'rad') return { factor: 180 / Math.PI, unit: '°' };
  if (unit === 'rpm') return { factor: 1, unit };
  return scaleFor(largest(numbers), unit);
}

/** The values of a coordinate. */
export function numbersOf(grid: Grid, dimension: string): number[] {
  return [...(grid.variable(dimension)?.values ?? [])];
}

/** A vector with its unit: "(0, −50) N". */
export function vectorText(x: number, y: number, unit: string): string {
  const scale = scaleFor(Math.max(Math.abs(x), Math.abs(y)), unit);
  const part = (number: number): string => String(Number((number * scale.factor).toPrecision(4))).replace('-', '−');
  return `(${part(x)}, ${part(y)}) ${scale.unit}`;
}
