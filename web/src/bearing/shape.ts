/** Shapes of the parts of a deformed bearing. Nothing is drawn here: the two views lay these points out. */
import { at, largest, type Cycle, type Run } from '../data/run';

/**
 * A point of a part: place along the foil from the weld and height over the sleeve (m, as designed), and what is to be
 * magnified: displacement away from the weld and inwards, gaps and errors of height (m).
 */
export interface ShapePoint {
  along: number;
  height: number;
  moveAlong: number;
  moveIn: number;
}

export interface Shape {
  bumpFoil: ShapePoint[];
  /** Empty where there is none, and so is `topNodes`. */
  topFoil: ShapePoint[];
  /** Of the journal, or of the plate. */
  mover: ShapePoint[];
  /** Of the sleeve, or of the base. */
  ground: ShapePoint[];
  /** One per bump. */
  crests: ShapePoint[];
  /** One per bump, of the top foil over it. */
  topNodes: ShapePoint[];
  feet: ShapePoint[];
}

/** What does not change while the journal moves. */
export class BearingGeometry {
  readonly radius: number;
  /** Where the pitch of each bump begins along the foil, and where the last one ends. */
  readonly borders: number[];
  readonly halfLengths: number[];
  /** Of the tallest bump: there the top foil lies, and all arcs are drawn as high. */
  readonly rise: number;
  readonly clearance: number;
  readonly weldAngle: number;
  /** +1 counterclockwise, -1 clockwise. */
  readonly sense: number;
  readonly crestPlaces: number[];
  readonly footPlaces: number[];
  readonly crestOffsets: number[];
  readonly sleeveGaps: number[];
  readonly twoFeet: boolean;
  readonly topFoil: boolean;
  /** A strip may be free at both ends. */
  readonly welded: boolean;
  private farthest: Reach | undefined;

  constructor(readonly run: Run) {
    const bearing = (run.data.summary.case['bearing'] ?? {}) as { weld_angle?: number; wrap?: string };
    this.radius = run.scalar('bearing_radius');
    const ofBumps = (name: string): number[] => {
      const each = run.perNode(name);
      return each.length > 0 ? each : Array.from({ length: run.bumps }, () => run.scalar(name));
    };
    this.borders = ofBumps('bump_pitch').reduce((places, pitch) => [...places, at(places, places.length - 1) + pitch], [0]);
    this.halfLengths = ofBumps('bump_half_length');
    this.rise = Math.max(...ofBumps('bump_rise'));
    this.clearance = run.scalar('radial_clearance');
    this.weldAngle = bearing.weld_angle ?? Math.PI;
    this.sense = bearing.wrap === 'counterclockwise' ? 1 : -1;
    const places = (flat: string, round: string): number[] =>
      run.kind.flat ? run.perNode(flat) : run.perNode(round).map((angle) => angle * this.radius);
    this.crestPlaces = places('crest_position', 'theta');
    this.footPlaces = places('foot_position', 'foot_theta');
    const offsets = run.perNode('crest_offset');
    this.crestOffsets = offsets.length > 0 ? offsets : run.perNode('height_error');
    this.sleeveGaps = run.perNode('sleeve_gap');
    this.twoFeet = run.feet === 2 * run.bumps;
    this.topFoil = run.interfaces.some(({ name }) => name === 'journal_top');
    this.welded = (run.data.summary.case['strip'] as { weld?: string } | undefined)?.weld !== 'none';
  }

  get length(): number {
    return at(this.borders, this.run.bumps);
  }

  /** How far the foils of the run move at most. */
  get reach(): Reach {
    this.farthest ??= reachOf(this);
    return this.farthest;
  }

  polarAngle(along: number): number {
    return this.weldAngle + (this.sense * along) / this.radius;
  }

  /** Height of the arc of a bump at a distance from its crest. */
  arc(bump: number, distance: number): number {
    const radius = (at(this.halfLengths, bump) ** 2 + this.rise ** 2) / (2 * this.rise);
    return Math.sqrt(radius ** 2 - distance ** 2) - (radius - this.rise);
  }

  /** The bump whose pitch a place along the foil lies in, or one beyond the ends. */
  bumpAt(along: number): number {
    return this.borders.filter((border) => border <= along).length - 1;
  }

  /** Feet at the start and the end of a bump's arc; none at the start of the first one of a truss that is welded there. */
  feetOf(bump: number): [number | undefined, number] {
    if (this.twoFeet) return [2 * bump, 2 * bump + 1];
    if (this.run.feet > this.run.bumps) return [bump, bump + 1];
    return [bump > 0 ? bump - 1 : undefined, bump];
  }
}

const halfArcPoints = 9;

interface Move {
  along: number;
  inwards: number;
}

function bumpFoil(geometry: BearingGeometry, cycle: Cycle, index: number): ShapePoint[] {
  const [crestU, crestV] = [cycle.field('crest_u'), cycle.field('crest_v')];
  const [footU, footV] = [cycle.field('foot_u'), cycle.field('foot_v')];
  const footMove = (foot: number | undefined): Move =>
    foot === undefined ? { along: 0, inwards: 0 } : { along: footU.at(index, foot), inwards: -footV.at(index, foot) };
  const atFoot = (foot: number): ShapePoint => {
    const move = footMove(foot);
    return { along: at(geometry.footPlaces, foot), height: 0, moveAlong: move.along, moveIn: move.inwards };
  };
  const points: ShapePoint[] = [];
  if (geometry.welded) points.push({ along: 0, height: 0, moveAlong: 0, moveIn: 0 });
  else if (!geometry.twoFeet) points.push(atFoot(0));
  geometry.crestPlaces.forEach((place, bump) => {
    const [start, end] = geometry.feetOf(bump);
    const crest: Move = {
      along: crestU.at(index, bump),
      inwards: (geometry.crestOffsets[bump] ?? 0) - crestV.at(index, bump),
    };
    for (let i = -halfArcPoints; i <= halfArcPoints; i += 1) {
      const foot = footMove(i < 0 ? start : end);
      const distance = (at(geometry.halfLengths, bump) * i) / halfArcPoints;
      // Between foot and crest nothing is known: the arc is drawn as one, flatter or higher.
      const weight = geometry.arc(bump, distance) / geometry.rise;
      points.push({
        along: place + distance,
        height: geometry.arc(bump, distance),
        moveAlong: foot.along + weight * (crest.along - foot.along),
        moveIn: foot.inwards + weight * (crest.inwards - foot.inwards),
      });
    }
  });
  // After the last bump of a truss there is half a flat; a frame ends with its arc.
  const last = geometry.footPlaces.length - 1;
  if (!geometry.twoFeet && last >= 0) points.push(atFoot(last));
  return points;
}

/** A smooth curve through what is known at the weld and over the crests. */
function topFoil(geometry: BearingGeometry, nodes: ShapePoint[]): ShapePoint[] {
  const first: ShapePoint = { along: 0, height: geometry.rise, moveAlong: 0, moveIn: geometry.welded ? 0 : at(nodes, 0).moveIn };
  const known = [first, ...nodes];
  const slope = (i: number): number => {
    // Clamped at the weld; free at the other end.
    if (i === 0) return 0;
    const before = at(known, i - 1);
    const after = known[i + 1] ?? at(known, i);
    return (after.moveIn - before.moveIn) / (after.along - before.along);
  };
  const points: ShapePoint[] = [first];
  const pieces = 6;
  for (let i = 1; i < known.length; i += 1) {
    const [a, b] = [at(known, i - 1), at(known, i)];
    const span = b.along - a.along;
    for (let piece = 1; piece <= pieces; piece += 1) {
      const t = piece / pieces;
      const bend =
        t * (1 - t) * ((1 - t) * (slope(i - 1) * span - (b.moveIn - a.moveIn)) - t * (slope(i) * span - (b.moveIn - a.moveIn)));
      points.push({
        along: a.along + t * span,
        height: geometry.rise,
        moveAlong: 0,
        moveIn: a.moveIn + t * (b.moveIn - a.moveIn) + bend,
      });
    }
  }
  const last = known.length - 1;
  const end = at(known, last);
  const rest = geometry.length - end.along;
  points.push({ along: geometry.length, height: geometry.rise, moveAlong: 0, moveIn: end.moveIn + slope(last) * rest });
  return points;
}

/** Gap between the undeformed top foil (or the crests) and the journal or the plate. */
export function undeformedGap(geometry: BearingGeometry, along: number, cycle: Cycle, index: number): number {
  if (geometry.run.kind.flat) return -cycle.value('displacement', index);
  const phi = geometry.polarAngle(along);
  return geometry.clearance - (cycle.value('x', index) * Math.cos(phi) + cycle.value('y', index) * Math.sin(phi));
}

function mover(geometry: BearingGeometry, cycle: Cycle, index: number): ShapePoint[] {
  const pieces = 120;
  return Array.from({ length: pieces + 1 }, (_, i) => {
    const along = (geometry.length * i) / pieces;
    return { along, height: geometry.rise, moveAlong: 0, moveIn: undeformedGap(geometry, along, cycle, index) };
  });
}

function ground(geometry: BearingGeometry): ShapePoint[] {
  const surface = geometry.footPlaces.map((along, foot) => {
    const bump = geometry.twoFeet ? Math.floor(foot / 2) : Math.min(foot, geometry.run.bumps - 1);
    return { along, height: 0, moveAlong: 0, moveIn: -(geometry.sleeveGaps[bump] ?? 0) };
  });
  return [
    { along: 0, height: 0, moveAlong: 0, moveIn: 0 },
    ...surface,
    { along: geometry.length, height: 0, moveAlong: 0, moveIn: surface[surface.length - 1]?.moveIn ?? 0 },
  ];
}

/** The bearing at an increment. */
export function shapeAt(geometry: BearingGeometry, cycle: Cycle, index: number): Shape {
  const [crestU, crestV] = [cycle.field('crest_u'), cycle.field('crest_v')];
  const [footU, footV] = [cycle.field('foot_u'), cycle.field('foot_v')];
  const top = cycle.field('top_displacement');
  const places = geometry.topFoil ? geometry.crestPlaces : [];
  const topNodes = places.map((along, bump) => ({
    along,
    height: geometry.rise,
    moveAlong: 0,
    moveIn: -top.at(index, bump),
  }));
  return {
    bumpFoil: bumpFoil(geometry, cycle, index),
    topFoil: geometry.topFoil ? topFoil(geometry, topNodes) : [],
    mover: mover(geometry, cycle, index),
    ground: ground(geometry),
    topNodes,
    crests: geometry.crestPlaces.map((along, bump) => ({
      along,
      height: geometry.rise,
      moveAlong: crestU.at(index, bump),
      moveIn: (geometry.crestOffsets[bump] ?? 0) - crestV.at(index, bump),
    })),
    feet: geometry.footPlaces.map((along, foot) => ({
      along,
      height: 0,
      moveAlong: footU.at(index, foot),
      moveIn: -footV.at(index, foot),
    })),
  };
}

/** How far a run moves at most, whatever the increment (m). */
export interface Reach {
  /** Along the foil, either way. */
  along: number;
  /** Of the parts of the foils and, in a flat one, of the plate: most inwards, and most outwards (negative). */
  inwards: number;
  outwards: number;
}

function reachOf(geometry: BearingGeometry): Reach {
  const { cycles, kind } = geometry.run;
  const extremes = (name: string, sign: number): [number, number] => {
    let [least, most] = [0, 0];
    for (const cycle of cycles) {
      for (const value of cycle.field(name).values) {
        if (sign * value > most) most = sign * value;
        if (sign * value < least) least = sign * value;
      }
    }
    return [least, most];
  };
  const error = [Math.min(0, ...geometry.crestOffsets), Math.max(0, ...geometry.crestOffsets)] as const;
  const crest = extremes('crest_v', -1);
  const ranges: (readonly [number, number])[] = [
    [crest[0] + error[0], crest[1] + error[1]],
    extremes('foot_v', -1),
    extremes('top_displacement', -1),
    [-Math.max(0, ...geometry.sleeveGaps), 0],
    ...(kind.flat ? cycles.map((cycle): [number, number] => [-Math.max(0, ...cycle.values('displacement')), -Math.min(0, ...cycle.values('displacement'))]) : []),
  ];
  return {
    along: largest(...cycles.flatMap((cycle) => ['crest_u', 'foot_u'].map((name) => cycle.field(name).values))),
    inwards: Math.max(...ranges.map(([, most]) => most)),
    outwards: Math.min(...ranges.map(([least]) => least)),
  };
}

/** Factors to choose from. */
export const magnifications = [1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 100, 200, 500, 1000];

function largestFactor(most: number): number {
  const fitting = magnifications.filter((factor) => factor <= most);
  return fitting[fitting.length - 1] ?? 1;
}

/** The largest factor with which no bump of a run is drawn pressed by more than half its height. */
export function fittingInwards(geometry: BearingGeometry): number {
  const pressed = Math.max(
    largest(...geometry.run.cycles.map((cycle) => cycle.values('displacement'))) - geometry.clearance,
    Math.abs(geometry.clearance),
    largest(geometry.crestOffsets),
  );
  return largestFactor((0.5 * geometry.rise) / pressed);
}

/** The largest factor with which no foot or crest is drawn 0.4 pitches away from its place. */
export function fittingAlong(geometry: BearingGeometry): number {
  const fields = geometry.run.cycles.flatMap((cycle) =>
    ['crest_u', 'foot_u'].map((name) => cycle.field(name).values),
  );
  const pitch = Math.min(...geometry.borders.slice(1).map((border, bump) => border - at(geometry.borders, bump)));
  return Math.min(100, largestFactor((0.4 * pitch) / largest(...fields)));
}
