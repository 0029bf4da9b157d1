import { keyTitle } from './case_values';
import type { CaseKeys, FitSummary, FittedDataInfo, GridData } from './format';
import { Grid } from './grid';
import { at } from './run';

/** What was measured at a place, in SI; of a loop, means of the readings in a part of it. */
export interface FittedPoint {
  /** From 0. */
  series: number;
  place: number;
  measured: number;
  model: number;
  residual: number;
  /** Standard deviation. */
  deviation: number;
  readings: number;
}

export interface FittedParameter {
  key: string;
  /** As the case calls it. */
  title: string;
  /** Empty of a number. */
  unit: string;
  start: number;
  value: number;
  standardError: number | null;
  interval: [number | null, number | null];
  /** By the profile; nothing where there is none, or it does not end. */
  profileInterval: [number | null, number | null];
  atBound: boolean;
  atJump: boolean;
  correlations: (number | null)[];
  profile: { value: number; cost: number }[];
}

/** Parameters of a case from measured data. */
export class Fit extends Grid {
  readonly parameters: FittedParameter[];

  constructor(data: GridData, keys: CaseKeys) {
    super(data);
    this.parameters = this.summary.parameters.map((one) => ({
      key: one.key,
      title: keyTitle(keys, one.key),
      unit: one.unit === '1' ? '' : one.unit,
      start: one.start,
      value: one.fitted_value,
      standardError: one.standard_error,
      interval: [one.lower_95, one.upper_95],
      profileInterval: [one.profile_lower_95 ?? null, one.profile_upper_95 ?? null],
      atBound: one.at_bound,
      atJump: one.at_jump,
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

  /** Of loops and tables. */
  get count(): number {
    return this.summary.data.length;
  }

  /** Axis, series and quantities of some data. */
  measured(data: number): { axis: string; axisUnit: string; series: string[]; quantities: FittedDataInfo['quantities'] } {
    const { axis, axis_unit: axisUnit, series, quantities } = at(this.summary.data, data);
    return { axis, axisUnit, series, quantities: quantities.map(({ title, unit }) => ({ title, unit: unit === '1' ? '' : unit })) };
  }

  /** Of one of the quantities of some data. */
  points(data: number, quantity: number): FittedPoint[] {
    const along = (name: string): number[] => this.variable(name)?.along({ data }) ?? [];
    const column = along('data_quantity')[quantity];
    const [series, place, measured, model, residual, deviation, readings] = ['point_series', 'point_place', 'measured_value', 'model_value', 'value_residual', 'value_deviation', 'readings'].map(along);
    return along('point_quantity').flatMap((one, i) =>
      one === column
        ? {
            series: (series?.[i] ?? 1) - 1,
            place: place?.[i] ?? NaN,
            measured: measured?.[i] ?? NaN,
            model: model?.[i] ?? NaN,
            residual: residual?.[i] ?? NaN,
            deviation: deviation?.[i] ?? NaN,
            readings: readings?.[i] ?? NaN,
          }
        : [],
    );
  }
}
