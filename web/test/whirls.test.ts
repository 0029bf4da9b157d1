import { describe, expect, it } from 'vitest';
import type { GridData, OnsetData, StabilitySummary } from '../src/data/format';
import { inRevolutions, onsetText, Whirls } from '../src/data/whirls';

function base64(numbers: number[]): string {
  return btoa(String.fromCharCode(...new Uint8Array(new Float32Array(numbers).buffer)));
}

const variable = (dims: string[], values: number[], words = ''): GridData['variables'][string] => ({ key: '', dims, unit: '', text: '', words, values: base64(values) });
const motions = (values: number[], words = ''): GridData['variables'][string] => variable(['speed', 'contacts', 'mode'], values, words);

const onset: OnsetData = { speed_rad_per_s: (-12345.6 * Math.PI) / 30, whirl_ratio: 0.49, contacts: 'sliding', by_coefficients: false, begins: true, of_foils: false, jumps: false };
const summary: StabilitySummary = { case: {}, version: '', commit: '', solver: 'newton', status: 'failed', onsets: [onset, { ...onset, contacts: 'stuck', begins: false, of_foils: true, jumps: true }] };

/** Three speeds backwards, of which the second was not found; motions: one that whirls, one that only decays, one that diverges when stuck. */
const whirls = new Whirls({
  name: 'rotor',
  kind: 'stability',
  attributes: {},
  summary,
  quantities: [],
  dimensions: { speed: 3, contacts: 2, mode: 3, station: 1, bearing: 1 },
  variables: {
    speed: variable(['speed'], [-300, -200, -100]),
    speed_status: variable(['speed'], [0, 2, 0], 'converged no_modes fold'),
    real: motions([5, -9, NaN, 4, NaN, NaN, ...Array<number>(6).fill(NaN), -2, -8, NaN, -3, NaN, 1]),
    imag: motions([150, 0, NaN, 149, NaN, NaN, ...Array<number>(6).fill(NaN), 60, 0, NaN, 61, NaN, 0]),
    of_foils: motions([0, 1, NaN, 0, NaN, NaN, ...Array<number>(6).fill(NaN), 0, 1, NaN, 0, NaN, 1], 'no yes'),
  },
  left_out: [],
});

describe('motions of a rotor', () => {
  it('are those that oscillate or grow, the slowest speed first', () => {
    expect(whirls.motion.texts).toEqual(['mode 1', 'mode 3']);
    expect(whirls.modes(0)).toEqual([{ motion: 0, number: 1, text: 'mode 1', places: [{ speed: 2, contacts: 0, motion: 0 }, { speed: 0, contacts: 0, motion: 0 }] }]);
    expect(whirls.modes(1).map(({ text }) => text)).toEqual(['mode 1', 'mode 3, foils']);
  });

  it('have growth by the size of the speed, whichever way it turns', () => {
    expect(whirls.turnsBack).toBe(true);
    expect(whirls.growthAt({ speed: 0, contacts: 0, motion: 0 })).toBeCloseTo(5 / 300, 12);
    expect(whirls.revolutionsAt({ speed: 2 })).toBeCloseTo(3000 / Math.PI, 9);
    expect(whirls.frequencyAt({ speed: 0, contacts: 1, motion: 0 })).toBeCloseTo(149 / (2 * Math.PI), 12);
    expect(whirls.speed.texts[2]).toBe('−954.93 rpm');
  });

  it('are led by the one that grows fastest', () => {
    expect(whirls.fastest({ speed: 2, contacts: 1 })).toBe(1);
    expect(whirls.fastest({ speed: 2, contacts: 0 })).toBe(0);
    expect(whirls.fastest({ speed: 1, contacts: 0 })).toBe(0);
    expect(whirls.first).toEqual({ speed: 0, contacts: 0, motion: 0 });
  });

  it('are damped least, of the rotor and of the foils by themselves', () => {
    expect(whirls.leastDamped({ speed: 2, contacts: 1 }, false)).toEqual({ speed: 2, contacts: 1, motion: 0 });
    expect(whirls.leastDamped({ speed: 2, contacts: 1 }, true)).toEqual({ speed: 2, contacts: 1, motion: 1 });
    expect(whirls.leastDamped({ speed: 0, contacts: 0 }, true)).toBeUndefined();
    expect(whirls.leastDamped({ speed: 1, contacts: 0 }, false)).toBeUndefined();
    expect(whirls.leastDamped({ speed: -1, contacts: 0 }, false)).toBeUndefined();
  });

  it('are those of the run that takes the place of another', () => {
    const { data } = whirls;
    const other = new Whirls(data);
    other.replace({ ...data, dimensions: { ...data.dimensions, speed: 1 }, variables: { ...data.variables, speed: variable(['speed'], [50]) } });
    expect(other.speeds).toEqual([50]);
    expect(other.places(0)).toEqual([{ speed: 0, contacts: 0 }]);
    expect(other.motion.texts).toEqual(['mode 1']);
  });

  it('are missing where no equilibrium was found', () => {
    expect(whirls.numberAt('real', { speed: 1, contacts: 0, motion: 0 })).toBeNaN();
    expect(whirls.shortfallAt({ speed: 1 })).toBe('no equilibrium found: fold');
    expect(whirls.shortfallAt({ speed: 0 })).toBe('');
  });

  it('begin and end to grow in the words of the terminal', () => {
    expect(whirls.onsets(0).map(onsetText)).toEqual(['whirl begins at −12345.6 rpm, whirl ratio 0.4900']);
    expect(whirls.onsets(1).map(onsetText)).toEqual(['whirl of the foils ends at −12345.6 rpm, whirl ratio 0.4900 (contacts change there)']);
  });
});

describe('speeds', () => {
  const quantity = { key: '', label: '', whole: false, of_solver: false, first: true, meaning: '' };
  it('are told in revolutions, frequencies are not', () => {
    expect(inRevolutions({ ...quantity, name: 'onset_speed', unit: 'rad/s' }).unit).toBe('rpm');
    expect(inRevolutions({ ...quantity, name: 'imag', unit: 'rad/s' }).unit).toBe('rad/s');
    expect(inRevolutions({ ...quantity, name: 'growth', unit: '' }).unit).toBe('');
  });
});
