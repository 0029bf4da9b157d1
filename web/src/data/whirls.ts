import type { GridData, OnsetData, StabilitySummary } from './format';
import { Grid, numbersOf, type Coordinate, type Place } from './grid';
import { speedText } from './states';

const revolutions = 30 / Math.PI;

/** What slipping contacts do, in the order of result.nc. */
export const contactKinds = ['sliding', 'stuck'] as const;
export const contactTexts = ['contacts sliding', 'full stick'] as const;

/** A motion that keeps its number from speed to speed. */
export interface Mode {
  /** Of the motion among those shown. */
  motion: number;
  /** As in the files. */
  number: number;
  /** "mode 2", "mode 5, foils" */
  text: string;
  /** Places of the speeds at which it was found, the slowest first. */
  places: Place[];
}

/** Speeds are in rpm, whatever else of their unit is a frequency. */
export function inRevolutions<T extends { name: string; unit: string }>(quantity: T): T {
  return quantity.unit === 'rad/s' && /speed|stable_up_to/.test(quantity.name) ? { ...quantity, unit: 'rpm' } : quantity;
}

/** "whirl begins at 13179.7 rpm, whirl ratio 0.4925", as on the terminal. */
export function onsetText({ speed_rad_per_s: speed, whirl_ratio: ratio, begins, of_foils: ofFoils, jumps }: OnsetData): string {
  return `whirl${ofFoils ? ' of the foils' : ''} ${begins ? 'begins' : 'ends'} at ${speedText(speed)}, whirl ratio ${ratio.toFixed(4)}${jumps ? ' (contacts change there)' : ''}`;
}

/** Free motions of a rotor on its bearings, over speed, with contacts sliding and stuck. */
export class Whirls extends Grid {
  /** rad/s */
  speeds: number[] = [];
  /** Indices of the speeds, the slowest first. */
  private order: number[] = [];
  /** Indices of the motions shown: those that oscillate or grow at some speed. */
  private shown: number[] = [];

  constructor(data: GridData) {
    super(data);
    this.read();
  }

  override replace(data: GridData): void {
    super.replace(data);
    this.read();
  }

  private read(): void {
    this.speeds = numbersOf(this, 'speed');
    const size = (speed: number): number => Math.abs(this.speeds[speed] ?? NaN);
    this.order = [...this.speeds.keys()].sort((a, b) => size(a) - size(b));
    this.shown = [...Array(this.size('mode')).keys()].filter((mode) =>
      this.order.some((speed) => contactKinds.some((_, contacts) => this.isShown({ speed, contacts, mode }))),
    );
  }

  private isShown(place: Place): boolean {
    const [real, imag] = ['real', 'imag'].map((name) => this.variable(name)?.at(place) ?? NaN);
    return (imag ?? NaN) > 0 || (real ?? NaN) > 0;
  }

  /** Whether the rotor turns from Y to X. */
  get turnsBack(): boolean {
    return (this.speeds[0] ?? 0) < 0;
  }

  get speed(): Coordinate {
    return { name: 'speed', title: 'Speed', texts: this.speeds.map(speedText), numbers: this.speeds.map((speed) => speed * revolutions), unit: 'rpm' };
  }

  get contacts(): Coordinate {
    return { name: 'contacts', title: 'Contacts', texts: [...contactTexts], unit: '' };
  }

  get motion(): Coordinate {
    return { name: 'motion', title: 'Motion', texts: this.shown.map((mode) => `mode ${mode + 1}`), unit: '' };
  }

  /** A number at a speed, of a motion there. */
  numberAt(name: string, place: Place): number {
    const mode = this.shown[place['motion'] ?? 0];
    const variable = this.variable(name);
    if (!variable || (mode === undefined && variable.has('mode'))) return NaN;
    return variable.at({ ...place, mode: mode ?? 0 });
  }

  /** The word of a flag there; empty where it is not known. */
  wordAt(name: string, place: Place): string {
    return (this.variable(name)?.words[this.numberAt(name, place)] ?? '').replaceAll('_', ' ');
  }

  /** Size of the speed, rpm. */
  revolutionsAt(place: Place): number {
    return Math.abs(this.speeds[place['speed'] ?? 0] ?? NaN) * revolutions;
  }

  /** Growth rate, 1/s. */
  growthRateAt(place: Place): number {
    return this.numberAt('real', place);
  }

  /** Growth rate over the speed of rotation: growth per radian. */
  growthAt(place: Place): number {
    return this.numberAt('real', place) / Math.abs(this.speeds[place['speed'] ?? 0] ?? NaN);
  }

  /** Damped frequency, Hz. */
  frequencyAt(place: Place): number {
    return this.numberAt('imag', place) / (2 * Math.PI);
  }

  /** The motions with these contacts that oscillate or grow at some speed. */
  modes(contacts: number): Mode[] {
    return this.shown.flatMap((mode, motion) => {
      const places = this.order.map((speed): Place => ({ speed, contacts, motion })).filter((place) => Number.isFinite(this.growthRateAt(place)));
      if (!places.some((place) => this.isShown({ ...place, mode }))) return [];
      const ofFoils = places.filter((place) => this.numberAt('of_foils', place) === 1).length > places.length / 2;
      return [{ motion, number: mode + 1, text: `mode ${mode + 1}${ofFoils ? ', foils' : ''}`, places }];
    });
  }

  /** Places of the speeds, the slowest first. */
  places(contacts: number): Place[] {
    return this.order.map((speed) => ({ speed, contacts }));
  }

  /** Growth per radian by synchronous coefficients. */
  growthByCoefficientsAt(place: Place): number {
    return this.numberAt(`growth_by_coefficients${place['contacts'] === 1 ? '_stuck' : ''}`, place);
  }

  /** The motion that grows fastest at a speed; the first where there is none. */
  fastest(place: Place): number {
    const rates = this.shown.map((_, motion) => this.growthRateAt({ ...place, motion }));
    return Math.max(0, rates.indexOf(Math.max(...rates.filter(Number.isFinite))));
  }

  /** The motion of the rotor, or of the foils alone, that is damped least at a speed; nothing where there is none. */
  leastDamped(place: Place, ofFoils: boolean): Place | undefined {
    const own = this.shown.map((_, motion): Place => ({ ...place, motion })).filter((one) => this.numberAt('of_foils', one) === Number(ofFoils));
    const rates = own.map((one) => this.growthRateAt(one));
    return own[rates.indexOf(Math.max(...rates))];
  }

  /** What is looked at first: the fastest motion at the highest speed that has one. */
  get first(): Place {
    const all = this.places(0);
    const found = all.filter((place) => this.shown.some((_, motion) => Number.isFinite(this.growthRateAt({ ...place, motion }))));
    const place = found[found.length - 1] ?? all[all.length - 1] ?? {};
    return { ...place, motion: this.fastest(place) };
  }

  onsets(contacts: number): OnsetData[] {
    return (this.data.summary as StabilitySummary).onsets.filter((onset) => onset.contacts === contactKinds[contacts]);
  }

  /** Why there are no motions at a speed; empty where an equilibrium was found. */
  shortfallAt(place: Place): string {
    const status = this.wordAt('speed_status', place);
    return status === 'converged' ? '' : `no equilibrium found: ${status}`;
  }
}
