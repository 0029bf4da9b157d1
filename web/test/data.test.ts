import { describe, expect, it } from 'vitest';
import { stretchesOf } from '../src/charts/stretches';
import { labelOffsets } from '../src/charts/label_offsets';
import { flatten, labelOf, sweptKeys, titleOf, unitOf, valueText } from '../src/data/case_values';
import { toCsv } from '../src/data/csv';
import { decodeFlags, decodeNumbers } from '../src/data/decode';
import type { CycleData } from '../src/data/format';
import { directionName } from '../src/data/kinds';
import { thinningOf, warningsOf } from '../src/data/outcome';
import { Cycle, Run, largest } from '../src/data/run';
import { wrapped } from '../src/ui/lines';

function base64(bytes: ArrayBuffer): string {
  return btoa(String.fromCharCode(...new Uint8Array(bytes)));
}

/** Two bumps, `states` increment by increment. */
function cycle(displacement: number[], steps: number, states: number[][]): Cycle {
  const data: CycleData = {
    at: 90,
    increments: displacement.map((_, i) => i),
    series: {
      displacement: base64(new Float32Array(displacement).buffer),
      branch: base64(new Int8Array(displacement.map((_, i) => (i <= steps ? 0 : 1))).buffer),
    },
    fields: { state_top_bump: { at: 'bump', values: base64(new Int8Array(states.flat()).buffer) } },
  };
  return new Cycle(data, { bump: 2, foot: 2 }, 2 * steps, '+Y', undefined, steps, Math.max(...displacement));
}

describe('base64', () => {
  it('gives numbers and flags back, NaN for what is absent', () => {
    const numbers = new Float32Array([1.5, -3e-6, NaN, 0]);
    expect([...decodeNumbers(base64(numbers.buffer))]).toEqual([...numbers]);
    expect([...decodeFlags(base64(new Int8Array([0, 3, -127]).buffer))]).toEqual([0, 3, -127]);
    expect(decodeNumbers('')).toHaveLength(0);
  });
});

describe('directions', () => {
  it('are named after the axes', () => {
    expect([0, 90, 180, 270, -90, 360, 37.5].map(directionName)).toEqual(['+X', '+Y', '−X', '−Y', '−Y', '+X', '37.5°']);
  });

  it('know their turning point and their way', () => {
    const whole = cycle([0, 1, 2, 1, 0], 2, []);
    expect(whole.turning).toBe(2);
    expect([0, 1, 2, 3, 4].map((i) => whole.path(i))).toEqual([0, 1, 2, 3, 4]);
    expect(whole.branches()).toEqual([
      { loading: true, indices: [0, 1, 2] },
      { loading: false, indices: [2, 3, 4] },
    ]);
  });

  it('end where the run ended', () => {
    const broken = cycle([0, 1], 2, []);
    expect(broken.turning).toBe(1);
    expect(broken.size).toBe(2);
    expect(broken.value('work', 0)).toBeNaN();
    expect(broken.field('crest_u').at(0, 0)).toBeNaN();
  });
});

describe('contact states', () => {
  it('are joined while they last, and left out where open', () => {
    const states = [
      [0, 1],
      [2, 1],
      [2, 3],
      [0, 3],
      [2, 3],
    ];
    expect(stretchesOf(cycle([0, 1, 2, 1, 0], 2, states), 'top_bump')).toEqual([
      { node: 0, state: 'slip forward', first: 1, last: 2 },
      { node: 0, state: 'slip forward', first: 4, last: 4 },
      { node: 1, state: 'stick', first: 0, last: 1 },
      { node: 1, state: 'slip backward', first: 2, last: 4 },
    ]);
  });
});

describe('files', () => {
  it('quote what needs it and leave out what is not known', () => {
    expect(toCsv(['a', 'b'], [['x,"y"\n', null], [NaN, 0.1]])).toBe('a,b\r\n"x,""y""\n",\r\n,0.1\r\n');
  });

  it('have seven digits of a number of 32 bits', () => {
    expect(toCsv(['a'], [[Math.fround(7.95e-5)]])).toBe('a\r\n0.0000795\r\n');
  });
});

describe('labels', () => {
  it('keep apart, in their order', () => {
    const heights = [100, 102, 60];
    const placed = labelOffsets(heights).map((offset, i) => offset + (heights[i] ?? 0));
    expect(placed[1]! - placed[0]!).toBeCloseTo(15);
    expect(placed[0]! - placed[2]!).toBeGreaterThan(15);
    expect(labelOffsets([5])).toEqual([0]);
  });
});

it('finds the largest size among what is known', () => {
  expect(largest([1, -3, NaN], new Float32Array([2]))).toBe(3);
  expect(largest([])).toBe(0);
});

it('breaks lines of pictures between words', () => {
  expect(wrapped('one two three', 8, (text) => text.length)).toEqual(['one two', 'three']);
  expect(wrapped('immeasurable', 3, (text) => text.length)).toEqual(['immeasurable']);
});

it('finds the numbers of the case in which runs differ', () => {
  const run = (coefficient: number): Run =>
    new Run({
      name: String(coefficient),
      kind: 'cycle',
      attributes: {},
      summary: { case: { friction: { coefficient }, cycle: { steps: 4 }, title: String(coefficient) }, version: '', commit: '', solver: '', status: 'complete', cycles: [] },
      meanings: {},
      geometry: {},
      nodes: { bump: 1, foot: 1 },
      last_increment: 8,
      quantities: [],
      cycles: [],
    });
  const runs = [run(0.1), run(0.2), run(0.1)];
  const keys = sweptKeys(runs, { friction: { title: 'Friction' }, 'friction.coefficient': { title: 'Coefficient' } });
  expect(keys.map(({ title, unit }) => [title, unit])).toEqual([['Friction: Coefficient', '']]);
  expect(runs.map((one) => keys[0]?.values.get(one))).toEqual([0.1, 0.2, 0.1]);
});

describe('warnings', () => {
  const runOf = (cycle: object, status: string, increments: number[]): Run =>
    new Run({
      name: 'a',
      kind: 'cycle',
      attributes: {},
      summary: { case: {}, version: '', commit: '', solver: '', status, cycles: [{ at: 0, amplitude_m: 1, steps: 1, converged: true, ...cycle }] },
      meanings: {},
      geometry: {},
      nodes: { bump: 1, foot: 1 },
      last_increment: 2,
      quantities: [],
      cycles: [{ at: 0, increments, series: {}, fields: {} }],
    });
  const warned = (cycle: object, status = 'complete'): string[] => warningsOf(runOf(cycle, status, [0]));

  it('leave increments that are not shown to one note on all loops', () => {
    const runs = [1, 3, 7].map((stride) => runOf({}, 'complete', [0, stride, 2 * stride]));
    expect(runs.flatMap(warningsOf)).toEqual([]);
    expect(thinningOf(runs)).toBe('Of some loops one increment in 7 is shown; result.nc has them all.');
    expect(thinningOf(runs.slice(1))).toBe('Of all loops one increment in 3 to 7 is shown; result.nc has them all.');
    expect(thinningOf(runs.slice(2))).toBe('Of all loops one increment in 7 is shown; result.nc has them all.');
    expect(thinningOf(runs.slice(0, 1))).toBe('');
  });

  it('are those that the result has', () => {
    expect(warned({ warnings: ['never touches: push further'] })).toEqual(['+X: never touches: push further.']);
  });

  it('say where and why a cycle ended', () => {
    expect(warned({ converged: false, status: 'no_modes', failed_increment: 1, failed_displacement_m: 2e-6, reason: 'no modes were found' }, 'failed')).toEqual([
      'The run failed; its results are partial.',
      '+X: failed at increment 1 of 2, 2.00 µm: no modes were found.',
    ]);
  });
});

it('counts the tables of a list, and keeps what goes along the foil in one piece', () => {
  const entries = flatten({
    bump_foil: {
      pitch: { start: 4e-3, end: 5e-3, law: 'linear' },
      height_errors: [],
      shim: [
        { from: 1, to: 3 },
        { from: 5, to: 5 },
      ],
    },
  });
  expect([...entries.keys()]).toEqual([
    'bump_foil.pitch',
    'bump_foil.height_errors',
    'bump_foil.shim[1].from',
    'bump_foil.shim[1].to',
    'bump_foil.shim[2].from',
    'bump_foil.shim[2].to',
  ]);
  expect(valueText(entries.get('bump_foil.pitch'), 'm')).toBe('4 mm to 5 mm, linear');
  // Many numbers in equal steps are told by their ends; small angles are slopes.
  expect(valueText([0, 1, 2, 3, 4].map((i) => 1e-3 * (1 + i)), 'm')).toBe('1 mm to 5 mm in 4 equal steps');
  expect(valueText([1e-3, 2e-3, 3e-3, 4e-3, 6e-3], 'm')).toBe('1 mm, 2 mm, 3 mm, 4 mm, 6 mm');
  expect(valueText([-1.31e-4, 0], 'rad')).toBe('−0.131 mrad, 0°');
  const keys = { bump_foil: { title: 'Bump foil' }, 'bump_foil.shim[1]': { title: 'Shim' }, 'bump_foil.shim[1].from': { title: 'From bump' } };
  expect(labelOf(keys, 'bump_foil.shim[2].from')?.title).toBe('From bump');
  expect(['bump_foil', 'bump_foil.shim[2]', 'bump_foil.pad[1]'].map((table) => titleOf(keys, table))).toEqual(['Bump foil', 'Shim 2', undefined]);
});

it('knows the units of keys that take lengths or forces', () => {
  const keys = { 'bearing.radius': { title: 'Radius', unit: 'm' } };
  const text = (input: Parameters<typeof flatten>[0], key: string): string => {
    const entries = flatten(input);
    return valueText(entries.get(key), unitOf(keys, key, entries));
  };
  const [places, loads] = [{ path: { centre: [0, -4e-5], semi_axes: [1e-5, 5e-6] } }, { path: { centre: ['0 N', '-40 N'], semi_axes: [10, 5] } }];
  expect([text(places, 'path.centre'), text(places, 'path.semi_axes')]).toEqual(['0 m, −40 µm', '10 µm, 5 µm']);
  expect([text(loads, 'path.centre'), text(loads, 'path.semi_axes')]).toEqual(['0 N, −40 N', '10 N, 5 N']);
  expect(text({ cycle: { amplitude: 8e-5, preload: [0, -5e-5] } }, 'cycle.preload')).toBe('0 m, −50 µm');
  expect(text({ cycle: { amplitude: 8e-5, preload: ['0 N', '-50 N'] } }, 'cycle.preload')).toBe('0 N, −50 N');
  expect(text({ strip: { load: 100, preload: 50 } }, 'strip.preload')).toBe('50 N');
  expect(text({ bearing: { radius: 0.02 } }, 'bearing.radius')).toBe('20 mm');
});
