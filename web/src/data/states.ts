import { directionName } from './kinds';
import { Grid, numbersOf, vectorText, type Coordinate, type Place } from './grid';
import type { CycleData, GridData, LimitData, RunData, StatesSummary } from './format';
import { countedFromWeld, numberText, type Counted } from './counted';
import { Run } from './run';

const revolutions = 30 / Math.PI;
const degrees = 180 / Math.PI;
/** Between pads that are laid flat one after the other, degrees. */
const between = 10;

/** Columns of a pad, all in degrees. */
export interface PadColumns {
  /** "pad 2"; empty where there is one alone. */
  name: string;
  /** The first of them among those of all pads. */
  first: number;
  /** Where its weld is when all pads are laid flat one after the other. */
  begin: number;
  /** From its weld. */
  angles: number[];
}

/** "45000 rpm" */
export function speedText(radiansPerSecond: number): string {
  return `${Number((radiansPerSecond * revolutions).toPrecision(6))} rpm`.replace('-', '−');
}

/** What states are told apart by. */
interface Points {
  speed: Coordinate;
  /** The loads or the positions that were requested. */
  journal: Coordinate;
  path: Coordinate;
  /** State of each combination of their values. */
  places: Map<string, number>;
}

function pointsOf(grid: Grid): Points {
  const states = [...Array(grid.size('state')).keys()];
  const value = (name: string, state: number): number => grid.variable(name)?.at({ state }) ?? NaN;
  const byLoad = states.some((state) => Number.isFinite(value('load_x', state)));
  const [x, y] = byLoad ? ['load_x', 'load_y'] : ['position_x', 'position_y'];
  const unit = byLoad ? 'N' : 'm';
  const speeds = states.map((state) => Number((value('speed', state) * revolutions).toPrecision(7)));
  const vectors = states.map((state): [number, number] => [value(x, state), value(y, state)]);
  const words = grid.variable('path')?.words ?? [];
  const paths = states.map((state) => (words[value('path', state)] ?? 'path').replaceAll('_', ' '));
  // A way there and back comes to the same load again.
  const times = new Map<string, number>();
  const texts = vectors.map(([along, across], state) => {
    const text = vectorText(along, across, unit);
    const key = [speeds[state], text, paths[state]].join();
    const time = (times.get(key) ?? 0) + 1;
    times.set(key, time);
    return time > 1 ? `${text}, time ${time}` : text;
  });
  const rpm = [...new Set(speeds)];
  const each = [...new Set(texts)];
  const ways = [...new Set(paths)];
  const places = states.map((state): [string, number] => [[rpm.indexOf(speeds[state] ?? NaN), each.indexOf(texts[state] ?? ''), ways.indexOf(paths[state] ?? '')].join(), state]);
  return {
    speed: { name: 'speed', title: 'Speed', texts: rpm.map((number) => speedText(number / revolutions)), numbers: rpm, unit: 'rpm' },
    journal: journalOf(vectors, texts, byLoad, unit),
    path: { name: 'path', title: 'Path', texts: ways, unit: '' },
    places: new Map(places),
  };
}

/** States of a running bearing: at speeds, under loads or at positions, by paths. */
export class States extends Grid {
  private points: Points;

  constructor(data: GridData) {
    super(data);
    this.points = pointsOf(this);
  }

  override replace(data: GridData): void {
    super.replace(data);
    this.points = pointsOf(this);
  }

  get speed(): Coordinate {
    return this.points.speed;
  }

  /** The loads or the positions that were requested. */
  get journal(): Coordinate {
    return this.points.journal;
  }

  /** Lift-off speeds and load capacities; none where they were not requested. */
  get limits(): LimitData[] {
    return (this.data.summary as StatesSummary).limits ?? [];
  }

  get coordinates(): Coordinate[] {
    return [this.points.journal, this.points.path, this.points.speed];
  }

  /** The state there; -1 where none was looked for. */
  stateAt(place: Place): number {
    return this.points.places.get([place['speed'] ?? 0, place['journal'] ?? 0, place['path'] ?? 0].join()) ?? -1;
  }

  /** A number of the state at a place. */
  numberAt(name: string, place: Place): number {
    const state = this.stateAt(place);
    return state < 0 ? NaN : (this.variable(name)?.at({ ...place, state }) ?? NaN);
  }

  isFound(place: Place): boolean {
    return Number.isFinite(this.numberAt('h_min', place));
  }

  /** Row of the mid-plane: the first one of half the width. */
  get midRow(): number {
    const across = numbersOf(this, 'z').map(Math.abs);
    return Math.max(0, across.indexOf(Math.min(...across)));
  }

  /** Values along a dimension at a state, in the mid-plane. */
  along(name: string, dimension: string, place: Place): number[] {
    const state = this.stateAt(place);
    const variable = this.variable(name);
    if (state < 0 || !variable?.has(dimension)) return [];
    const row = this.midRow;
    return Array.from({ length: this.size(dimension) }, (_, i) => variable.at({ state, row, [dimension]: i }));
  }

  get pads(): number {
    return Math.max(1, this.size('pad'));
  }

  /** Where the columns of the film are, pad after pad. */
  get padColumns(): PadColumns[] {
    const angles = numbersOf(this, 'column_theta').map((theta) => theta * degrees);
    const owners = numbersOf(this, 'column_pad');
    const columns: PadColumns[] = [];
    let begin = 0;
    for (let number = 1; number <= this.pads; number += 1) {
      const own = this.pads === 1 ? angles : angles.filter((_, column) => owners[column] === number);
      columns.push({ name: this.pads === 1 ? '' : `pad ${number}`, first: this.pads === 1 ? 0 : owners.indexOf(number), begin, angles: own });
      begin += Math.max(...own) + between;
    }
    return columns;
  }

  /** Number of a bump (from 0, through all pads). */
  countedBump(bump: number): Counted {
    return countedFromWeld(numbersOf(this, 'bump_pad'), bump);
  }

  /** "3", of several pads "3 of pad 2". */
  bumpText(bump: number): string {
    return numberText(this.countedBump(bump));
  }

  /** Size of the force that one of several pads (from 0) takes. */
  padForceAt(pad: number, place: Place): number {
    const state = this.stateAt(place);
    const [x, y] = ['pad_force_x', 'pad_force_y'].map((name) => (state < 0 ? NaN : (this.variable(name)?.at({ state, pad }) ?? NaN)));
    return Math.hypot(x ?? NaN, y ?? NaN);
  }

  /** The states as increments of a cycle, which the bearing is drawn from; none without foils. */
  get bearing(): Run | undefined {
    const { variables } = this.data;
    if (!variables['crest_v']) return undefined;
    const fields: CycleData['fields'] = {};
    for (const [name, { dims, values, words }] of Object.entries(variables)) {
      const node = dims[1];
      if (dims[0] !== 'state' || (node !== 'bump' && node !== 'foot')) continue;
      fields[name] = { at: node, values: words === '' ? values : flags(this.variable(name)?.values ?? []) };
    }
    // The film bears on the top foil all along it.
    fields['state_journal_top'] = { at: 'bump', values: flags(new Float32Array(this.size('state') * this.size('bump'))) };
    const series = Object.fromEntries(['x', 'y', 'force_x', 'force_y'].map((name) => [name, variables[name]?.values ?? '']));
    const geometry: RunData['geometry'] = {};
    for (const [name, { dims }] of Object.entries(variables)) {
      if (dims.length === 0) geometry[name] = this.variable(name)?.at({}) ?? null;
      else if (dims.length === 1 && (dims[0] === 'bump' || dims[0] === 'foot' || dims[0] === 'pad')) geometry[name] = numbersOf(this, name);
    }
    const increments = [...Array(this.size('state')).keys()];
    return new Run({
      ...this.data,
      kind: 'cycle',
      summary: { ...this.data.summary, cycles: [] },
      meanings: {},
      geometry,
      nodes: { bump: this.size('bump'), foot: this.size('foot'), ...(this.pads > 1 ? { pad: this.pads } : {}) },
      last_increment: Math.max(0, increments.length - 1),
      cycles: [{ at: 0, increments, series, fields }],
      quantities: [],
    });
  }
}

/** Those of one direction lie on an axis, by their sizes. */
function journalOf(vectors: [number, number][], texts: string[], byLoad: boolean, unit: string): Coordinate {
  const each = [...new Set(texts)];
  const own = each.map((text): [number, number] => vectors[texts.indexOf(text)] ?? [NaN, NaN]);
  const sizes = own.map(([x, y]) => Math.hypot(x, y));
  const angles = own.filter((_, i) => (sizes[i] ?? 0) > 0).map(([x, y]) => Number(((Math.atan2(y, x) * 180) / Math.PI).toPrecision(6)));
  const title = byLoad ? 'Load' : 'Position';
  if (new Set(angles).size !== 1) return { name: 'journal', title, texts: each, unit: '' };
  return { name: 'journal', title: `${title} to ${directionName(angles[0] ?? 0)}`, texts: each, numbers: sizes, unit };
}

function flags(values: ArrayLike<number>): string {
  return btoa(Array.from(values, (value) => String.fromCharCode((Number.isFinite(value) ? value : -127) & 0xff)).join(''));
}
