import { describe, expect, it } from 'vitest';
import { BearingGeometry } from '../src/bearing/geometry';
import { foilPieces, shapeAt, undeformedGap } from '../src/bearing/shape';
import { tickText } from '../src/data/counted';
import type { CycleData, RunData } from '../src/data/format';
import { Run } from '../src/data/run';

function base64(numbers: number[]): string {
  return btoa(String.fromCharCode(...new Uint8Array(new Float32Array(numbers).buffer)));
}

/** Two bumps of pitch 4 mm on a radius of 10 mm, clearance 30 um; the journal is 50 um below the centre. */
function run(feet: number, geometry: RunData['geometry'] = {}): Run {
  const field = (at: 'bump' | 'foot', numbers: number[]): CycleData['fields'][string] => ({ at, values: base64(numbers) });
  const footPlaces = feet === 2 ? [4e-3, 8e-3] : [0.5e-3, 3.5e-3, 4.5e-3, 7.5e-3];
  const data: RunData = {
    name: '/results',
    kind: 'cycle',
    attributes: {},
    summary: {
      case: { bearing: { weld_angle: Math.PI, wrap: 'clockwise' }, cycle: { amplitude: 50e-6, steps: 1 } },
      version: '',
      commit: '',
      solver: 'newton',
      status: 'complete',
      cycles: [],
    },
    meanings: {},
    geometry: {
      bearing_radius: 10e-3,
      bump_pitch: 4e-3,
      bump_half_length: 1.5e-3,
      bump_rise: 0.4e-3,
      radial_clearance: 30e-6,
      theta: [0.2, 0.6],
      foot_theta: footPlaces.map((place) => place / 10e-3),
      height_error: [0, 7e-6],
      sleeve_gap: [0, 0],
      ...geometry,
    },
    nodes: { bump: 2, foot: feet },
    last_increment: 2,
    quantities: [],
    cycles: [
      {
        at: 270,
        increments: [0],
        series: { displacement: base64([50e-6]), x: base64([0]), y: base64([-50e-6]) },
        fields: {
          crest_u: field('bump', [1e-6, 2e-6]),
          crest_v: field('bump', [20e-6, 0]),
          foot_u: field('foot', footPlaces.map((_, i) => i * 1e-6)),
          foot_v: field('foot', footPlaces.map(() => 0)),
          top_displacement: field('bump', [20e-6, 5e-6]),
          state_journal_top: field('bump', [0, 0]),
        },
      },
    ],
  };
  return new Run(data);
}

function shapeOf(feet: number): ReturnType<typeof shapeAt> {
  const one = run(feet);
  return shapeAt(new BearingGeometry(one), one.cycles[0]!, 0);
}

describe('shape', () => {
  it('moves crests and top foil inwards where they are displaced outwards by less', () => {
    const { crests, topNodes } = shapeOf(2);
    expect(crests[0]!.moveIn).toBeCloseTo(-20e-6, 10);
    // A taller bump stands out by its error.
    expect(crests[1]!.moveIn).toBeCloseTo(7e-6, 10);
    expect(topNodes[1]!.moveIn).toBeCloseTo(-5e-6, 10);
    expect(crests[1]!.along).toBeCloseTo(6e-3, 10);
  });

  it('passes through feet and crests of a truss, from the weld to half a flat after the last bump', () => {
    const { bumpFoil } = shapeOf(2).pads[0]!;
    expect(bumpFoil[0]).toMatchObject({ along: 0, height: 0, moveAlong: 0, moveIn: 0 });
    const crest = bumpFoil.find((point) => Math.abs(point.along - 2e-3) < 1e-9)!;
    expect(crest.height).toBeCloseTo(0.4e-3, 10);
    expect(crest.moveIn).toBeCloseTo(-20e-6, 10);
    expect(bumpFoil[bumpFoil.length - 1]!.along).toBeCloseTo(8e-3, 8);
  });

  it('ends with the arc of the last bump in a frame', () => {
    const { bumpFoil } = shapeOf(4).pads[0]!;
    expect(bumpFoil[bumpFoil.length - 1]!.along).toBeCloseTo(7.5e-3, 8);
    expect(bumpFoil[bumpFoil.length - 1]!.moveAlong).toBeCloseTo(3e-6, 10);
  });

  it('has the bumps where their pitches and heights put them', () => {
    const one = run(2, { theta: [0.15, 0.55], bump_pitch: [3e-3, 5e-3], bump_half_length: [1e-3, 2e-3], bump_rise: [0.4e-3, 0.38e-3], crest_offset: [0, -20e-6] });
    const geometry = new BearingGeometry(one);
    expect(geometry.pads[0]!.borders).toEqual([0, 3e-3, 8e-3]);
    expect([0, 2.9e-3, 3.1e-3, 8e-3].map((along) => geometry.bumpAt(along))).toEqual([0, 0, 1, 1]);
    const { pads, crests } = shapeAt(geometry, one.cycles[0]!, 0);
    const { bumpFoil } = pads[0]!;
    expect(bumpFoil[1]!.along).toBeCloseTo(0.5e-3, 10);
    expect(bumpFoil[bumpFoil.length - 2]!.along).toBeCloseTo(7.5e-3, 10);
    // Lower than the first by its design, whatever its height error.
    expect(crests[1]!.moveIn).toBeCloseTo(-20e-6, 10);
    expect(crests[1]!.height).toBeCloseTo(0.4e-3, 10);
  });

  it('is in pieces where the sheet changes its thickness, from the middle of a flat on', () => {
    const pieces = (thicknesses: number | number[]): ReturnType<typeof foilPieces> => {
      const geometry = new BearingGeometry(run(2, { bump_thickness: thicknesses }));
      return foilPieces(geometry, shapeAt(geometry, geometry.run.cycles[0]!, 0));
    };
    const [whole, ...others] = pieces(0.1e-3);
    expect([whole!.weight, others.length]).toEqual([1, 0]);
    expect(whole!.points).toEqual(shapeOf(2).pads[0]!.bumpFoil);
    const [thin, thick, ...more] = pieces([0.09e-3, 0.11e-3]);
    expect(more.length).toBe(0);
    expect([thin!.weight, thick!.weight].map((weight) => Number(weight.toFixed(6)))).toEqual([0.729, 1.331]);
    // They meet between the bumps, at 4 mm, where the first foot is.
    const meeting = [thin!.points[thin!.points.length - 1]!, thick!.points[0]!];
    for (const point of meeting) expect(point).toMatchObject({ along: 4e-3, height: 0 });
    expect(thin!.points.length + thick!.points.length).toBe(whole!.points.length + 2);
    expect(pieces([0.02e-3, 0.18e-3]).map(({ weight }) => weight)).toEqual([0.4, 2.6]);
  });

  it('has the gap of the journal that the conventions say', () => {
    const one = run(2);
    const geometry = new BearingGeometry(one);
    // With the defaults C_r + x cos(theta) - y sin(theta).
    expect(undeformedGap(geometry, geometry.pads[0]!, 2e-3, one.cycles[0]!, 0)).toBeCloseTo(30e-6 + 50e-6 * Math.sin(0.2), 10);
    expect(shapeOf(2).pads[0]!.journal[0]!.moveIn).toBeCloseTo(30e-6, 10);
  });

  /** Of one bump each: the second is welded at its far edge, runs against the first, and has a lobe. */
  it('has each pad from its own weld, with its lobe', () => {
    const one = run(2, {
      theta: [0.2, 0.2],
      foot_theta: [0.4, 0.4],
      bump_pad: [1, 2],
      foot_pad: [1, 2],
      pad_weld_angle: [Math.PI, -0.4],
      pad_lobe: [0, 10e-6],
    });
    const data = { ...one.data, nodes: { ...one.data.nodes, pad: 2 } };
    data.summary.case['pad'] = [{ weld_edge: 'leading' }, { weld_edge: 'trailing' }];
    const geometry = new BearingGeometry(new Run(data));
    const [first, second] = [geometry.pads[0]!, geometry.pads[1]!];
    expect([first.length, second.length]).toEqual([4e-3, 4e-3]);
    expect(geometry.polarAngle(first, 2e-3)).toBeCloseTo(Math.PI - 0.2, 10);
    expect(geometry.polarAngle(second, 2e-3)).toBeCloseTo(-0.2, 10);
    // Laid flat, they do not touch.
    expect(second.begin).toBeGreaterThan(4e-3);
    expect([0, 3.9e-3, second.begin, second.begin + 9e-3].map((flat) => geometry.bumpAt(flat))).toEqual([0, 0, 1, 1]);
    expect(geometry.feetOf(1)).toEqual([undefined, 1]);
    const shape = shapeAt(geometry, one.cycles[0]!, 0);
    expect(shape.pads[1]!.bumpFoil[0]).toMatchObject({ pad: second, along: 0, moveIn: 0 });
    expect(shape.crests.map(({ pad }) => pad.name)).toEqual(['pad 1', 'pad 2']);
    // Nearer by the lobe in its middle, and by less at its ends.
    const gap = (along: number): number => undeformedGap(geometry, second, along, one.cycles[0]!, 0);
    expect(gap(2e-3)).toBeCloseTo(30e-6 - 10e-6 + 50e-6 * Math.sin(-0.2), 12);
    expect(gap(0)).toBeCloseTo(30e-6 - 10e-6 * Math.cos(0.2) + 50e-6 * Math.sin(-0.4), 12);
    expect(new Run(data).numberOf('bump', 1)).toBe('1 of pad 2');
    expect(tickText(new Run(data).counted('foot', 1))).toBe('2.1');
    expect(run(2).numberOf('bump', 1)).toBe('2');
  });
});
