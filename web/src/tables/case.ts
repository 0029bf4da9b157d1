import { deviationChart } from '../charts/deviations';
import { flatten, groupOf, keyTitle, labelOf, titleOf, unitOf, valueText } from '../data/case_values';
import type { CaseKeys, CaseValue } from '../data/format';
import type { Result } from '../data/result';
import { toCsv } from '../data/csv';
import { el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';

/** Results whose cases stand side by side. */
export interface ComparedCases {
  several: boolean;
  /** Whose cases are shown. */
  focus: Result[];
  /** All that are compared. */
  shown: Result[];
  names: string;
  onChange(listener: () => void): void;
}

/** What else there is to say. */
export interface CaseWords {
  /** What keeps a result from being complete. */
  shortfalls(result: Result): string[];
  /** Of the cases that are shown. */
  note: string;
  /** A value in words of its result; nothing of those that are written as all are. */
  text?(result: Result, key: string, value: CaseValue | undefined): string | undefined;
}

/** The cases of the results in focus as the program understood them; where those shown differ, the line is marked. */
function tables({ several, focus, shown }: ComparedCases, caseKeys: CaseKeys, words: CaseWords): HTMLElement[] {
  const cases = new Map(shown.map((run) => [run, flatten(run.data.summary.case)]));
  const tables: HTMLElement[] = [];
  let group: string | undefined;
  for (const key of keysOf(shown)) {
    if (groupOf(key) !== group) {
      group = groupOf(key);
      const labels = several ? focus.map((run) => el('th', { scope: 'col' }, run.label)) : [];
      tables.push(
        el(
          'table',
          { class: 'case' },
          el('tr', {}, el('th', { scope: 'col', class: 'group', colspan: several ? 1 : 2 }, titleOf(caseKeys, group) ?? group), ...labels),
        ),
      );
    }
    const text = (run: Result): string => {
      const entries = cases.get(run) ?? new Map<string, CaseValue>();
      const value = entries.get(key);
      if (typeof value === 'string' && key.endsWith('].key')) return keyTitle(caseKeys, value);
      return words.text?.(run, key, value) ?? valueText(value, unitOf(caseKeys, key, entries));
    };
    const differs = new Set(shown.map(text)).size > 1;
    tables[tables.length - 1]?.append(
      el(
        'tr',
        differs ? { class: 'differs' } : {},
        el('th', { scope: 'row' }, labelOf(caseKeys, key)?.title ?? key.slice(key.lastIndexOf('.') + 1)),
        ...focus.map((run) => el('td', {}, text(run))),
      ),
    );
  }
  return tables;
}

/** Whether a result is of foils without a film: it has nothing of gas and film. */
function isDry({ data }: Result): boolean {
  const ofStates = 'states' in data && Array.isArray(data.states) && data.states.length > 0;
  return ['cycle', 'strip', 'path', 'vibration', 'montecarlo', 'fit', 'optimise'].includes(data.attributes['swept_command'] ?? data.kind) && !ofStates;
}

function keysOf(runs: Result[]): string[] {
  const keys = [...new Set(runs.flatMap((run) => [...flatten(run.data.summary.case).keys()]))];
  const dry = runs.every(isDry);
  return keys.filter((key) => key !== 'title' && !(dry && /^(gas|film)\./.test(key)));
}

function csv(runs: Result[]): string {
  const cases = runs.map((run) => flatten(run.data.summary.case));
  return toCsv(
    ['key', ...runs.map((run) => run.label)],
    keysOf(runs).map((key) => [
      key,
      ...cases.map((entries) => {
        const value = entries.get(key);
        return value !== null && typeof value === 'object' ? JSON.stringify(value) : value;
      }),
    ]),
  );
}

/** Where a run comes from, and how it ended. */
function provenance(run: Result, shortfalls: string[]): HTMLElement {
  const rows: [string, string][] = [
    ['Created by', run.attribute('source')],
    ['On', run.attribute('date_created')],
    ['Command', run.attribute('command_line')],
    ['Solver', run.data.summary.solver],
    ['Status', [run.data.summary.status, ...shortfalls].join('; ')],
  ];
  const lines = rows.filter(([, value]) => value !== '').flatMap(([name, value]) => [el('dt', {}, name), el('dd', {}, value)]);
  const text = (title: string, contents: string): HTMLElement[] =>
    contents === ''
      ? []
      : [el('details', {}, el('summary', {}, title), el('pre', { tabindex: 0, role: 'group', 'aria-label': `${title}: ${run.label}` }, contents))];
  return el(
    'section',
    { class: 'panel provenance', 'aria-label': `Origin of ${run.label}` },
    el('header', {}, el('h3', {}, run.label)),
    el('dl', {}, ...lines),
    ...text('Case file as written', run.attribute('case_text')),
    ...text('Case as interpreted: a case file that reproduces the results', run.attribute('case_understood')),
  );
}

/** The case and the origin of the results in focus. */
export function caseSection(comparison: ComparedCases, caseKeys: CaseKeys, words: CaseWords): HTMLElement {
  const { several } = comparison;
  const place = el('div', { class: several ? 'scroller' : 'groups', tabindex: 0, role: 'group', 'aria-label': 'The case' });
  const origins = el('div', { class: 'multiples' });
  const panel = new Panel(
    {
      title: 'Case',
      subject: () => [comparison.names, words.note].filter((text) => text !== '').join(' · '),
      file: () => fileName('case', comparison.names),
      csv: () => csv(comparison.shown),
    },
    place,
  );
  const fill = (): void => {
    panel.refresh();
    place.replaceChildren(...tables(comparison, caseKeys, words));
    origins.replaceChildren(...comparison.focus.map((run) => provenance(run, words.shortfalls(run))));
  };
  comparison.onChange(fill);
  fill();
  return el('div', {}, ...deviationChart(comparison, comparison.shown), panel.root, origins);
}
