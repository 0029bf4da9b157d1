import { keyTitle } from './case_values';
import type { CaseKeys, GridData, OptimiseSummary } from './format';
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

  /** Of a key, or of the quantity of an aim: empty of a number. */
  unitOf({ unit }: { unit: string }): string {
    return unit === '1' ? '' : unit;
  }
}
