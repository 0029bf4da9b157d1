/** What `bumpfoil report` puts into the page; include/bumpfoil/io/report.hpp describes it. */

export interface ReportData {
  schema: string;
  version: string;
  commit: string;
  /** Tables and keys of the case file by their paths. */
  keys: CaseKeys;
  runs: RunData[];
}

export type CaseKeys = Record<string, { title: string; unit?: string }>;

export interface RunData {
  name: string;
  kind: string;
  attributes: Record<string, string>;
  summary: Summary;
  geometry: Record<string, number | null | (number | null)[]>;
  nodes: { bump: number; foot: number };
  last_increment: number;
  /** What tables show of the summary, in their order. */
  quantities: Quantity[];
  loops: LoopData[];
}

export interface Quantity {
  /** In the summary of a cycle. */
  key: string;
  label: string;
  unit: string;
  whole: boolean;
  /** Says how the cycle was computed. */
  of_solver: boolean;
}

/** Values are base64: of binary32, of signed bytes for states and other flags. */
export interface LoopData {
  at: number;
  increments: number[];
  series: Record<string, string>;
  fields: Record<string, { at: 'bump' | 'foot'; values: string }>;
}

export type CaseValue = string | number | boolean | null | CaseValue[] | { [key: string]: CaseValue };

export interface Summary {
  case: { [key: string]: CaseValue };
  version: string;
  commit: string;
  solver: string;
  status: string;
  cycles: CycleSummary[];
}

export interface CycleSummary {
  at: number;
  amplitude_m: number;
  steps: number;
  converged: boolean;
  [key: string]: string | number | boolean | null | (number | null)[];
}
