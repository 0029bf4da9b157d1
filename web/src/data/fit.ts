import type { FitSummary, GridData } from './format';
import { Grid } from './grid';

/** A part of a measured loop: means of the readings in it. */
export interface FittedPoint {
  pull: boolean;
  displacement: number;
  measured: number;
  fitted: number;
  residual: number;
  /** Standard deviation. */
  deviation: number;
  readings: number;
}

export interface FittedParameter {
  key: string;
  /** Empty of a number. */
  unit: string;
  start: number;
  value: number;
  standardError: number | null;
  interval: [number | null, number | null];
  /** By the profile; nothing where there is none, or it does not end. */
  profileInterval: [number | null, number | null];
  atBound: boolean;
  correlations: (number | null)[];
  profile: { value: number; cost: number }[];
}

/** Parameters of a case from measured loops. */
export class Fit extends Grid {
  readonly parameters: FittedParameter[];

  constructor(data: GridData) {
    super(data);
    this.parameters = this.summary.parameters.map((one) => ({
      key: one.key,
      unit: one.unit === '1' ? '' : one.unit,
      start: one.start,
      value: one.fitted_value,
      standardError: one.standard_error,
      interval: [one.lower_95, one.upper_95],
      profileInterval: [one.profile_lower_95 ?? null, one.profile_upper_95 ?? null],
      atBound: one.at_bound,
      correlations: one.correlations,
      profile: (one.profile ?? []).map(({ profile_value: value, profile_cost: cost }) => ({ value, cost })),
    }));
  }

  get summary(): FitSummary {
    return this.data.summary as FitSummary;
  }

  get reducedChiSquare(): number {
    return this.summary.reduced_chi_square ?? NaN;
  }

  get loops(): number {
    return this.size('data');
  }

  points(data: number): FittedPoint[] {
    const along = (name: string): number[] => this.variable(name)?.along({ data }) ?? [];
    const [displacement, measured, fitted, residual, deviation, readings, branch] = ['measured_displacement', 'measured_force', 'fitted_force', 'force_residual', 'force_deviation', 'readings', 'fit_branch'].map(along);
    return (displacement ?? []).map((x, i) => ({
      pull: branch?.[i] === 1,
      displacement: x,
      measured: measured?.[i] ?? NaN,
      fitted: fitted?.[i] ?? NaN,
      residual: residual?.[i] ?? NaN,
      deviation: deviation?.[i] ?? NaN,
      readings: readings?.[i] ?? NaN,
    }));
  }
}
