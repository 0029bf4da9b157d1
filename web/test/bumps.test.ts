import { describe, expect, it } from 'vitest';
import { mainQuantities } from '../src/data/main_quantities';
import { alongFoil } from '../src/designer/bump_table';
import { withCycle } from '../src/designer/loops';

describe('a dimension along the foil', () => {
  it('is alike, listed, or by a law', () => {
    expect(alongFoil(2, 3)).toEqual([2, 2, 2]);
    expect(alongFoil([1, 2], 3)).toEqual([1, 2, 0]);
    expect(alongFoil({ start: 1, end: 4, law: 'linear' }, 4)).toEqual([1, 2, 3, 4]);
    alongFoil({ start: 1, end: 8, law: 'geometric' }, 4).forEach((value, i) => expect(value).toBeCloseTo(2 ** i, 12));
    expect(alongFoil({ start: 1, end: 4, law: 'linear' }, 1)).toEqual([1]);
    expect(alongFoil(undefined, 2)).toEqual([0, 0]);
  });
});

describe('a case without cycles', () => {
  const key = { title: '', text: '', kind: 'length', presence: 'required' as const };
  const keys = [{ ...key, path: 'cycle.directions', value: [0, 1] }, { ...key, path: 'cycle.amplitude', value: 5e-5 }, { ...key, path: 'cycle.steps', value: 100 }];

  it('has those of the reference case', () => {
    expect(withCycle('a = 1\n', keys)).toBe('a = 1\n\n[cycle]\ndirections = [0,1]\namplitude = 0.00005\n');
    expect(withCycle('[cycle]\nsteps = 2\n', keys)).toBe('[cycle]\nsteps = 2\n');
  });
});

describe('main quantities', () => {
  const quantity = (name: string, leads = false, key_figure = false) => ({ name, leads, key_figure, first: false });
  const names = (...given: Parameters<typeof mainQuantities>): string[] => mainQuantities(...given).map(({ name }) => name);

  it('are those that limits are set on, then the leading one and key figures', () => {
    const all = [quantity('x'), quantity('max_force', false, true), quantity('gap'), quantity('loss_factor', false, true), quantity('loaded_stiffness', true)];
    expect(names(all)).toEqual(['loaded_stiffness', 'max_force', 'loss_factor']);
    expect(names(all, ['x', 'none'])).toEqual(['x', 'loaded_stiffness', 'max_force']);
    expect(names(all.slice(0, 3))).toEqual(['max_force', 'x', 'gap']);
  });
});
