import type { ResultData } from './format';

/** The results of one folder. */
export class Result<Data extends ResultData = ResultData> {
  constructor(public data: Data) {}

  /** Tells it from the others of the report. */
  get label(): string {
    return this.data.name;
  }

  attribute(name: string): string {
    return this.data.attributes[name] ?? '';
  }

  /** "interrupted", "failed"; empty for complete results. */
  get outcome(): string {
    const { status } = this.data.summary;
    return status === 'complete' ? '' : status;
  }
}
