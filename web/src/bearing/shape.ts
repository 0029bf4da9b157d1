/** Shapes of the parts of a deformed bearing. Nothing is drawn here: the two views lay these points out. */
import { at, largest, type Cycle } from '../data/run';
import type { BearingGeometry, Pad } from './geometry';

/**
 * A point of a part: place along the foil of its pad from the weld and height over the sleeve (m, as designed), and what
 * is to be magnified: displacement away from the weld and inwards, gaps and errors of height (m).
 */
export interface ShapePoint {
  pad: Pad;
  along: number;
  height: number;
  moveAlong: number;
  moveIn: number;
}

/** On the sleeve as it is without shims. */
export function onGround(pad: Pad, along: number): ShapePoint {
  return { pad, along, height: 0, moveAlong: 0, moveIn: 0 };
}

/** The parts of one pad. */
export interface PadShape {
  bumpFoil: ShapePoint[];
  /** Empty where there is none. */
  topFoil: ShapePoint[];
  /** Of the journal, or of the plate. */
  journal: ShapePoint[];
  /** Of the sleeve, or of the base. */
  ground: ShapePoint[];
}

export interface Shape {
  pads: PadShape[];
  /** One per bump. */
  crests: ShapePoint[];
  /** One per bump, of the top foil over it; none without it. */
  topNodes: ShapePoint[];
  feet: ShapePoint[];
}

const halfArcPoints = 9;

interface Move {
  along: number;
  inwards: number;
}

function bumpFoil(geometry: BearingGeometry, pad: Pad, cycle: Cycle, index: number): ShapePoint[] {
  const [crestU, crestV] = [cycle.field('crest_u'), cycle.field('crest_v')];
  const [footU, footV] = [cycle.field('foot_u'), cycle.field('foot_v')];
  const footMove = (foot: number | undefined): Move =>
    foot === undefined ? { along: 0, inwards: 0 } : { along: footU.at(index, foot), inwards: -footV.at(index, foot) };
  const atFoot = (foot: number): ShapePoint => {
    const move = footMove(foot);
    return { pad, along: at(geometry.footPlaces, foot), height: 0, moveAlong: move.along, moveIn: move.inwards };
  };
  const points: ShapePoint[] = [];
  if (geometry.welded) points.push(onGround(pad, 0));
  else if (!geometry.twoFeet) points.push(atFoot(pad.firstFoot));
  pad.borders.slice(1).forEach((_, i) => {
    const bump = pad.firstBump + i;
    const place = at(geometry.crestPlaces, bump);
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
        pad,
        along: place + distance,
        height: geometry.arc(bump, distance),
        moveAlong: foot.along + weight * (crest.along - foot.along),
        moveIn: foot.inwards + weight * (crest.inwards - foot.inwards),
      });
    }
  });
  // After the last bump of a truss there is half a flat; a frame ends with its arc.
  if (!geometry.twoFeet && pad.feet > 0) points.push(atFoot(pad.firstFoot + pad.feet - 1));
  return points;
}

function middle(a: ShapePoint, b: ShapePoint): ShapePoint {
  const of = (name: 'along' | 'height' | 'moveAlong' | 'moveIn'): number => 0.5 * (a[name] + b[name]);
  return { pad: a.pad, along: of('along'), height: of('height'), moveAlong: of('moveAlong'), moveIn: of('moveIn') };
}

/** The bump foils of all pads in pieces that are drawn as wide: from the middle of a flat to that of another. */
export function foilPieces(geometry: BearingGeometry, shape: Shape): { weight: number; points: ShapePoint[] }[] {
  return shape.pads.flatMap(({ bumpFoil: points }) => {
    const { firstBump, borders } = at(points, 0).pad;
    const bumps = borders.length - 1;
    const perBump = 2 * halfArcPoints + 1;
    const before = geometry.welded || !geometry.twoFeet ? 1 : 0;
    const start = (bump: number): number => before + bump * perBump;
    const border = (bump: number): ShapePoint => middle(at(points, start(bump) - 1), at(points, start(bump)));
    const pieces: { weight: number; points: ShapePoint[] }[] = [];
    for (let first = 0, end = 1; first < bumps; first = end) {
      const weight = geometry.lineWeight(firstBump + first);
      for (end = first + 1; end < bumps && geometry.lineWeight(firstBump + end) === weight; ) end += 1;
      const inner = points.slice(first === 0 ? 0 : start(first), end === bumps ? points.length : start(end));
      pieces.push({ weight, points: [...(first === 0 ? [] : [border(first)]), ...inner, ...(end === bumps ? [] : [border(end)])] });
    }
    return pieces;
  });
}

/** A smooth curve through what is known at the weld and over the crests. */
function topFoil(geometry: BearingGeometry, pad: Pad, nodes: ShapePoint[]): ShapePoint[] {
  const first: ShapePoint = { pad, along: 0, height: geometry.rise, moveAlong: 0, moveIn: geometry.welded ? 0 : at(nodes, 0).moveIn };
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
        pad,
        along: a.along + t * span,
        height: geometry.rise,
        moveAlong: 0,
        moveIn: a.moveIn + t * (b.moveIn - a.moveIn) + bend,
      });
    }
  }
  const last = known.length - 1;
  const end = at(known, last);
  const rest = pad.length - end.along;
  points.push({ pad, along: pad.length, height: geometry.rise, moveAlong: 0, moveIn: end.moveIn + slope(last) * rest });
  return points;
}

/** Gap between the undeformed top foil (or the crests) and the journal or the plate. */
export function undeformedGap(geometry: BearingGeometry, pad: Pad, along: number, cycle: Cycle, index: number): number {
  if (geometry.run.kind.flat) return -cycle.value('displacement', index);
  const phi = geometry.polarAngle(pad, along);
  return geometry.clearance - geometry.lobeAt(pad, along) - (cycle.value('x', index) * Math.cos(phi) + cycle.value('y', index) * Math.sin(phi));
}

function journal(geometry: BearingGeometry, pad: Pad, cycle: Cycle, index: number): ShapePoint[] {
  const pieces = 120;
  return Array.from({ length: pieces + 1 }, (_, i) => {
    const along = (pad.length * i) / pieces;
    return { pad, along, height: geometry.rise, moveAlong: 0, moveIn: undeformedGap(geometry, pad, along, cycle, index) };
  });
}

function ground(geometry: BearingGeometry, pad: Pad): ShapePoint[] {
  const surface = geometry.footPlaces.slice(pad.firstFoot, pad.firstFoot + pad.feet).map((along, i) => {
    const bump = pad.firstBump + (geometry.twoFeet ? Math.floor(i / 2) : Math.min(i, pad.borders.length - 2));
    return { ...onGround(pad, along), moveIn: -(geometry.sleeveGaps[bump] ?? 0) };
  });
  return [onGround(pad, 0), ...surface, { ...onGround(pad, pad.length), moveIn: surface[surface.length - 1]?.moveIn ?? 0 }];
}

/** The bearing at an increment. */
export function shapeAt(geometry: BearingGeometry, cycle: Cycle, index: number): Shape {
  const [crestU, crestV] = [cycle.field('crest_u'), cycle.field('crest_v')];
  const [footU, footV] = [cycle.field('foot_u'), cycle.field('foot_v')];
  const top = cycle.field('top_displacement');
  const places = geometry.topFoil ? geometry.crestPlaces : [];
  const topNodes = places.map((along, bump) => ({
    pad: geometry.padOfBump(bump),
    along,
    height: geometry.rise,
    moveAlong: 0,
    moveIn: -top.at(index, bump),
  }));
  return {
    pads: geometry.pads.map((pad) => ({
      bumpFoil: bumpFoil(geometry, pad, cycle, index),
      topFoil: geometry.topFoil ? topFoil(geometry, pad, topNodes.filter((node) => node.pad === pad)) : [],
      journal: journal(geometry, pad, cycle, index),
      ground: ground(geometry, pad),
    })),
    topNodes,
    crests: geometry.crestPlaces.map((along, bump) => ({
      pad: geometry.padOfBump(bump),
      along,
      height: geometry.rise,
      moveAlong: crestU.at(index, bump),
      moveIn: (geometry.crestOffsets[bump] ?? 0) - crestV.at(index, bump),
    })),
    feet: geometry.footPlaces.map((along, foot) => ({
      pad: geometry.padOfFoot(foot),
      along,
      height: 0,
      moveAlong: footU.at(index, foot),
      moveIn: -footV.at(index, foot),
    })),
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
  const lobes = geometry.pads.map(({ lobe }) => lobe);
  const pressed = Math.max(
    largest(...geometry.run.cycles.map((cycle) => cycle.values('displacement'))) - geometry.clearance + Math.max(...lobes),
    largest(lobes),
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
  const pitch = Math.min(...geometry.pads.flatMap(({ borders }) => borders.slice(1).map((border, i) => border - at(borders, i))));
  return Math.min(100, largestFactor((0.4 * pitch) / largest(...fields)));
}
