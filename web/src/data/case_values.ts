/** Values of a case by their keys, and how people write them. */
import type { CaseKeys, CaseValue } from './format';
import { vectorText } from './grid';
import { directionName } from './kinds';
import type { Run } from './run';
import { formatNumber, formatQuantity } from './units';

/** Entries of a list that are written out: matrices of a rotor and measured loops have thousands. */
const mostShown = 100;
/** Angles below it are in mrad, rad. */
const smallAngle = 5e-3;

type Table = { [key: string]: CaseValue };

function isTable(value: CaseValue): value is Table {
  return value !== null && typeof value === 'object' && !Array.isArray(value);
}

/** Dotted keys with their values, in the order of the case; tables of a list are counted from 1: "bump_foil.shim[2].to". */
export function flatten(value: CaseValue, path = ''): Map<string, CaseValue> {
  const entries = new Map<string, CaseValue>();
  if (Array.isArray(value) && value.length > 0 && value.every(isTable)) {
    value.forEach((table, i) => {
      for (const [name, leaf] of flatten(table, `${path}[${i + 1}]`)) entries.set(name, leaf);
    });
  } else if (isTable(value) && !('law' in value)) {
    for (const [key, part] of Object.entries(value)) {
      for (const [name, leaf] of flatten(part, path === '' ? key : `${path}.${key}`)) entries.set(name, leaf);
    }
  } else {
    entries.set(path, value);
  }
  return entries;
}

/** What is said of a key or a table; of a list of tables, of the first. */
export function labelOf(keys: CaseKeys, path: string): CaseKeys[string] | undefined {
  const first = path.replace(/\[\d+\]/g, '[1]');
  // Bearings of a rotor, and foils of pads, have the keys of the common ones.
  return keys[first] ?? keys[first.replace(/^rotor\.bearing\[1\]\./, '').replace(/^pad\[1\]\./, '')];
}

/** A key by its table and its title, as sweeps call it: "Bearing: Radial clearance". */
export function keyTitle(keys: CaseKeys, path: string): string {
  const title = labelOf(keys, path)?.title;
  return title === undefined ? path : [titleOf(keys, groupOf(path)), title].filter((words) => words !== undefined).join(': ');
}

/** Of keys of angular frequency, as they are written or with underscores in place of dots: whether it is that of a rotation. */
export function isSpeed(path: string): boolean {
  return path.includes('speed');
}

/** Unit that the numbers of a key, SI, are shown in; of one that takes lengths or forces, which of both the keys beside it are. */
export function unitOf(keys: CaseKeys, path: string, entries: Map<string, CaseValue>): string {
  const table = groupOf(path);
  // Bounds of a key that is fitted or chosen are in the unit of that key.
  const chosen = entries.get(`${table}.key`);
  if (typeof chosen === 'string' && ['start', 'lower', 'upper', 'mean', 'std'].some((name) => path === `${table}.${name}`)) return unitOf(keys, chosen, entries);
  // A centre or a point that is a load is written as a text, with its unit.
  if (path === 'path.centre' || path === 'path.points') return 'm';
  if (path === 'path.semi_axes') return [entries.get('path.centre')].flat().some((one) => typeof one === 'string') ? 'N' : 'm';
  if (path === `${table}.preload`) return entries.has(`${table}.load`) ? 'N' : 'm';
  const unit = labelOf(keys, path)?.unit ?? '';
  // As they are written.
  if (unit === 'rad/s') return isSpeed(path) ? 'rpm' : 'Hz';
  return unit;
}

/** The title of a table, counted where there may be several. */
export function titleOf(keys: CaseKeys, table: string): string | undefined {
  const title = labelOf(keys, table)?.title;
  const number = /\[(\d+)\]$/.exec(table)?.[1];
  return title === undefined || number === undefined ? title : `${title} ${number}`;
}

function isVector(value: CaseValue): value is [number, number] {
  return Array.isArray(value) && value.length === 2 && value.every((one) => typeof one === 'number');
}

/** Whether numbers are so many, and in steps so equal, that the first and the last say all. */
function isEven(values: CaseValue[]): boolean {
  const [first, last] = [Number(values[0]), Number(values[values.length - 1])];
  const due = (i: number): number => first + ((last - first) * i) / (values.length - 1);
  return values.length > 4 && first !== last && values.every((value, i) => typeof value === 'number' && Math.abs(value - due(i)) <= 1e-9 * Math.abs(last - first));
}

export function valueText(value: CaseValue | undefined, unit: string): string {
  if (value === undefined || value === null) return '–';
  // What goes along the foil by a law.
  if (isTable(value) && 'law' in value) return `${valueText(value['start'], unit)} to ${valueText(value['end'], unit)}, ${String(value['law'])}`;
  if (Array.isArray(value) && value.length > 0 && value.every(isVector)) return value.map(([x, y]) => vectorText(x, y, unit)).join(', ');
  if (Array.isArray(value) && isEven(value)) return `${valueText(value[0], unit)} to ${valueText(value[value.length - 1], unit)} in ${value.length - 1} equal steps`;
  if (Array.isArray(value) && value.length > mostShown) return `${value.length} values`;
  if (Array.isArray(value)) return value.length === 0 ? 'none' : value.map((one) => valueText(one, unit)).join(', ');
  if (typeof value === 'object') return JSON.stringify(value);
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  // Words; keys of the case stay as they are.
  if (typeof value !== 'number') return String(value).replace(/^[^.]*$/, (words) => words.replaceAll('_', ' ')).replace(/^-(?=\d)/, '−');
  if (unit === 'direction') return directionName(Number(((value * 180) / Math.PI).toPrecision(9)));
  if (unit === 'rpm') return `${Number(((value * 30) / Math.PI).toPrecision(6))} rpm`.replace('-', '−');
  if (unit === 'Hz') return `${Number((value / (2 * Math.PI)).toPrecision(6))} Hz`;
  // As slopes are written.
  if (unit === 'rad' && value !== 0 && Math.abs(value) < smallAngle) return `${Number((1e3 * value).toPrecision(6))} mrad`.replace('-', '−');
  if (unit === 'rad') return `${Number(((value * 180) / Math.PI).toPrecision(6))}°`.replace('-', '−');
  if (unit !== '') return trimmed(formatQuantity(value, unit, 5));
  return Number.isInteger(value) ? String(value) : trimmed(formatNumber(value, 5));
}

/** "38.100 mm" as it was meant: "38.1 mm". */
function trimmed(text: string): string {
  return text.replace(/(\.\d*?)0+(?=\D|$)/, '$1').replace(/\.(?=\D|$)/, '');
}

/** The table that a key is in; empty for keys of none. */
export function groupOf(key: string): string {
  return key.includes('.') ? key.slice(0, key.lastIndexOf('.')) : '';
}

/** A number of the case in which runs differ: they are a family over it. */
export interface SweptKey {
  title: string;
  unit: string;
  values: Map<Run, number>;
}

export function sweptKeys(runs: Run[], keys: CaseKeys): SweptKey[] {
  const cases = runs.map((run) => flatten(run.data.summary.case));
  const swept: (SweptKey & { group: string })[] = [];
  for (const path of cases[0]?.keys() ?? []) {
    const numbers = cases.map((entries) => entries.get(path));
    if (!numbers.every((number): number is number => typeof number === 'number')) continue;
    if (new Set(numbers).size < 2) continue;
    const group = groupOf(path);
    const title = titleOf(keys, group);
    const unit = labelOf(keys, path)?.unit ?? '';
    // One key may stand for several of its table, as the coefficient of friction for those of both interfaces.
    const same = swept.find((one) => one.group === group && one.unit === unit && runs.every((run, i) => one.values.get(run) === numbers[i]));
    if (same && title !== undefined) {
      same.title = title;
      continue;
    }
    const words = [title, labelOf(keys, path)?.title ?? path].filter((word) => word !== undefined);
    swept.push({ group, unit, title: words.join(': '), values: new Map(runs.map((run, i) => [run, numbers[i] ?? NaN])) });
  }
  return swept;
}
