import { keyTitle, valueText } from './case_values';
import type { CaseKeys, CaseValue, GridData, OptimiseSummary } from './format';
import { Grid } from './grid';

const statistics: Record<string, string> = { mean: 'mean', std: 'standard deviation', p50: 'median' };

/** A point that was evaluated; numbers that it has not are NaN. */
export interface OptimisedPoint {
  number: number;
  /** That evaluated it; 0: a place that searches may start from. */
  search: number;
  status: string;
  feasible: boolean;
  values: number[];
  aims: number[];
}

/** Keys of a case that were chosen so that a quantity is best under limits. */
export class Optimisation extends Grid {
  readonly points: OptimisedPoint[];

  constructor(
    data: GridData,
    private readonly keys: CaseKeys,
  ) {
    super(data);
    const row = (name: string, dimension: string, point: number): number[] =>
      [...Array(this.size(dimension)).keys()].map((i) => this.variable(name)?.at({ point, [dimension]: i }) ?? NaN);
    const status = this.variable('point_status');
    this.points = [...Array(this.size('point')).keys()].map((point) => ({
      number: point,
      search: this.variable('search')?.at({ point }) ?? 0,
      status: status?.words[status.at({ point })] ?? '',
      feasible: this.variable('feasible')?.at({ point }) === 1,
      values: row('key_value', 'key', point),
      aims: row('aim_value', 'aim', point),
    }));
  }

  get summary(): OptimiseSummary {
    return this.data.summary as OptimiseSummary;
  }

  get best(): OptimisedPoint | undefined {
    const { best_point: best } = this.summary;
    return best === null ? undefined : this.points[best];
  }

  get front(): OptimisedPoint[] {
    return this.summary.front.flatMap((number) => this.points[number] ?? []);
  }

  /** Of a key. */
  titleOf(key: string): string {
    return keyTitle(this.keys, key);
  }

  /** A quantity in words; of an ensemble with its statistic: "minimum film thickness, 5th percentile". */
  nameOf(quantity: string): string {
    const [name = '', statistic] = quantity.split('.');
    const words = this.data.quantities.find((one) => one.name === name)?.label ?? name;
    return statistic === undefined ? words : `${words}, ${statistics[statistic] ?? `${statistic.slice(1)}th percentile`}`;
  }

  /** A limit in words: "minimum film thickness > 8.4 µm". Of bearings of an ensemble, SI numbers stay as they are written. */
  limitText(text: string): string {
    const [, quantity = text, sign = '', bound = ''] = /^\s*([\w.]+)\s*([<>]=?)\s*(.*?)\s*$/.exec(text) ?? [];
    const limit = this.summary.limits.find((one) => one.limit === text);
    const plain = limit !== undefined && Number.isFinite(Number(bound));
    return `${this.nameOf(quantity)} ${sign} ${plain ? valueText(limit.bound, this.unitOf(limit)) : bound.replace(/\bu(?=[a-zA-Z])/, 'µ')}`.trim();
  }

  /** What the case says of aims and limits, in words; nothing of other keys. */
  caseText(key: string, value: CaseValue | undefined): string | undefined {
    const [, aims, limits] = /^optimise\.(?:(maximise|minimise)|(limits|bearing_limits))$/.exec(key) ?? [];
    if (aims === undefined && limits === undefined) return undefined;
    const texts = [value ?? []].flat().map(String);
    return texts.map((text) => (aims === undefined ? this.limitText(text) : this.nameOf(text))).join(', ') || 'none';
  }

  /** Of a key, or of the quantity of an aim: empty of a number. */
  unitOf({ unit }: { unit: string }): string {
    return unit === '1' ? '' : unit;
  }
}
