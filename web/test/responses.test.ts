import { describe, expect, it } from 'vitest';
import type { GridData, UnbalanceSummary } from '../src/data/format';
import { orbitPoint, periodic, Responses, stuck, unwrapped } from '../src/data/responses';

function base64(numbers: number[]): string {
  return btoa(String.fromCharCode(...new Uint8Array(new Float32Array(numbers).buffer)));
}

const variable = (dims: string[], values: number[], words = ''): GridData['variables'][string] => ({ key: '', dims, unit: '', text: '', words, values: base64(values) });
const responses = (values: number[]): GridData['variables'][string] => variable(['speed', 'kind', 'station'], values);

const peak = { kind: 'linear_stuck', station: 'disk 1', speed_rad_per_s: -190, semi_major_m: 2e-6 };
const summary: UnbalanceSummary = { case: { bearing: { radial_clearance: 3e-5 } }, version: '', commit: '', solver: 'newton', status: 'failed', stations: ['bearing 1', 'disk 1'], peaks: [{ ...peak, kind: 'orbit', speed_rad_per_s: -300 }, peak] };

/** Two speeds backwards, the faster without an equilibrium; three kinds, a bearing and a disk. */
const data: GridData = {
  name: 'rotor',
  kind: 'unbalance',
  attributes: {},
  summary,
  quantities: [],
  dimensions: { speed: 2, kind: 3, station: 2, bearing: 1 },
  variables: {
    speed: variable(['speed'], [-300, -200]),
    kind: variable(['kind'], [0, 1, 2], 'linear_sliding linear_stuck orbit'),
    speed_status: variable(['speed'], [1, 0], 'converged no_room'),
    orbit_lasts: variable(['speed'], [NaN, 0], 'no yes'),
    x: variable(['speed', 'bearing'], [NaN, 1e-5]),
    y: variable(['speed', 'bearing'], [NaN, -2e-5]),
    amplitude_x: responses([...Array<number>(6).fill(NaN), 0, 0, 1e-6, 2e-6, 4e-6, 5e-6]),
    phase_x: responses([...Array<number>(6).fill(NaN), 0, 0, 90, 0, 180, 0]),
    amplitude_y: responses([...Array<number>(6).fill(NaN), 0, 0, 3e-6, 0, 0, 0]),
    phase_y: responses([...Array<number>(6).fill(NaN), 0, 0, 0, 0, 0, 0]),
    mean_x: responses([...Array<number>(10).fill(NaN), 1.5e-5, 0]),
    mean_y: responses([...Array<number>(10).fill(NaN), -1e-5, 0]),
    amplitude_x_2x: responses([...Array<number>(10).fill(NaN), 1e-6, 0]),
    phase_x_2x: responses([...Array<number>(10).fill(NaN), -90, 0]),
    amplitude_y_2x: responses([...Array<number>(10).fill(NaN), 0, 0]),
    phase_y_2x: responses([...Array<number>(10).fill(NaN), 0, 0]),
    h_min: responses([...Array<number>(10).fill(NaN), 7e-6, NaN]),
  },
  left_out: [],
};
const rotor = new Responses(data);

describe('responses of a rotor', () => {
  it('go from the slowest speed on, and are looked at where small orbits with stuck contacts are largest', () => {
    expect(rotor.places).toEqual([{ speed: 1 }, { speed: 0 }]);
    expect(rotor.turnsBack).toBe(true);
    expect(rotor.first).toEqual({ speed: 1, station: 1 });
    expect(new Responses({ ...data, summary: { ...summary, peaks: [] } as UnbalanceSummary }).first).toEqual({ speed: 0 });
  });

  it('go round the equilibrium where they are small', () => {
    const orbit = rotor.orbitAt({ speed: 1, kind: stuck, station: 0 });
    const at = (turns: number): number[] => Object.values(orbit ? orbitPoint(orbit, turns) : {}).map((value) => 1e6 * value);
    for (const [i, number] of [10, -17].entries()) expect(at(0)[i]).toBeCloseTo(number, 4);
    // cos(90 deg + 90 deg) = -1
    for (const [i, number] of [9, -20].entries()) expect(at(0.25)[i]).toBeCloseTo(number, 4);
    // A disk has no equilibrium that is known: only its motion.
    const disk = rotor.orbitAt({ speed: 1, kind: stuck, station: 1 });
    expect(disk && orbitPoint(disk, 0).x).toBeCloseTo(2e-6, 10);
  });

  it('have a mean and a second harmonic where they are periodic', () => {
    const orbit = rotor.orbitAt({ speed: 1, kind: periodic, station: 0 });
    // 15 + 4 cos(180 deg) + cos(-90 deg), and an eighth of a turn on: 15 + 4 cos(225 deg) + cos(0)
    expect(orbit && 1e6 * orbitPoint(orbit, 0).x).toBeCloseTo(11, 4);
    expect(orbit && 1e6 * orbitPoint(orbit, 0.125).x).toBeCloseTo(16 - 4 * Math.SQRT1_2, 4);
  });

  it('are missing where no equilibrium was found', () => {
    expect(rotor.orbitAt({ speed: 0, kind: stuck, station: 0 })).toBeUndefined();
    expect(rotor.shortfallAt({ speed: 0 })).toBe('no equilibrium found: no room');
    expect(rotor.lastingAt({ speed: 0 })).toBe('');
    expect(rotor.lastingAt({ speed: 1 })).toBe('does not last');
    expect(rotor.ofBearings('h_min', { speed: 1 }, (values) => Math.min(...values))).toBeCloseTo(7e-6, 10);
  });

  it('have the clearance of the case, if all bearings have one', () => {
    expect(rotor.clearance).toBeCloseTo(3e-5, 12);
    expect(new Responses({ ...data, summary: { ...summary, case: {} } as UnbalanceSummary }).clearance).toBeNaN();
  });
});

describe('phases', () => {
  it('go on without jumps, from the one that they are compared with', () => {
    expect(unwrapped([-170, 175, NaN, 100, -150], 0)).toEqual([-170, -185, NaN, -260, -150]);
    expect(unwrapped([170, 160], -180)).toEqual([-190, -200]);
    expect(unwrapped([NaN, 10], NaN)).toEqual([NaN, 10]);
  });
});
