import { countedFromWeld, numberText, tickText, type Counted } from './counted';
import type { CaseKeys, DistributionData, EnsembleData, Quantity, Sensitivities, StatisticsData } from './format';
import { directionName } from './kinds';
import { Result } from './result';
import { capital, Run } from './run';

/** Percentiles that statistics have, %. */
export const percentiles = [1, 5, 25, 50, 75, 95, 99] as const;

/** Something that scatters, and how much quantities depend on it. */
export interface Factor {
  /** On the axis, and by itself. */
  text: string;
  title: string;
  /** Partial rank correlation with a quantity in a direction, -1 to 1; NaN where samples are too few. */
  correlation: (quantity: string, direction: number) => number;
}

/** Bearings within their tolerances. Directions go by their places. */
export class Ensemble extends Result<EnsembleData> {
  /** The first bearings, to be looked at. */
  readonly runs: Run[];
  private readonly numbers = new Map<Run, number>();

  constructor(data: EnsembleData) {
    super(data);
    this.runs = data.samples.map((sample) => {
      const run = new Run({ ...sample, quantities: [] });
      this.numbers.set(run, sample.sample);
      return run;
    });
  }

  /** Whether the bearings run: then places are states, or the rotor. */
  get hasStates(): boolean {
    return this.data.states.length > 0;
  }

  /** Of running bearings their states, or the rotor. */
  get directions(): string[] {
    return this.hasStates ? this.data.states : this.data.directions.map(directionName);
  }

  /** What directions() are. */
  get placeWord(): string {
    return this.hasStates ? 'State' : 'Direction';
  }

  /** Directions in files of numbers. */
  get placeColumn(): { name: string; cells: (number | string)[] } {
    return this.hasStates ? { name: 'state', cells: this.data.states } : { name: 'direction_deg', cells: this.data.directions };
  }

  get quantities(): Quantity[] {
    return this.data.quantities.filter(({ name }) => this.distribution(name) !== undefined);
  }

  /** Names of the quantities that limits are set on: "h_min > 13 um". */
  get limited(): string[] {
    return this.data.summary.limits.map(({ limit }) => limit.split(/[\s<>=]/)[0] ?? '');
  }

  distribution(name: string): DistributionData | undefined {
    return this.data.distributions[name];
  }

  statistics({ key }: Quantity, direction: number): StatisticsData | undefined {
    return this.byDirection(this.data.summary.statistics, direction)?.[key];
  }

  bumpLoads(direction: number): { mean: number[]; deviation: number[] } {
    const loads = this.byDirection(this.data.summary.bump_loads, direction);
    return { mean: numbersOf(loads?.mean_N), deviation: numbersOf(loads?.std_N) };
  }

  /** Whether loads of bumps are kept: not of rotors. */
  get hasLoads(): boolean {
    return Object.keys(this.data.summary.bump_loads).length > 0;
  }

  /** Whether the bearings have several pads. */
  get hasPads(): boolean {
    return this.bumpPads.length > 0;
  }

  /** Where a bump (from 0) is. */
  counted(bump: number): Counted {
    return countedFromWeld(this.bumpPads, bump);
  }

  private get bumpPads(): number[] {
    const { bump_foil: common, pad: pads = [] } = this.data.summary.case as { bump_foil?: { bumps?: number }; pad?: { bump_foil?: { bumps?: number } }[] };
    if (pads.length < 2) return [];
    return pads.flatMap((pad, i) => Array.from({ length: pad.bump_foil?.bumps ?? common?.bumps ?? 0 }, () => i + 1));
  }

  /** Of the heights of the bumps one each, from the weld on; none where they do not scatter. */
  get heightFactors(): Factor[] {
    const heights = (quantity: string, direction: number): number[][] => listsOf(this.sensitivity(quantity, direction)['bump_height']);
    const most = this.quantities.map(({ name }) => heights(name, 0)).reduce((a, b) => (b.flat().length > a.flat().length ? b : a), []);
    return most.flatMap((bumps, strip) =>
      bumps.map((_, bump) => ({
        text: (most.length > 1 ? `${strip + 1}: ` : '') + tickText(this.counted(bump)),
        title: `Height of bump ${numberText(this.counted(bump))}${most.length > 1 ? ` of strip ${strip + 1}` : ''}`,
        correlation: (quantity: string, direction: number) => heights(quantity, direction)[strip]?.[bump] ?? NaN,
      })),
    );
  }

  /** Of what is common to a bearing. */
  commonFactors(keys: CaseKeys): Factor[] {
    const names = new Set(this.quantities.flatMap(({ name }) => Object.keys(this.sensitivity(name, 0))));
    names.delete('bump_height');
    return [...names].map((name) => ({
      text: titleOf(name, keys),
      title: titleOf(name, keys),
      correlation: (quantity, direction) => numbersOf([this.sensitivity(quantity, direction)[name]])[0] ?? NaN,
    }));
  }

  /** The number that one of the first bearings has of a quantity. */
  numberOf(run: Run, quantity: string, direction: number): number {
    return numbersOf(this.distribution(quantity)?.first[direction])[this.numbers.get(run) ?? -1] ?? NaN;
  }

  private sensitivity(quantity: string, direction: number): Sensitivities {
    return this.byDirection(this.data.summary.sensitivities, direction)?.[quantity] ?? {};
  }

  private byDirection<T>(table: Record<string, T>, direction: number): T | undefined {
    return Object.values(table)[direction];
  }
}

/** Of several strips a list each. */
function listsOf(all: unknown): number[][] {
  if (!Array.isArray(all) || all.length === 0) return [];
  return Array.isArray(all[0]) ? all.map(numbersOf) : [numbersOf(all)];
}

function numbersOf(list: unknown): number[] {
  return Array.isArray(list) ? list.map((number) => (typeof number === 'number' ? number : NaN)) : [];
}

/** Of "Scatter of the bump length", as the case file calls it, what scatters. */
function titleOf(name: string, keys: CaseKeys): string {
  return capital((keys[`montecarlo.${name}`]?.title ?? name.replaceAll('_', ' ')).replace(/^Scatter of (the )?/, ''));
}
