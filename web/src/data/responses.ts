import { flatten } from './case_values';
import type { GridData, PeakData, UnbalanceSummary } from './format';
import { Grid, numbersOf, type Coordinate, type Place } from './grid';
import { at } from './run';
import { speedText } from './states';

const revolutions = 30 / Math.PI;
const degrees = 180 / Math.PI;

/** How a response was found, in the order of result.nc, as pages call it. */
export const responseKinds = ['small orbits, contacts sliding', 'small orbits, full stick', 'periodic orbits with friction'] as const;
/** Of these. */
export const sliding = 0;
export const stuck = 1;
export const periodic = 2;

/** What a place on the rotor does along one axis: mean + Re(sum of harmonics e^{i n t}), with amplitudes and phases (rad). */
interface Motion {
  mean: number;
  harmonics: [amplitude: number, phase: number][];
}

/** An orbit in the plane of the bearing, m. */
export interface RotorOrbit {
  x: Motion;
  y: Motion;
}

/** Of the bearings of a rotor, m; not a number where the case has none for all of them. */
export function clearanceOf({ summary }: GridData): number {
  const value = flatten(summary.case).get('bearing.radial_clearance');
  return typeof value === 'number' ? value : NaN;
}

/** Where it is at a part of a turn. */
export function orbitPoint({ x, y }: RotorOrbit, turns: number): { x: number; y: number } {
  const along = ({ mean, harmonics }: Motion): number => harmonics.reduce((sum, [amplitude, phase], n) => sum + amplitude * Math.cos(2 * Math.PI * (n + 1) * turns + phase), mean);
  return { x: along(x), y: along(y) };
}

/** Angles one after the other without jumps by a turn, the first of them next to `near`. Degrees. */
export function unwrapped(angles: number[], near: number): number[] {
  let last = near;
  return angles.map((angle) => {
    if (!Number.isFinite(angle)) return NaN;
    last = angle + 360 * Math.round(((Number.isFinite(last) ? last : angle) - angle) / 360);
    return last;
  });
}

/** Responses of a rotor on its bearings to unbalance, over speed. */
export class Responses extends Grid {
  /** rad/s */
  readonly speeds: number[];
  /** Places of the speeds, the slowest first. */
  readonly places: Place[];
  readonly stations: string[];

  constructor(data: GridData) {
    super(data);
    this.speeds = numbersOf(this, 'speed');
    const size = (speed: number): number => Math.abs(this.speeds[speed] ?? NaN);
    this.places = [...this.speeds.keys()].sort((a, b) => size(a) - size(b)).map((speed) => ({ speed }));
    this.stations = (data.summary as UnbalanceSummary).stations;
  }

  /** Whether the rotor turns from Y to X. */
  get turnsBack(): boolean {
    return (this.speeds[0] ?? 0) < 0;
  }

  get speed(): Coordinate {
    return { name: 'speed', title: 'Speed', texts: this.speeds.map(speedText), numbers: this.speeds.map((speed) => speed * revolutions), unit: 'rpm' };
  }

  get station(): Coordinate {
    return { name: 'station', title: 'Station', texts: this.stations, unit: '' };
  }

  get kind(): Coordinate {
    return { name: 'kind', title: 'Response', texts: this.kinds.map((kind) => at(responseKinds, kind)), unit: '' };
  }

  get kinds(): number[] {
    return [...Array(this.size('kind')).keys()];
  }

  get hasOrbits(): boolean {
    return this.size('kind') > periodic;
  }

  /** The first stations are bearings. */
  get bearings(): number {
    return this.size('bearing');
  }

  get peaks(): PeakData[] {
    return (this.data.summary as UnbalanceSummary).peaks;
  }

  /** What is looked at first: the peak of small orbits whose contacts stick; without one the highest speed. */
  get first(): Place {
    const words = this.variable('kind')?.words ?? [];
    const [peak] = this.peaks.filter(({ kind }) => words.indexOf(kind) === stuck);
    if (!peak) return this.places[this.places.length - 1] ?? {};
    const away = (place: Place): number => Math.abs((this.speeds[place['speed'] ?? 0] ?? NaN) - peak.speed_rad_per_s);
    const [nearest = {}] = [...this.places].sort((a, b) => away(a) - away(b));
    return { ...nearest, station: Math.max(0, this.stations.indexOf(peak.station)) };
  }

  numberAt(name: string, place: Place): number {
    return this.variable(name)?.at(place) ?? NaN;
  }

  /** Size of the speed, rpm. */
  revolutionsAt(place: Place): number {
    return Math.abs(this.speeds[place['speed'] ?? 0] ?? NaN) * revolutions;
  }

  /** Of all bearings in the periodic orbit there, put together. */
  ofBearings(name: string, place: Place, together: (values: number[]) => number): number {
    return together([...Array(this.bearings).keys()].map((station) => this.numberAt(name, { ...place, kind: periodic, station })));
  }

  /** "lasts", "does not last"; empty where there is no orbit, or it is not known. */
  lastingAt(place: Place): string {
    return ['does not last', 'lasts'][this.numberAt('orbit_lasts', place)] ?? '';
  }

  /** The orbit of a kind at a station and speed; nothing where there is none. Small orbits of bearings go round equilibria. */
  orbitAt(place: Place): RotorOrbit | undefined {
    const { kind = 0, station = 0, speed = 0 } = place;
    const along = (axis: 'x' | 'y'): Motion => {
      const first: [number, number] = [this.numberAt(`amplitude_${axis}`, place), this.numberAt(`phase_${axis}`, place) / degrees];
      if (kind === periodic) return { mean: this.numberAt(`mean_${axis}`, place), harmonics: [first, [this.numberAt(`amplitude_${axis}_2x`, place), this.numberAt(`phase_${axis}_2x`, place) / degrees]] };
      return { mean: station < this.bearings ? this.numberAt(axis, { speed, bearing: station }) : 0, harmonics: [first] };
    };
    const orbit = { x: along('x'), y: along('y') };
    const point = orbitPoint(orbit, 0);
    return Number.isFinite(point.x) && Number.isFinite(point.y) ? orbit : undefined;
  }

  get clearance(): number {
    return clearanceOf(this.data);
  }

  /** Why there is nothing at a speed; empty where an equilibrium was found. */
  shortfallAt(place: Place): string {
    const status = this.wordAt('speed_status', place);
    return status === 'converged' ? '' : `no equilibrium found: ${status}`;
  }

  wordAt(name: string, place: Place): string {
    return (this.variable(name)?.words[this.numberAt(name, place)] ?? '').replaceAll('_', ' ');
  }
}
