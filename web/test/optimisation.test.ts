import { expect, it } from 'vitest';
import type { GridData, OptimiseSummary, Quantity } from '../src/data/format';
import { Optimisation } from '../src/data/optimisation';

const limit = (text: string, quantity: string, unit: string, bound: number): OptimiseSummary['limits'][number] => ({ limit: text, quantity, unit, bound, value: null, margin: null, active: null });
const summary = {
  limits: [limit('h_min > 8.4 um', 'h_min', 'm', 8.4e-6), limit('h_min.p5>5e-6', 'h_min.p5', 'm', 5e-6), limit('loss_factor < 0.3', 'loss_factor', '1', 0.3)],
} as unknown as OptimiseSummary;
const result = new Optimisation(
  {
    summary,
    quantities: [{ name: 'h_min', label: 'minimum film thickness' } as Quantity],
    dimensions: {},
    variables: {},
  } as unknown as GridData,
  {},
);

it('tells limits in words with units', () => {
  expect(result.limitText('h_min > 8.4 um')).toBe('minimum film thickness > 8.4 µm');
  expect(result.limitText('h_min.p5>5e-6')).toBe('minimum film thickness, 5th percentile > 5 µm');
  expect(result.limitText('loss_factor < 0.3')).toBe('loss_factor < 0.3');
});

it('tells what a case says of aims and limits, and leaves other keys to others', () => {
  expect(result.caseText('optimise.minimise', 'h_min.mean')).toBe('minimum film thickness, mean');
  expect(result.caseText('optimise.maximise', ['h_min', 'yield'])).toBe('minimum film thickness, yield');
  expect(result.caseText('optimise.bearing_limits', ['h_min > 5 um'])).toBe('minimum film thickness > 5 µm');
  expect(result.caseText('optimise.limits', [])).toBe('none');
  expect(result.caseText('optimise.command', 'cycle')).toBeUndefined();
});
