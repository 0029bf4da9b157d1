import { describe, expect, it } from 'vitest';
import { readQuantity } from '../src/designer/quantity';
import { isValue } from '../src/designer/toml';
import { listOf, valueOf, withPoint } from '../src/designer/typed';

describe('typed numbers', () => {
  it('may have a decimal comma', () => {
    expect(['1,5', '-0,25', ',5 um', '31,8um', '1,5e-3 mm', '0,500', '1,2345'].map(withPoint)).toEqual(['1.5', '-0.25', '0.5 um', '31.8um', '1.5e-3 mm', '0.500', '1.2345']);
    expect(readQuantity(withPoint('1,5 um'))).toEqual({ number: 1.5, unit: 'um' });
  });

  it('are not cut where the comma may be another sign', () => {
    for (const typed of ['1,500', '-31,800 um', '1.234,5', '1,234.5', '1,2,3', '1 ,5', '1.5,2', '1.5.2', '1e999']) {
      expect(withPoint(typed)).toBe(typed);
      expect(readQuantity(typed), typed).toBeUndefined();
    }
    expect(readQuantity('5 1/s')).toEqual({ number: 5, unit: '1/s' });
  });
});

describe('typed lists', () => {
  it('need neither brackets nor quotes', () => {
    const two = '["1 um", "2 um"]';
    for (const typed of ['1 um, 2 um', '1 um,2 um', '1 um; 2 um', '[1 um, 2 um]', '1, 2 um', '"1 um", "2 um"', '1 um, 2 um,', two]) expect(listOf(typed), typed).toBe(two);
    expect(listOf('1; 2')).toBe('[1, 2]');
    expect(listOf('1,2,3 um')).toBe('["1 um", "2 um", "3 um"]');
    expect(listOf('1,5 um, -2 um')).toBe('["1.5 um", "-2 um"]');
    expect(listOf('1,5; 2,5 mm')).toBe('["1.5 mm", "2.5 mm"]');
    expect(listOf('+X, -Y')).toBe('["+X", "-Y"]');
    expect(listOf('5 N')).toBe('["5 N"]');
    expect(listOf('5')).toBe('[5]');
    expect(listOf('[]')).toBe('[]');
    expect(listOf('{ from = "1 um", to = "3 um", points = 5 }')).toBe('{ from = "1 um", to = "3 um", points = 5 }');
  });

  it('are texts, which the solver refuses, where one cannot tell what is meant', () => {
    expect(listOf('5,10 N')).toBe('["5,10 N"]');
    expect(listOf('1,500 um; 2 um')).toBe('["1,500 um", "2 um"]');
    expect(listOf('1 um 2 um')).toBe('["1 um 2 um"]');
    expect(valueOf('1 mm 2 mm; "')).toBe('["1 mm 2 mm", ""]');
  });

  it('stand where one value may stand, too', () => {
    expect(valueOf('4 mm; 5 mm')).toBe('["4 mm", "5 mm"]');
    expect(valueOf('{ start = "4 mm", end = "5 mm" }')).toBe('{ start = "4 mm", end = "5 mm" }');
    for (const typed of ['{ start = 4 mm, end = "5 mm" }', 'thick', '1,500', 'a "b" \\c']) expect(valueOf(typed)).toBe(JSON.stringify(typed));
  });

  it('never break the case file', () => {
    for (const typed of ['[1 um', '1 um]', '[', '"', '; ;', 'a = b', '1 # c', "'", '\\', '[[1], 2', '{', '007; 1', '1e999; 2', '3 \\u']) {
      expect(isValue(listOf(typed)), typed).toBe(true);
      expect(isValue(valueOf(typed)), typed).toBe(true);
    }
    for (const wrong of ['1 um', '[abc]', '[1 2]', '007', '1 # c', '"a" "b"', '', '{ a = b }', 'x']) expect(isValue(wrong), wrong).toBe(false);
  });
});
