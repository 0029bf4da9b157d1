import { directionName } from '../data/kinds';
import type { Run } from '../data/run';
import type { CaseKeys, CaseValue } from '../data/format';
import { toCsv } from '../data/csv';
import { formatNumber, formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import { panel } from '../ui/panel';

type Entries = Map<string, CaseValue>;

/** Dotted keys with their values, in the order of the case. */
export function flatten(value: CaseValue, path = ''): Entries {
  const entries: Entries = new Map();
  if (value !== null && typeof value === 'object' && !Array.isArray(value)) {
    for (const [key, part] of Object.entries(value)) {
      for (const [name, leaf] of flatten(part, path === '' ? key : `${path}.${key}`)) entries.set(name, leaf);
    }
  } else {
    entries.set(path, value);
  }
  return entries;
}

export function valueText(value: CaseValue | undefined, unit: string): string {
  if (value === undefined || value === null) return '–';
  if (Array.isArray(value)) return value.length === 0 ? 'none' : value.map((one) => valueText(one, unit)).join(', ');
  if (typeof value === 'object') return JSON.stringify(value);
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value !== 'number') return String(value).replaceAll('_', ' ');
  if (unit === 'direction') return directionName(Number(((value * 180) / Math.PI).toPrecision(9)));
  if (unit === 'rad') return `${Number(((value * 180) / Math.PI).toPrecision(6))}°`.replace('-', '−');
  if (unit !== '') return trimmed(formatQuantity(value, unit, 5));
  return Number.isInteger(value) ? String(value) : trimmed(formatNumber(value, 5));
}

/** "38.100 mm" as it was meant: "38.1 mm". */
function trimmed(text: string): string {
  return text.replace(/(\.\d*?)0+(?=\D|$)/, '$1').replace(/\.(?=\D|$)/, '');
}

function groupOf(key: string): string {
  return key.includes('.') ? key.slice(0, key.lastIndexOf('.')) : '';
}

/** The cases as the program understood them; where runs differ, the line is marked. */
export function caseTable(runs: Run[], caseKeys: CaseKeys): HTMLElement {
  const cases = runs.map((run) => flatten(run.data.summary.case));
  const keys = [...new Set(cases.flatMap((entries) => [...entries.keys()]))].filter((key) => key !== 'title');
  const several = runs.length > 1;
  const tables: HTMLElement[] = [];
  let group: string | undefined;
  for (const key of keys) {
    if (groupOf(key) !== group) {
      group = groupOf(key);
      const labels = several ? runs.map((run) => el('th', { scope: 'col' }, run.label)) : [];
      tables.push(
        el(
          'table',
          { class: 'case' },
          el('tr', {}, el('th', { scope: 'col', class: 'group', colspan: several ? 1 : 2 }, caseKeys[group]?.title ?? group), ...labels),
        ),
      );
    }
    const texts = cases.map((entries) => valueText(entries.get(key), caseKeys[key]?.unit ?? ''));
    const differs = new Set(texts).size > 1;
    tables[tables.length - 1]?.append(
      el(
        'tr',
        differs ? { class: 'differs' } : {},
        el('th', { scope: 'row' }, caseKeys[key]?.title ?? key.slice(key.lastIndexOf('.') + 1)),
        ...texts.map((text) => el('td', {}, text)),
      ),
    );
  }
  return panel(
    {
      title: 'Case',
      ...(several ? { note: 'Lines in which the runs differ are marked.' } : {}),
      file: () => 'case',
      csv: () =>
        toCsv(
          ['key', ...runs.map((run) => run.label)],
          keys.map((key) => [
            key,
            ...cases.map((entries) => {
              const value = entries.get(key);
              return value !== null && typeof value === 'object' ? JSON.stringify(value) : value;
            }),
          ]),
        ),
    },
    el('div', { class: several ? 'scroller' : 'groups', tabindex: 0, role: 'group', 'aria-label': 'The case' }, ...tables),
  );
}

/** Where each run comes from. */
export function provenance(run: Run): HTMLElement {
  const rows: [string, string][] = [
    ['Folder', run.data.name],
    ['Made by', run.attribute('source')],
    ['On', run.attribute('date_created')],
    ['Command', run.attribute('command_line')],
    ['Solver', run.data.summary.solver],
    ['Status', run.data.summary.status],
  ];
  const lines = rows.filter(([, value]) => value !== '').flatMap(([name, value]) => [el('dt', {}, name), el('dd', {}, value)]);
  const text = (title: string, contents: string): HTMLElement[] =>
    contents === '' ? [] : [el('details', {}, el('summary', {}, title), el('pre', { tabindex: 0 }, contents))];
  return el(
    'section',
    { class: 'panel provenance', 'aria-label': `Origin of ${run.label}` },
    el('header', {}, el('h3', {}, run.label)),
    el('dl', {}, ...lines),
    ...text('Case file as written', run.attribute('case_text')),
    ...text('Case as understood: a case file that gives the same results', run.attribute('case_understood')),
  );
}
