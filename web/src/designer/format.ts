/** What the solver answers; include/bumpfoil/pages/designer.hpp describes it. */
import type { CaseValue, GridData, Quantity, RunData, StatisticsData } from '../data/format';

export interface CaseKey {
  path: string;
  title: string;
  text: string;
  /** Empty for a table. */
  kind: string;
  /** Those of pads that are not given are as in the case. */
  presence: 'required' | 'optional' | 'defaulted' | 'inherited';
  /** SI. */
  unit?: string;
  /** Key whose value it has where it is not given. */
  otherwise?: string;
  /** As it is written in a case file. */
  example?: string;
  /** Of the reference case, in SI. */
  value?: CaseValue;
}

/** For each SI unit the ones that people write, with their sizes. */
export type Units = Record<string, Record<string, number>>;

export interface KeysAnswer {
  version: string;
  commit: string;
  keys: CaseKey[];
  units: Units;
  /** Case files by name. */
  presets: Record<string, string>;
}

export interface InputError {
  /** 0 where it is not known. */
  line: number;
  key: string;
  value: string;
  what: string;
  advice: string;
  message: string;
}

export interface InputErrors {
  errors: InputError[];
}

export interface CyclesAnswer {
  run: Omit<RunData, 'name'>;
}

export type PropertiesAnswer = Record<string, Record<string, number | null>>;

export interface VibrationAnswer {
  position_m: [number, number];
  status: string;
  directions: Record<'stiffness' | 'loss_factor' | 'dissipation', (number | null)[]>[];
}

/** As summary.json has it; with a `reason` where it was not found. */
export type StateOfSummary = Record<string, string | number | boolean | null>;

export interface EquilibriumAnswer {
  run: Omit<GridData, 'name'>;
  states: StateOfSummary[];
}

export interface StabilityAnswer {
  run: Omit<GridData, 'name'>;
}

export interface SamplesAnswer {
  quantities: Quantity[];
  /** By number, direction and quantity. */
  samples: (number | null)[][][];
  /** Of all of them, by direction and key. */
  statistics: Record<string, StatisticsData>[];
}
