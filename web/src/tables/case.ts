import { directionName } from '../data/kinds';
import type { Run } from '../data/run';
import type { CaseValue } from '../data/format';
import { toCsv } from '../data/csv';
import { formatNumber, formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import { panel } from '../ui/panel';

/** Names and units of keys of the case file. Keys that are not here are shown as they are. */
const names: Record<string, [text: string, unit: string]> = {
  'bearing.radius': ['Radius', 'm'],
  'bearing.axial_length': ['Axial length', 'm'],
  'bearing.radial_clearance': ['Radial clearance', 'm'],
  'bearing.weld_angle': ['Weld angle', 'rad'],
  'bearing.wrap': ['Sense of winding', ''],
  'bump_foil.model': ['Model', ''],
  'bump_foil.geometry': ['Displacements', ''],
  'bump_foil.bumps': ['Bumps', ''],
  'bump_foil.pitch': ['Pitch', 'm'],
  'bump_foil.length': ['Length of a bump', 'm'],
  'bump_foil.height': ['Height of a bump', 'm'],
  'bump_foil.height_reference': ['Height is', ''],
  'bump_foil.thickness': ['Thickness', 'm'],
  'bump_foil.youngs_modulus': ['Young’s modulus', 'Pa'],
  'bump_foil.poisson_ratio': ['Poisson’s ratio', ''],
  'bump_foil.yield_stress': ['Yield stress', 'Pa'],
  'bump_foil.stiffness_follows_height': ['Stiffness follows height', ''],
  'bump_foil.height_errors': ['Height errors', 'm'],
  'bump_foil.sleeve_gaps': ['Sleeve gaps', 'm'],
  'bump_foil.weld_at': ['Weld at', ''],
  'bump_foil.truss.k1': ['k₁', 'N/m'],
  'bump_foil.truss.k2': ['k₂', 'N/m'],
  'bump_foil.truss.k3': ['k₃', 'N/m'],
  'bump_foil.truss.k4': ['k₄', 'N/m'],
  'bump_foil.truss.theta_d': ['Inclination of the rods', 'rad'],
  'top_foil.thickness': ['Thickness', 'm'],
  'top_foil.youngs_modulus': ['Young’s modulus', 'Pa'],
  'top_foil.poisson_ratio': ['Poisson’s ratio', ''],
  'top_foil.yield_stress': ['Yield stress', 'Pa'],
  'friction.top_bump': ['Top foil on bumps', ''],
  'friction.bump_sleeve': ['Bumps on sleeve', ''],
  'solver.name': ['Name', ''],
  'solver.eps_alm': ['Penalty, normal contacts', 'N/m'],
  'solver.eps_f': ['Penalty, sticking contacts', 'N/m'],
  'solver.eps_r': ['Penalty, journal', 'N/m'],
  'solver.tau_f': ['Slip of half friction', 'm'],
  'cycle.directions': ['Directions', 'direction'],
  'cycle.amplitude': ['Amplitude', 'm'],
  'cycle.steps': ['Increments per branch', ''],
  'strip.bumps': ['Bumps', ''],
  'strip.weld': ['Weld', ''],
  'strip.top_foil': ['Top foil', ''],
  'strip.displacement': ['Displacement', 'm'],
  'strip.load': ['Load', 'N'],
  'strip.cycles': ['Cycles', ''],
  'strip.steps': ['Increments per branch', ''],
};

const groups: Record<string, string> = {
  bearing: 'Bearing',
  bump_foil: 'Bump foil',
  'bump_foil.truss': 'Given constants of the truss',
  top_foil: 'Top foil',
  friction: 'Coefficients of friction',
  solver: 'Solver',
  cycle: 'Cycle',
  strip: 'Strip',
};

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

export function valueText(key: string, value: CaseValue | undefined): string {
  const unit = names[key]?.[1] ?? '';
  if (value === undefined || value === null) return '–';
  if (Array.isArray(value)) return value.length === 0 ? 'none' : value.map((one) => valueText(key, one)).join(', ');
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
export function caseTable(runs: Run[]): HTMLElement {
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
          el('tr', {}, el('th', { scope: 'col', class: 'group', colspan: several ? 1 : 2 }, groups[group] ?? group), ...labels),
        ),
      );
    }
    const texts = cases.map((entries) => valueText(key, entries.get(key)));
    const differs = new Set(texts).size > 1;
    tables[tables.length - 1]?.append(
      el(
        'tr',
        differs ? { class: 'differs' } : {},
        el('th', { scope: 'row' }, names[key]?.[0] ?? key.slice(key.lastIndexOf('.') + 1)),
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
