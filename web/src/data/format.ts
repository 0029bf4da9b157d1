/** What `bumpfoil report` puts into the page; include/bumpfoil/pages/report.hpp describes it. */

export interface ReportData {
  schema: string;
  version: string;
  commit: string;
  /** Tables and keys of the case file by their paths. */
  keys: CaseKeys;
  runs: ResultData[];
}

export type CaseKeys = Record<string, { title: string; unit?: string }>;

/** Of one folder; what else there is depends on the kind. */
export interface ResultData {
  /** Tells it from the others of the report. */
  name: string;
  /** The command that wrote it. */
  kind: string;
  /** Loops of that kind that were measured: there is displacement and force, and what follows from them. */
  measured?: boolean;
  attributes: Record<string, string>;
  summary: SummaryHead;
  /** What tables show, in their order. */
  quantities: Quantity[];
  /** What radii are more than nominal, m, at equal angles from X on towards Y to X again; of bearings that are not round. */
  deviations?: { sleeve?: string; journal?: string; taper?: string };
}

/** Cycles, increment by increment. */
export interface RunData extends ResultData {
  summary: Summary;
  /** What the variables of cycles and increments are, in the words of result.nc. */
  meanings: Record<string, Meaning>;
  geometry: Record<string, number | null | (number | null)[]>;
  /** Numbers of them; of pads where there are several. */
  nodes: { bump: number; foot: number; pad?: number };
  last_increment: number;
  cycles: CycleData[];
}

/** Numbers over some dimensions. */
export interface GridData extends ResultData {
  /** Their sizes. */
  dimensions: Record<string, number>;
  variables: Record<string, VariableData>;
  /** Names of variables that were too large. */
  left_out: string[];
}

/** Bearings within their tolerances. */
export interface EnsembleData extends ResultData {
  summary: EnsembleSummary;
  /** Degrees, in the order of the case; all else by direction is in the same order. Empty of running bearings. */
  directions: number[];
  /** Of running bearings, names of the states that stand in place of directions; else none. */
  states: string[];
  sample_count: number;
  /** By the names of quantities. */
  distributions: Record<string, DistributionData>;
  /** The first bearings as cycles; without those that are none. */
  samples: SampleData[];
}

export type SampleData = Omit<RunData, 'quantities'> & { sample: number };

export interface DistributionData {
  unit: string;
  text: string;
  /** The least and the largest number of all directions; null where none is known. */
  from: number | null;
  to: number | null;
  /** For each direction, samples in intervals of equal width between these. */
  counts: number[][];
  /** For each direction, numbers of the first samples. */
  first: (number | null)[][];
}

export interface VariableData {
  /** In tables: with its unit, as in CSV files. */
  key: string;
  /** The last runs fastest. */
  dims: string[];
  unit: string;
  text: string;
  /** What 0, 1, ... stand for, with spaces between; empty for numbers. */
  words: string;
  /** Base64 of binary32. */
  values: string;
}

export interface Meaning {
  unit: string;
  text: string;
}

/** Where and when the largest stress acts. */
export interface StressPlace {
  place: string;
  bump: number | null;
  /** Of a bearing of several. */
  pad?: number;
  increment: number;
  displacement_m: number;
}

export interface Quantity {
  /** Of the variable in result.nc. */
  name: string;
  /** In the summary of a cycle. */
  key: string;
  label: string;
  unit: string;
  whole: boolean;
  /** Says how the cycle was computed. */
  of_solver: boolean;
  /** Tables show it at first. */
  first: boolean;
  /** Charts begin with it. */
  leads?: boolean;
  /** With the leading one, of the three that are shown large. */
  key_figure?: boolean;
  /** Tables of a single state list it. */
  listed?: boolean;
  /** In words; empty where the result does not say. */
  meaning: string;
}

/** Values are base64: of binary32, of signed bytes for states and other flags. */
export interface CycleData {
  at: number;
  increments: number[];
  series: Record<string, string>;
  fields: Record<string, { at: 'bump' | 'foot' | 'pad'; values: string }>;
}

export type CaseValue = string | number | boolean | null | CaseValue[] | { [key: string]: CaseValue };

export interface SummaryHead {
  case: { [key: string]: CaseValue };
  version: string;
  commit: string;
  solver: string;
  status: string;
}

/** How far a path of a running bearing has stable states with a film that is thick enough, between two points on it. */
export interface LimitData {
  kind: string;
  status: string;
  speed_rad_per_s?: number | null;
  load_N?: number | null;
  bounded_by?: string | null;
  unstable?: { from_speed_rad_per_s?: number; to_speed_rad_per_s?: number; from_load_N?: number; to_load_N?: number }[];
  thick: LimitPoint;
  thin: LimitPoint;
}

export interface LimitPoint {
  speed_rad_per_s: number;
  load_x_N: number;
  load_y_N: number;
  h_min_m: number | null;
}

export interface StatesSummary extends SummaryHead {
  limits?: LimitData[];
}

/** A sweep, with its keys and the names of their variables. */
export interface SweepSummary extends SummaryHead {
  axes: { key: string; name: string }[];
}

/** Where a motion of a rotor begins to grow, or ends. */
export interface OnsetData {
  speed_rad_per_s: number;
  /** Frequency of the whirl over the speed of rotation. */
  whirl_ratio: number;
  /** "sliding", "stuck" */
  contacts: string;
  by_coefficients: boolean;
  begins: boolean;
  of_foils: boolean;
  /** Contacts change there. */
  jumps: boolean;
}

export interface StabilitySummary extends SummaryHead {
  onsets: OnsetData[];
}

/** Where the response of a rotor to unbalance is largest. */
export interface PeakData {
  /** "linear_sliding", "linear_stuck", "orbit" */
  kind: string;
  station: string;
  speed_rad_per_s: number;
  semi_major_m: number;
}

export interface UnbalanceSummary extends SummaryHead {
  /** Names of the places on the rotor, its bearings first. */
  stations: string[];
  peaks: PeakData[];
}

/** A parameter that was fitted; numbers in its SI unit, "1" of a plain number. */
export interface FitParameterData {
  key: string;
  unit: string;
  start: number;
  fitted_value: number;
  standard_error: number | null;
  lower_95: number | null;
  upper_95: number | null;
  profile_lower_95?: number | null;
  profile_upper_95?: number | null;
  at_bound: boolean;
  at_jump: boolean;
  /** With each parameter. */
  correlations: (number | null)[];
  profile?: { profile_value: number; profile_cost: number }[];
}

/** A loop or a table that was fitted: what its curves are drawn over, and what was measured. */
export interface FittedDataInfo {
  experiment: string;
  points: number;
  axis: string;
  /** SI, as that of quantities; "1" of a plain number. */
  axis_unit: string;
  series: string[];
  quantities: { title: string; unit: string }[];
}

export interface FitSummary extends SummaryHead {
  reduced_chi_square: number | null;
  degrees_of_freedom: number | null;
  collinearity: number | null;
  parameters: FitParameterData[];
  data: FittedDataInfo[];
}

/** Keys that were chosen, aims and limits, with what the best point has; null where there is none. */
export interface OptimiseSummary extends SummaryHead {
  ended_by: string;
  best_point: number | null;
  keys: { key: string; unit: string; lower_bound: number; upper_bound: number; start: number | null; best_value: number | null; active_bound: string | null }[];
  aims: { quantity: string; unit: string; maximise: boolean; best_value: number | null }[];
  limits: { limit: string; quantity: string; unit: string; bound: number; value: number | null; margin: number | null; active: boolean | null }[];
  /** Numbers of points. */
  front: number[];
}

/** Asperities of a bearing that carry load, without a break. */
export interface RubData {
  /** From 1. */
  bearing: number;
  begin_s: number;
  end_s: number;
  /** The largest. */
  asperity_load_N: number;
}

export interface TransientSummary extends SummaryHead {
  /** Names of the places on the rotor, its bearings first. */
  stations: string[];
  /** Whole ones. */
  revolutions: number;
  /** Terms of the balance of all whole revolutions, by their keys. */
  energy: Record<string, number>;
  /** The first of them. */
  rubs: RubData[];
  rub_count: number;
}

/** The steps that lead through a revolution, among those that are there. */
export interface OrbitData {
  /** From 1. */
  revolution: number;
  first: number;
  steps: number;
}

/** A run in time. */
export interface TransientData extends GridData {
  summary: TransientSummary;
  /** Sizes in result.nc of the dimensions; parts of them may be left out here. */
  stored: { revolution?: number; spectrum?: number; step?: number };
  orbits: OrbitData[];
}

export interface Summary extends SummaryHead {
  cycles: CycleSummary[];
}

/** By what scatters: one for each bump for heights, of several strips a list each. */
export type Sensitivities = Record<string, number | null | (number | null)[] | (number | null)[][]>;

/** By direction: "+X". */
export interface EnsembleSummary extends SummaryHead {
  samples: number;
  samples_due: number;
  /** By the keys of quantities. */
  statistics: Record<string, Record<string, StatisticsData>>;
  bump_loads: Record<string, { mean_N?: (number | null)[]; std_N?: (number | null)[] }>;
  /** By the names of quantities. */
  sensitivities: Record<string, Record<string, Sensitivities>>;
  limits: (YieldData & { limit: string })[];
  yield?: YieldData;
}

export interface StatisticsData {
  count: number;
  undefined: number;
  mean: number | null;
  std: number | null;
  standard_error: number | null;
  mean_interval_95: (number | null)[];
  /** And percentiles: p1, p5, ... */
  [key: string]: number | null | (number | null)[];
}

export interface YieldData {
  passed: number;
  samples: number;
  interval_95: number[];
}

export interface CycleSummary {
  at: number;
  amplitude_m: number;
  steps: number;
  converged: boolean;
  [key: string]: string | number | boolean | null | (number | null | string | object)[] | StressPlace;
}
