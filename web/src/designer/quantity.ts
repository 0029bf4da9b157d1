/** Quantities as they are written in a case file: "31.8 um", or a plain number in SI. */
import type { Units } from './format';

export interface Quantity {
  number: number;
  /** Empty for a plain number. */
  unit: string;
}

const quantity = /^\s*"?\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?![\d.])\s*([^",]*?)\s*"?\s*$/;

/** Nothing where the text is no number, with or without a unit. */
export function readQuantity(written: string): Quantity | undefined {
  const [, number, unit] = quantity.exec(written.replaceAll('_', '')) ?? [];
  return number === undefined || !Number.isFinite(Number(number)) ? undefined : { number: Number(number), unit: unit ?? '' };
}

/** As a case file has it. */
export function writeQuantity({ number, unit }: Quantity): string {
  return unit === '' ? String(number) : JSON.stringify(`${number} ${unit}`);
}

/** Size of a unit in SI, where the page knows it. */
export function sizeOf(unit: string, si: string, units: Units): number | undefined {
  return unit === '' || unit === si ? 1 : units[si]?.[unit];
}

/** The same in another unit, without the noise of the conversion. */
export function converted({ number, unit }: Quantity, to: string, si: string, units: Units): Quantity | undefined {
  const [from, into] = [sizeOf(unit, si, units), sizeOf(to, si, units)];
  if (from === undefined || into === undefined) return undefined;
  return { number: Number(((number * from) / into).toPrecision(12)), unit: to };
}
