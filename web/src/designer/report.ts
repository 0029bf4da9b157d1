/** The page of `bumpfoil report` about what was computed here. */
import type { CaseKeys, ReportData, RunData } from '../data/format';
import type { CyclesAnswer, KeysAnswer } from './format';
import { bytesIn } from './solver';

const placeholder = '@bumpfoil-report-data@';

/** @param designs  by the names that the report calls them; others are compared with the first */
export function reportOf({ version, commit, keys }: KeysAnswer, designs: Record<string, { answer: CyclesAnswer; text: string }>): string {
  const labels: CaseKeys = Object.fromEntries(
    keys.map(({ path, title, kind, unit }) => [path, { title, ...(kind === 'list of directions' ? { unit: 'direction' } : unit === undefined ? {} : { unit }) }]),
  );
  const origin = { source: `bumpfoil ${version} (${commit}), designer`, date_created: new Date().toISOString().replace(/\.\d+Z$/, 'Z') };
  const runs = Object.entries(designs).map(([name, { answer, text }]): RunData => {
    const { run } = answer;
    return { ...run, name, attributes: { ...run.attributes, ...origin, case_text: text } };
  });
  const report: ReportData = { schema: 'bumpfoil-report/1', version, commit, keys: labels, runs };
  // No text in it can end the element that holds it.
  const json = JSON.stringify(report).replaceAll('<', '\\u003c');
  return new TextDecoder().decode(bytesIn('bumpfoil-report-page')).replace(placeholder, () => json);
}
