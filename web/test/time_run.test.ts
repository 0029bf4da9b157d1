import { describe, expect, it } from 'vitest';
import { bandsOf, isMonotonous } from '../src/data/bands';
import type { TransientData } from '../src/data/format';
import { TimeRun } from '../src/data/time_run';

function base64(numbers: number[]): string {
  return btoa(String.fromCharCode(...new Uint8Array(new Float32Array(numbers).buffer)));
}

const variable = (dims: string[], values: number[], words = ''): TransientData['variables'][string] => ({ key: '', dims, unit: '', text: '', words, values: base64(values) });

/** Turned back in 10 revolutions, of which every third is there, and the orbits of two and of one that was begun. */
const data: TransientData = {
  name: 'run',
  kind: 'transient',
  attributes: {},
  summary: { case: { bearing: { radial_clearance: 3e-5 } }, version: '', commit: '', solver: 'newton', status: 'failed', stations: ['bearing 1'], revolutions: 10, energy: {}, rubs: [], rub_count: 0 },
  quantities: [],
  dimensions: { revolution: 4, spectrum: 2, order: 3, step: 8, station: 1, bearing: 1 },
  variables: {
    status: variable([], [1], 'converged no_room'),
    revolution: variable(['revolution'], [1, 4, 7, 10]),
    revolution_time: variable(['revolution'], [0.01, 0.04, 0.07, 0.1]),
    revolution_speed: variable(['revolution'], [-600, -610, -620, -630]),
    order: variable(['order'], [0, 0.2, 0.4]),
    x: variable(['step', 'station'], [0, 1, 2, 3, 4, 5, 6, 7]),
    y: variable(['step', 'station'], [0, -1, -2, -3, -4, -5, -6, -7]),
  },
  left_out: [],
  stored: { revolution: 10, spectrum: 2, step: 101 },
  orbits: [
    { revolution: 4, first: 0, steps: 3 },
    { revolution: 5, first: 2, steps: 3 },
    { revolution: 11, first: 5, steps: 3 },
  ],
};
const run = new TimeRun(data);

describe('a run in time', () => {
  it('goes along revolutions, time, and the size of its speed', () => {
    expect(run.revolution.texts).toEqual(['1', '4', '7', '10']);
    expect(run.time.texts[1]).toBe('40.00 ms');
    expect(run.speed.title).toBe('Speed, from Y to X');
    expect(run.speed.numbers?.[0]).toBeCloseTo(5729.58, 2);
    expect(run.spectrumLength).toBe(5);
    expect(run.ending).toBe('no room');
  });

  it('has orbits by their steps: one that two share ends the first', () => {
    expect([0, 2, 3, 4, 5, 7].map((step) => run.orbitOfStep(step))).toEqual([0, 0, 1, 1, 2, 2]);
    expect(run.pointsOf(run.orbit(1), 0)).toEqual([{ x: 2, y: -2 }, { x: 3, y: -3 }, { x: 4, y: -4 }]);
    expect(run.meanOf(run.pointsOf(run.orbit(1), 0))).toEqual({ x: 3, y: -3 });
    expect([1, 5, 8, 9].map((revolution) => run.orbitNear(revolution))).toEqual([0, 1, 1, 2]);
    expect([1, 3, 5, 11].map((revolution) => run.indexOfRevolution(revolution))).toEqual([0, 1, 1, 3]);
  });

  it('says what is left out', () => {
    expect(run.thinning).toBe('Of this run the page has one in 3 of 10 revolutions, the orbits of 3 of 11 revolutions; result.nc has them all.');
    const whole = { ...data, stored: { revolution: 4, spectrum: 2, step: 8 }, orbits: [1, 2, 3].map((revolution, i) => ({ revolution, first: 2 * i, steps: 3 })) };
    expect(new TimeRun(whole).thinning).toBe('');
    expect(new TimeRun({ ...whole, stored: { ...whole.stored, step: 9 } }).thinning).toBe('Of this run the page has some of the steps of each orbit; result.nc has them all.');
  });
});

describe('bands of a map', () => {
  it('meet in the middle between their numbers', () => {
    expect(bandsOf([1, 2, 4])).toEqual([[0.5, 1.5], [1.5, 3], [3, 5]]);
    expect(bandsOf([7])).toEqual([[6.5, 7.5]]);
  });

  it('lie one above the other by speeds that rise or fall all the way', () => {
    expect(isMonotonous([100, 110, 130])).toBe(true);
    expect(isMonotonous([130, 110, 100])).toBe(true);
    expect(isMonotonous([100, 120, 110])).toBe(false);
    expect(isMonotonous([100, 100.1, 100.2])).toBe(false);
    expect(isMonotonous([100])).toBe(false);
  });
});
