/** Surfaces of a running bearing in three dimensions, its film exaggerated. Nothing is drawn here. */
import { numbersOf } from '../data/grid';
import { at, type Cycle } from '../data/run';
import type { States } from '../data/states';
import type { Place } from '../data/grid';
import type { BearingGeometry } from './geometry';
import { magnifications, shapeAt } from './shape';

/** X and Y across the axis, Z along it; m as drawn. */
export type Point3 = [number, number, number];

/** What the top foil is coloured by. */
export const coloured = ['pressure', 'film_thickness'] as const;
export type Coloured = (typeof coloured)[number];

export interface Facet {
  corners: Point3[];
  /** Away from the axis, across it. */
  outward: [number, number];
  of: 'top foil' | 'bump foil' | 'film';
  /** At a facet of the top foil, SI; NaN of the others. */
  values: Record<Coloured, number>;
}

export interface Solid {
  facets: Facet[];
  /** Outlines of the journal and of the sleeve. */
  lines: { points: Point3[]; of: 'journal' | 'sleeve' }[];
  /** Where the foils are welded, and the loads on the journal begin and end. */
  welds: Point3[];
  /** By which film and displacements, and heights of bumps, are drawn larger than the radius. */
  film: number;
  bumps: number;
  radius: number;
  halfLength: number;
}

/** Of the radius: how far the journal is drawn from the top foil at most, and how high bumps are drawn. */
const [filmPart, bumpPart] = [0.2, 0.09];
const [mostColumns, mostRows] = [180, 16];
const none: Facet['values'] = { pressure: NaN, film_thickness: NaN };

function niceFactor(most: number): number {
  return magnifications.filter((factor) => factor <= most).pop() ?? 1;
}

/** Every so many, the first and the last among them. */
function thinned(count: number, most: number): number[] {
  const step = Math.max(1, Math.ceil((count - 1) / most));
  const kept = Array.from({ length: Math.floor((count - 1) / step) + 1 }, (_, i) => i * step);
  return kept[kept.length - 1] === count - 1 ? kept : [...kept, count - 1];
}

/** What the film has at a node; on half the width it is symmetric about the mid-plane. */
class Nodes {
  readonly rows: { row: number; z: number }[];
  readonly phi: number[];
  private readonly theta: number[];
  private readonly half: number;
  private readonly middles: number[];

  constructor(
    private readonly states: States,
    private readonly state: number,
    private readonly geometry: BearingGeometry | undefined,
  ) {
    const z = numbersOf(states, 'z');
    const rows = thinned(z.length, mostRows).map((row) => ({ row, z: at(z, row) }));
    const mirrored = z.every((one) => one >= 0) ? rows.filter((one) => one.z > 0).map(({ row, z: one }) => ({ row, z: -one })) : [];
    this.rows = [...mirrored, ...rows].sort((a, b) => a.z - b.z);
    this.phi = numbersOf(states, 'column_phi');
    this.theta = numbersOf(states, 'column_theta');
    this.half = Math.max(...z.map(Math.abs));
    this.middles = numbersOf(states, 'pad_z');
  }

  /** Half the width of the bearing. */
  get halfLength(): number {
    return this.half + Math.max(0, ...this.middles);
  }

  /** Half the width of the foils of a pad. */
  get halfFoil(): number {
    return this.half;
  }

  /** Where their middle is: pads of a split top foil are its strips. */
  middle(pad: number): number {
    return this.middles[pad] ?? 0;
  }

  at(name: string, row: number, column: number): number {
    return this.states.variable(name)?.at({ state: this.state, row, column }) ?? NaN;
  }

  /** Of the top foil, outwards, with the slope and the parabola over the width; pads lie inwards by their lobes. */
  foil(z: number, column: number, pad: number): number {
    const part = (name: string): number => this.states.variable(name)?.at({ state: this.state, column }) ?? 0;
    const along = z / this.half;
    const own = this.geometry?.pads[pad];
    const lobe = own && this.geometry ? this.geometry.lobeAt(own, at(this.theta, column) * this.geometry.radius) : 0;
    return part('film_top_displacement') + along * part('film_top_slope') + 0.5 * (3 * along ** 2 - 1) * part('film_top_parabola') - lobe;
  }
}

/** The bearing at a state; nothing where there is none. */
export function solidAt(states: States, place: Place, bearing: { geometry: BearingGeometry; cycle: Cycle } | undefined): Solid | undefined {
  const state = states.stateAt(place);
  if (state < 0 || !states.isFound(place) || !states.variable('pressure')) return undefined;
  const geometry = bearing?.geometry;
  const radius = states.variable('bearing_radius')?.at({}) ?? geometry?.radius ?? NaN;
  const nodes = new Nodes(states, state, geometry);
  const pads = states.padColumns.map(({ first, angles }) => thinned(angles.length, Math.ceil(mostColumns / states.pads)).map((column) => first + column));
  const all = pads.flatMap((columns, pad) => columns.flatMap((column) => nodes.rows.map(({ row, z }) => ({ gap: nodes.at('film_thickness', row, column), foil: nodes.foil(z, column, pad) }))));
  const deepest = Math.max(...all.map(({ gap, foil }) => Math.max(gap - foil, Math.abs(foil))).filter(Number.isFinite));
  const film = niceFactor((filmPart * radius) / deepest);
  const bumps = geometry ? niceFactor((bumpPart * radius) / geometry.rise) : 1;
  const onFoil = (row: { z: number }, column: number, pad: number): Point3 => around(at(nodes.phi, column), radius + film * nodes.foil(row.z, column, pad), nodes.middle(pad) + row.z);
  const onJournal = (row: { row: number; z: number }, column: number, pad: number): Point3 =>
    around(at(nodes.phi, column), radius + film * (nodes.foil(row.z, column, pad) - nodes.at('film_thickness', row.row, column)), nodes.middle(pad) + row.z);
  const facets: Facet[] = [];
  const lines: Solid['lines'] = [];
  const [head, tail] = [at(nodes.rows, nodes.rows.length - 1), at(nodes.rows, 0)];
  pads.forEach((columns, pad) => {
    columns.slice(1).forEach((column, i) => {
      const before = at(columns, i);
      const phi = 0.5 * (at(nodes.phi, before) + at(nodes.phi, column));
      const outward: [number, number] = [Math.cos(phi), Math.sin(phi)];
      nodes.rows.slice(1).forEach((row, j) => {
        const lower = at(nodes.rows, j);
        const corners = [onFoil(lower, before, pad), onFoil(lower, column, pad), onFoil(row, column, pad), onFoil(row, before, pad)];
        const mean = (name: Coloured): number => 0.25 * [lower.row, row.row].reduce((sum, one) => sum + nodes.at(name, one, before) + nodes.at(name, one, column), 0);
        facets.push({ corners, outward, of: 'top foil', values: { pressure: mean('pressure'), film_thickness: mean('film_thickness') } });
      });
      for (const end of [head, tail]) facets.push({ corners: [onFoil(end, before, pad), onFoil(end, column, pad), onJournal(end, column, pad), onJournal(end, before, pad)], outward, of: 'film', values: none });
    });
    for (const end of [head, tail]) lines.push({ points: columns.map((column) => onJournal(end, column, pad)), of: 'journal' });
    columns.filter((_, i) => i % Math.ceil(columns.length / (24 / states.pads)) === 0).forEach((column) => lines.push({ points: nodes.rows.map((row) => onJournal(row, column, pad)), of: 'journal' }));
  });
  if (bearing && geometry) {
    const shape = shapeAt(geometry, bearing.cycle, state);
    for (const [number, { bumpFoil }] of shape.pads.entries()) {
      const [lower, upper] = [nodes.middle(number) - nodes.halfFoil, nodes.middle(number) + nodes.halfFoil];
      const point = ({ pad, along, height, moveAlong, moveIn }: (typeof bumpFoil)[number], z: number): Point3 =>
        around(geometry.polarAngle(pad, along + moveAlong), radius + bumps * (geometry.rise - height) - film * (moveIn + geometry.lobeAt(pad, along)), z);
      bumpFoil.slice(1).forEach((end, i) => {
        const begin = at(bumpFoil, i);
        const phi = geometry.polarAngle(end.pad, 0.5 * (begin.along + end.along));
        facets.push({ corners: [point(begin, lower), point(end, lower), point(end, upper), point(begin, upper)], outward: [Math.cos(phi), Math.sin(phi)], of: 'bump foil', values: none });
      });
    }
    for (const z of [-nodes.halfLength, nodes.halfLength]) {
      lines.push({ points: Array.from({ length: 121 }, (_, i) => around((i * Math.PI) / 60, radius + bumps * geometry.rise, z)), of: 'sleeve' });
    }
  }
  const welds = states.padColumns.map(({ first }) => around(at(nodes.phi, first), radius + bumps * (geometry?.rise ?? 0), nodes.halfLength));
  return { facets, lines, welds, film, bumps, radius, halfLength: nodes.halfLength };
}

function around(phi: number, radius: number, z: number): Point3 {
  return [radius * Math.cos(phi), radius * Math.sin(phi), z];
}
