import { describe, expect, it } from 'vitest';
import { differences, formatNumber, formatQuantity, scaleFor } from '../src/data/units';

describe('prefixes', () => {
  it('bring the largest number between 1 and 1000', () => {
    expect(scaleFor(79.5e-6, 'm').unit).toBe('µm');
    expect(scaleFor(79.5e-6, 'm').factor * 79.5e-6).toBeCloseTo(79.5, 10);
    expect(scaleFor(628.3, 'rad/s').unit).toBe('Hz');
    expect(scaleFor(2e-6, 'm3/s')).toEqual({ factor: 1e6, unit: 'cm³/s' });
    expect(scaleFor(851, 'N')).toEqual({ factor: 1, unit: 'N' });
    expect(scaleFor(9.3e6, 'N/m').unit).toBe('MN/m');
    expect(scaleFor(12.6e-3, 'J').unit).toBe('mJ');
    expect(formatQuantity(0.5, 'kg')).toBe('0.5000 kg');
    expect(formatQuantity(4e-3, 'kg m2')).toBe('0.004000 kg m²');
    expect(formatQuantity(100 * Math.PI, 'rpm')).toBe('3000 rpm');
  });

  it('change where rounding reaches the next one', () => {
    expect(formatQuantity(999.96, 'N')).toBe('1.000 kN');
    expect(formatQuantity(999.9, 'N')).toBe('999.9 N');
  });

  it('are none where there is nothing to scale', () => {
    expect(scaleFor(0, 'N')).toEqual({ factor: 1, unit: 'N' });
    expect(scaleFor(NaN, 'N')).toEqual({ factor: 1, unit: 'N' });
    expect(scaleFor(5e-9, '')).toEqual({ factor: 1, unit: '' });
  });
});

describe('numbers', () => {
  it('have significant digits and a true minus sign', () => {
    expect(formatNumber(739.3484)).toBe('739.3');
    expect(formatNumber(-0.0598690)).toBe('−0.05987');
    expect(formatNumber(0)).toBe('0');
    expect(formatNumber(3.315e-13, 2)).toBe('3.3·10⁻¹³');
  });

  it('are a dash where they are not known', () => {
    for (const unknown of [null, undefined, NaN, Infinity]) {
      expect(formatNumber(unknown)).toBe('–');
      expect(formatQuantity(unknown, 'N')).toBe('–');
    }
  });
});

describe('differences from a reference', () => {
  it('have a sign, the unit of the line, and a share of the reference', () => {
    expect(differences(110, 100, { factor: 1, unit: 'N' })).toEqual(['+10.0', '+10.0 %']);
    expect(differences(-0.09, -0.1, { factor: 1e3, unit: 'mJ' })).toEqual(['+10.0', '+10.0 %']);
    expect(differences(90, 100, { factor: 1e-3, unit: 'kN' })).toEqual(['−0.0100', '−10.0 %']);
  });

  it('are none where there is nothing to tell', () => {
    expect(differences(5, 5, { factor: 1, unit: 'N' })).toEqual(['0', '0 %']);
    expect(differences(5, 0, { factor: 1, unit: 'N' })).toEqual(['+5.00', '–']);
    expect(differences(null, 5, { factor: 1, unit: 'N' })).toEqual(['–', '–']);
  });
});
