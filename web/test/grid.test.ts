import { describe, expect, it } from 'vitest';
import { axisScale, Grid, placesOf, type Coordinate } from '../src/data/grid';
import type { GridData } from '../src/data/format';
import { gridWarnings } from '../src/data/outcome';
import { GridSelection, named } from '../src/ui/grid_selection';

function base64(numbers: number[]): string {
  return btoa(String.fromCharCode(...new Uint8Array(new Float32Array(numbers).buffer)));
}

const variable = (dims: string[], values: number[], words = ''): GridData['variables'][string] => ({ key: 'force_N', dims, unit: 'N', text: 'a force', words, values: base64(values) });

/** Two amplitudes, three directions, loops of up to four increments. */
const grid = new Grid({
  name: 'sweep',
  kind: 'sweep',
  attributes: { status_message: 'a point failed', warnings: 'one\ntwo' },
  summary: { case: {}, version: '', commit: '', solver: 'newton', status: 'failed' },
  quantities: [],
  dimensions: { amplitude: 2, direction: 3, increment: 4 },
  variables: {
    force: variable(['amplitude', 'direction'], [1, 2, 3, 4, 5, NaN]),
    status: variable(['amplitude', 'direction'], [0, 0, 0, 0, 0, 1], 'converged no_modes'),
    loop: variable(['amplitude', 'direction', 'increment'], [...Array(20).keys(), 7, 8, NaN, NaN]),
  },
  left_out: ['big'],
});

const amplitude: Coordinate = { name: 'amplitude', title: 'Cycle: Amplitude', texts: ['60 µm', '70 µm'], numbers: [60e-6, 70e-6], unit: 'm' };
const friction: Coordinate = { name: 'friction', title: 'Friction', texts: ['0', '0.1', '0.2'], numbers: [0, 0.1, 0.2], unit: '' };
const direction: Coordinate = { name: 'direction', title: 'Direction', texts: ['+X', '−X', '+Y'], unit: '' };

describe('numbers over dimensions', () => {
  it('are found by the names of these', () => {
    const force = grid.variable('force');
    expect(force?.at({ direction: 1, amplitude: 1 })).toBe(5);
    expect(force?.at({ direction: 2, amplitude: 0, friction: 2 })).toBe(3);
    expect(force?.at({ direction: 2, amplitude: 1 })).toBeNaN();
    expect(grid.variable('status')?.words[1]).toBe('no_modes');
    expect(grid.variable('other')).toBeUndefined();
  });

  it('end where they are absent', () => {
    const loop = grid.variable('loop');
    expect(loop?.along({ amplitude: 1, direction: 0 })).toEqual([12, 13, 14, 15]);
    expect(loop?.along({ amplitude: 1, direction: 2 })).toEqual([7, 8]);
  });

  it('are told with what is missing of them', () => {
    expect(gridWarnings(grid)).toEqual([
      'The run failed; its results are partial.',
      'a point failed.',
      'one.',
      'two.',
      'Too large for a report, and left out: big.',
    ]);
  });
});

describe('places', () => {
  it('run through the last coordinate fastest', () => {
    expect(placesOf([amplitude, direction]).map((place) => `${place['amplitude'] ?? ''}${place['direction'] ?? ''}`)).toEqual(['00', '01', '02', '10', '11', '12']);
  });

  it('have axes in units of people', () => {
    expect(axisScale(amplitude).unit).toBe('µm');
    expect(axisScale({ ...amplitude, unit: 'rad' })).toEqual({ factor: 180 / Math.PI, unit: '°' });
    expect(named(amplitude, 1)).toBe('Amplitude 70 µm');
    expect(named(direction, 1)).toBe('−X');
  });
});

describe('what is looked at', () => {
  it('begins with keys in which there is a choice', () => {
    const alone = { ...friction, texts: ['0.1'], numbers: [0.1] };
    const selection = new GridSelection([alone, amplitude, direction], [alone, amplitude]);
    expect(selection.along).toBe(amplitude);
    expect(selection.by).toBe(direction);
    expect(selection.place).toEqual({ friction: 0, amplitude: 1, direction: 0 });
    expect(selection.textAt(selection.place, amplitude)).toBe('+X');
  });

  it('never draws lines along their own axis', () => {
    const selection = new GridSelection([amplitude, friction, direction], [amplitude, friction]);
    expect(selection.by).toBe(friction);
    expect(selection.place).toEqual({ amplitude: 1, friction: 1, direction: 0 });
    let told = 0;
    selection.onChange(() => (told += 1));
    selection.show({ along: friction });
    expect(selection.by).toBe(amplitude);
    selection.show({ by: direction, place: { amplitude: 0 } });
    expect(selection.by).toBe(direction);
    expect(selection.place).toEqual({ amplitude: 0, friction: 1, direction: 0 });
    expect(told).toBe(2);
  });
});
