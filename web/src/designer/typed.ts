/** What people type into fields, as a case file has it: decimal commas, lists without brackets. */
import { readQuantity, writeQuantity, type Quantity } from './quantity';
import { isValue } from './toml';

/** With a point for a decimal comma. Left alone where the comma may be something else, as in 1,500: the solver refuses it. */
export function withPoint(typed: string): string {
  const [, whole = '', part = '', rest = ''] = /^\s*([+-]?\d*),(\d+)(?![\d.,])([^,]*)$/.exec(typed) ?? [];
  const thousands = /^[+-]?[1-9]\d{0,2}$/.test(whole) && part.length === 3;
  return part === '' || thousands ? typed : `${whole === '' ? '0' : whole}.${part}${rest}`;
}

/** Semicolons separate, else the commas that stand between two numbers or more; one that may be a decimal comma separates nothing. */
function partsOf(typed: string): string[] {
  const inner = typed.replace(/^\[|\]$/g, '').trim();
  const several = /^[^,;]*\d,\d+,\d/.test(inner) ? inner.replaceAll(',', ';') : inner;
  const separated = several.includes(';') ? several : several.replace(/(\D),|,(?=\D|$)/g, '$1;');
  return separated.split(';').map((part) => part.trim()).filter((part) => part !== '');
}

function list(parts: string[]): string {
  const alone = parts.length === 1;
  const read = parts.map((part) => readQuantity(alone ? part : withPoint(part)));
  // A unit behind the last number is that of all: 1, 2, 3 um.
  const common = read.slice(0, -1).every((one) => one?.unit === '') ? (read[read.length - 1]?.unit ?? '') : '';
  const written = (one: Quantity | undefined, i: number): string =>
    one ? writeQuantity({ number: one.number, unit: one.unit === '' ? common : one.unit }) : JSON.stringify((parts[i] ?? '').replaceAll('"', ''));
  return `[${read.map(written).join(', ')}]`;
}

/** A value of the case file, whatever was typed: what is none becomes a text, which the solver refuses in its own words. */
export function valueOf(typed: string): string {
  if (isValue(typed)) return typed;
  const parts = typed.startsWith('{') ? [] : partsOf(typed);
  return typed.startsWith('[') || parts.length > 1 ? list(parts) : JSON.stringify(typed);
}

/** The same for a key that takes lists alone. */
export function listOf(typed: string): string {
  return /^[[{]/.test(typed) && isValue(typed) ? typed : list(partsOf(typed));
}
