import type { OrbitData, TransientData, TransientSummary } from './format';
import { Grid, numbersOf, type Coordinate, type Place } from './grid';
import { clearanceOf } from './responses';
import { at } from './run';
import { speedText } from './states';
import { formatQuantity, scaleFor } from './units';

/** A point in the plane of a bearing, m. */
export interface PlanePoint {
  x: number;
  y: number;
}

/** A rotor in time: whole revolutions, spectra over some of them, and the steps of those whose orbits are drawn. */
export class TimeRun extends Grid {
  /** Numbers of the revolutions that are there, from 1. */
  readonly numbers: number[];
  /** What charts go along: the same revolutions, by their numbers, the time at their ends, and their speeds. */
  readonly revolution: Coordinate;
  readonly time: Coordinate;
  readonly speed: Coordinate;
  readonly station: Coordinate;

  constructor(private readonly own: TransientData) {
    super(own);
    this.numbers = numbersOf(this, 'revolution');
    const times = numbersOf(this, 'revolution_time');
    const speeds = numbersOf(this, 'revolution_speed');
    const rpm = scaleFor(1, 'rpm').factor;
    const name = 'revolution';
    this.revolution = { name, title: 'Revolution', texts: this.numbers.map(String), numbers: this.numbers, unit: '' };
    this.time = { name, title: 'Time', texts: times.map((time) => formatQuantity(time, 's')), numbers: times, unit: 's' };
    this.speed = { name, title: speeds.some((speed) => speed < 0) ? 'Speed, from Y to X' : 'Speed', texts: speeds.map((speed) => speedText(Math.abs(speed))), numbers: speeds.map((speed) => Math.abs(speed) * rpm), unit: 'rpm' };
    this.station = { name: 'station', title: 'Station', texts: this.summary.stations, unit: '' };
  }

  get summary(): TransientSummary {
    return this.own.summary;
  }

  get orbits(): OrbitData[] {
    return this.own.orbits;
  }

  /** The first stations are bearings. */
  get bearings(): number {
    return this.size('bearing');
  }

  get clearance(): number {
    return clearanceOf(this.data);
  }

  numberAt(name: string, place: Place): number {
    return this.variable(name)?.at(place) ?? NaN;
  }

  /** Of the run as a whole. */
  total(name: string): number {
    return this.numberAt(name, {});
  }

  /** "converged", "film too thin": how the march ended. */
  get ending(): string {
    return (this.variable('status')?.words[this.total('status')] ?? '').replaceAll('_', ' ');
  }

  /** The orbit whose revolution is next to this one. */
  orbitNear(revolution: number): number {
    const away = (orbit: number): number => Math.abs((this.orbits[orbit]?.revolution ?? NaN) - revolution);
    return [...this.orbits.keys()].reduce((best, orbit) => (away(orbit) < away(best) ? orbit : best), 0);
  }

  /** The orbit that a step is part of: of two that share it the first. */
  orbitOfStep(step: number): number {
    return Math.max(0, this.orbits.findIndex(({ first, steps }) => step >= first && step < first + steps));
  }

  /** Index of the revolution that is there next to one of this number. */
  indexOfRevolution(number: number): number {
    const away = (index: number): number => Math.abs((this.numbers[index] ?? NaN) - number);
    return [...this.numbers.keys()].reduce((best, index) => (away(index) < away(best) ? index : best), 0);
  }

  pointAt(step: number, station: number): PlanePoint {
    return { x: this.numberAt('x', { step, station }), y: this.numberAt('y', { step, station }) };
  }

  pointsOf(orbit: OrbitData, station: number): PlanePoint[] {
    return Array.from({ length: orbit.steps }, (_, i) => this.pointAt(orbit.first + i, station));
  }

  /** In how many revolutions a spectrum is. */
  get spectrumLength(): number {
    const [, first = NaN] = numbersOf(this, 'order');
    return Number.isFinite(first) ? Math.round(1 / first) : 0;
  }

  /** What result.nc has that is not there. */
  get thinning(): string {
    const { stored } = this.own;
    const every = (whole: number, there: number): number => Math.ceil((whole - 1) / Math.max(1, there - 1));
    const parts = (['revolution', 'spectrum'] as const).flatMap((name) => {
      const [whole, there] = [stored[name] ?? 0, this.size(name)];
      const words = name === 'spectrum' ? 'spectra' : 'revolutions';
      return whole > there ? [`one in ${every(whole, there)} of ${whole} ${words}`] : [];
    });
    const last = this.orbits[this.orbits.length - 1]?.revolution ?? 0;
    const orbits = last > this.orbits.length ? [`the orbits of ${this.orbits.length} of ${last} revolutions`] : [];
    const steps = orbits.length === 0 && (stored.step ?? 0) > this.size('step') ? ['some of the steps of each orbit'] : [];
    const all = [...parts, ...orbits, ...steps];
    return all.length === 0 ? '' : `Of this run the page has ${all.join(', ')}; result.nc has them all.`;
  }

  /** Of an orbit about the mean of its points. */
  meanOf(points: PlanePoint[]): PlanePoint {
    const mean = (axis: 'x' | 'y'): number => points.reduce((sum, point) => sum + point[axis], 0) / Math.max(1, points.length);
    return { x: mean('x'), y: mean('y') };
  }

  orbit(index: number): OrbitData {
    return at(this.orbits, index);
  }
}
