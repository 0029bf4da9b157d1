/** SI numbers as engineers write them. */

export interface Scale {
  /** Shown = SI number times this. */
  factor: number;
  /** With its prefix; empty where there is none. */
  unit: string;
}

const prefixes: Record<number, string> = {
  [-12]: 'p',
  [-9]: 'n',
  [-6]: 'µ',
  [-3]: 'm',
  0: '',
  3: 'k',
  6: 'M',
  9: 'G',
  12: 'T',
};

/** Units that people write in another way: a prefix of a volume would mean its cube, and kg has one. Of rpm the SI number is in rad/s. */
const written: Record<string, Scale> = {
  'rad/s': { factor: 0.5 / Math.PI, unit: 'Hz' },
  rpm: { factor: 30 / Math.PI, unit: 'rpm' },
  'm3/s': { factor: 1e6, unit: 'cm³/s' },
  'kg m': { factor: 1e6, unit: 'g mm' },
  kg: { factor: 1, unit: 'kg' },
  'kg m2': { factor: 1, unit: 'kg m²' },
  'm/s2': { factor: 1, unit: 'm/s²' },
};

/** The prefix that brings `largest` between 1 and 1000. */
export function scaleFor(largest: number, unit: string): Scale {
  if (written[unit]) return written[unit];
  if (unit === '' || !(largest > 0) || !Number.isFinite(largest)) return { factor: 1, unit };
  // Half a unit of the fourth digit more, so that 999.99 becomes 1 of the next prefix.
  const exponent = Math.min(12, Math.max(-12, 3 * Math.floor(Math.log10(largest * 1.00005) / 3)));
  return { factor: 10 ** -exponent, unit: `${prefixes[exponent] ?? ''}${unit}` };
}

/** A number with some significant digits, a true minus sign, and no exponent where it is usual; "–" if not known. */
export function formatNumber(number: number | null | undefined, digits = 4): string {
  if (number === null || number === undefined || !Number.isFinite(number)) return '–';
  if (number === 0) return '0';
  // Rounded first, so that 9.9996 has no digit too many.
  const size = Math.abs(Number(number.toPrecision(Math.max(1, digits))));
  let text: string;
  if (size < 1e-3 || size >= 1e6) {
    const [mantissa, exponent] = number.toExponential(digits - 1).split('e');
    text = `${mantissa}·10${superscript(Number(exponent))}`;
  } else {
    text = number.toFixed(Math.max(0, digits - 1 - Math.floor(Math.log10(size))));
  }
  return text.replace('-', '−');
}

function superscript(number: number): string {
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  return String(number).replace(/./g, (sign) => (sign === '-' ? '⁻' : (digits[Number(sign)] ?? '')));
}

/** "739.3 N" */
export function formatQuantity(number: number | null | undefined, unit: string, digits = 4): string {
  const scale = scaleFor(Math.abs(number ?? 0), unit);
  const text = formatNumber(number === null || number === undefined ? number : number * scale.factor, digits);
  return text === '–' || scale.unit === '' ? text : `${text} ${scale.unit}`;
}

/** "Direct force (N)" */
export function axisTitle(name: string, scale: Scale): string {
  return scale.unit === '' ? name : `${name} (${scale.unit})`;
}

/** By how much a value differs from that of the reference: in the unit of the line, and in percent of the reference. */
export function differences(value: number | null, reference: number | null, scale: Scale): [string, string] {
  if (value === null || reference === null) return ['–', '–'];
  const difference = value - reference;
  const sign = difference > 0 ? '+' : '';
  // Below the digits of the values themselves there is nothing to be said.
  const none = Math.abs(difference) <= 1e-9 * Math.max(Math.abs(value), Math.abs(reference));
  if (none) return ['0', '0 %'];
  const absolute = `${sign}${formatNumber(difference * scale.factor, 3)}`;
  return [absolute, reference === 0 ? '–' : `${sign}${formatNumber((100 * difference) / Math.abs(reference), 3)} %`];
}
