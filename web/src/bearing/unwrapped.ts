import { at, type Cycle } from '../data/run';
import { svg } from '../ui/dom';
import type { Look } from '../ui/theme';
import { arrowPath, pathOf, stateMark, text, type Place } from './drawing';
import { partNames, type PartName } from './parts';
import type { BearingGeometry, Shape, ShapePoint } from './shape';

export interface Scene {
  geometry: BearingGeometry;
  cycle: Cycle;
  index: number;
  shape: Shape;
  /** Of displacements inwards and gaps, against the height of the bumps. */
  inwards: number;
  /** Of displacements along the foil, against its length. */
  along: number;
  /** Force that the longest arrow stands for, N. */
  largestForce: number;
  forces: boolean;
  /** Bump that the reader looks at. */
  bump: number | undefined;
}

const height = 270;
const margin = 14;
/** At the right, for the names of the foils. */
const room = 74;
/** Heights that moving parts stay between. */
const [ceiling, floor] = [44, 222];
/** Height of an undeformed bump on the drawing, at most. */
const bumpHeight = 84;
/** Half a mark of a contact and the thickness of a line. */
const rim = 6;
/** Foils are drawn as lines beside each other, not upon each other. */
const foilGap = 3.4;
const longestArrow = 44;
/** Friction is a small part of the normal force. */
export const frictionFactor = 4;

/** The bearing cut open at the weld and laid flat: sleeve below, journal above. */
export class UnwrappedLayout {
  /** Ends of the sleeve on the drawing. */
  readonly left: number;
  readonly right: number;
  private readonly perLength: number;
  private readonly perHeight: number;
  private readonly sleeveLevel: number;

  constructor(
    private readonly scene: Scene,
    readonly width: number,
  ) {
    const { geometry, inwards, along } = scene;
    // However much displacements are magnified, all of the foils stays on the drawing.
    const beyond = along * geometry.reach.along;
    this.perLength = (width - margin - room - 2 * rim) / (geometry.length + 2 * beyond);
    this.left = margin + rim + beyond * this.perLength;
    this.right = this.left + geometry.length * this.perLength;
    const above = geometry.rise + inwards * geometry.reach.inwards;
    const below = Math.max(0, -inwards * geometry.reach.outwards - geometry.rise);
    this.perHeight = Math.min(bumpHeight / geometry.rise, (floor - ceiling) / (above + below));
    this.sleeveLevel = Math.min(204, floor - below * this.perHeight);
  }

  place(point: ShapePoint, lift = 0): Place {
    return {
      x: this.left + (point.along + this.scene.along * point.moveAlong) * this.perLength,
      y: this.sleeveLevel - (point.height + this.scene.inwards * point.moveIn) * this.perHeight - lift,
    };
  }

  /** How much larger heights are drawn than lengths along the foil. */
  get stretch(): number {
    return this.perHeight / this.perLength;
  }

  /** Bump at a place on the drawing. */
  bumpAt(x: number): number {
    const { geometry } = this.scene;
    const bump = geometry.bumpAt((x - this.left) / this.perLength);
    return Math.min(Math.max(0, bump), geometry.run.bumps - 1);
  }
}

export function drawUnwrapped(root: SVGSVGElement, scene: Scene, current: Look, width: number): UnwrappedLayout {
  const { shape } = scene;
  const layout = new UnwrappedLayout(scene, width);
  const line = (points: ShapePoint[], lift: number): Place[] => points.map((point) => layout.place(point, lift));
  const journal = line(shape.mover, 2 * foilGap);
  const sleeve = line(shape.ground, -foilGap / 2);
  const journalBody = [{ x: layout.left, y: 0 }, ...journal, { x: layout.right, y: 0 }];
  const sleeveBody = [...sleeve, { x: layout.right, y: height - 22 }, { x: layout.left, y: height - 22 }];
  root.setAttribute('viewBox', `0 0 ${width} ${height}`);
  root.replaceChildren(
    ...highlight(scene, layout, current),
    svg('path', { d: pathOf(journalBody, true), fill: current.journal }),
    svg('path', { d: pathOf(journal), fill: 'none', stroke: current.line, 'stroke-width': 1.2 }),
    svg('path', { d: pathOf(sleeveBody, true), fill: current.grid }),
    svg('path', { d: pathOf(sleeve), fill: 'none', stroke: current.sleeve, 'stroke-width': 1.4 }),
    ...weld(scene, layout, current),
    svg('path', { d: pathOf(line(shape.bumpFoil, 0)), fill: 'none', stroke: current.bumpFoil, 'stroke-width': 2, 'stroke-linejoin': 'round' }),
    svg('path', { d: pathOf(line(shape.topFoil, foilGap)), fill: 'none', stroke: current.topFoil, 'stroke-width': 2, 'stroke-linejoin': 'round' }),
    ...(scene.forces ? forceArrows(scene, layout, current) : []),
    ...marks(scene, layout, current),
    ...numbers(scene, layout, current),
    ...partNames(names(scene, layout), current),
  );
  return layout;
}

/** The foils are named at their free end. */
function names({ shape, geometry }: Scene, layout: UnwrappedLayout): PartName[] {
  const { mover, ground } = geometry.run.kind;
  const aside = layout.width - room + 8;
  const bump = layout.place(lastOf(shape.bumpFoil));
  const top = layout.place(lastOf(shape.topFoil.length > 0 ? shape.topFoil : shape.mover), foilGap);
  const topName = Math.min(Math.max(top.y - 14, 30), bump.y - 26);
  return [
    { content: mover, at: { x: layout.left + 10, y: 18 } },
    { content: ground, at: { x: layout.right - 10, y: height - 28 }, anchor: 'end' },
    { content: 'bump foil', at: { x: aside, y: bump.y - 6 }, to: bump },
    ...(shape.topFoil.length > 0 ? [{ content: 'top foil', at: { x: aside, y: topName }, to: top }] : []),
    ...(geometry.welded ? [{ content: 'weld', at: { x: layout.left + 10, y: height - 28 }, to: layout.place({ along: 0, height: 0, moveAlong: 0, moveIn: 0 }) }] : []),
  ];
}

function lastOf(points: ShapePoint[]): ShapePoint {
  return points[points.length - 1] ?? { along: 0, height: 0, moveAlong: 0, moveIn: 0 };
}

/** Line to which the foils are welded. */
function weld({ geometry, shape }: Scene, layout: UnwrappedLayout, current: Look): SVGElement[] {
  if (!geometry.welded) return [];
  const foot = layout.place({ along: 0, height: 0, moveAlong: 0, moveIn: 0 });
  const top = layout.place(shape.topFoil[0] ?? { along: 0, height: 0.12 * geometry.rise, moveAlong: 0, moveIn: 0 }, foilGap);
  return [
    svg('path', { d: pathOf([foot, top]), stroke: current.topFoil, 'stroke-width': 3.4 }),
  ];
}

function highlight({ bump, geometry }: Scene, layout: UnwrappedLayout, current: Look): SVGElement[] {
  if (bump === undefined) return [];
  const edge = (along: number): number => layout.place({ along, height: 0, moveAlong: 0, moveIn: 0 }).x;
  const left = edge(at(geometry.borders, bump));
  return [svg('rect', { x: left, y: 0, width: edge(at(geometry.borders, bump + 1)) - left, height: height - 18, fill: current.accent, opacity: 0.12 })];
}

function forceArrows(scene: Scene, layout: UnwrappedLayout, current: Look): SVGElement[] {
  const { shape, cycle, index } = scene;
  const scale = longestArrow / scene.largestForce;
  const normal = (name: string, node: number): number => cycle.field(`normal_force_${name}`).at(index, node) * scale;
  const along = (name: string, node: number): number =>
    cycle.field(`friction_force_${name}`).at(index, node) * scale * frictionFactor;
  let normals = '';
  let frictions = '';
  shape.topNodes.forEach((node, bump) => {
    const tip = layout.place(node, 2 * foilGap);
    normals += arrowPath({ x: tip.x, y: tip.y - normal('journal_top', bump) }, tip);
  });
  shape.crests.forEach((crest, bump) => {
    const tip = layout.place(crest, foilGap);
    const tail = layout.place(crest, -4);
    const load = normal('top_bump', bump);
    // Where nothing lies between, it is the mover that presses.
    if (shape.topFoil.length === 0) normals += arrowPath({ x: tip.x, y: tip.y - load }, tip);
    else normals += arrowPath(tail, { x: tail.x, y: tail.y + load });
    frictions += arrowPath(tail, { x: tail.x + along('top_bump', bump), y: tail.y });
  });
  shape.feet.forEach((foot, i) => {
    const tip = layout.place(foot, -5);
    normals += arrowPath({ x: tip.x, y: tip.y + normal('bump_sleeve', i) }, tip);
    frictions += arrowPath(tip, { x: tip.x + along('bump_sleeve', i), y: tip.y });
  });
  return [svg('path', { d: normals, fill: current.force }), svg('path', { d: frictions, fill: current.friction })];
}

function marks({ shape, cycle, index }: Scene, layout: UnwrappedLayout, current: Look): SVGElement[] {
  const forward = { x: 1, y: 0 };
  return [
    ...shape.crests.map((crest, i) => stateMark(layout.place(crest), cycle, 'top_bump', index, i, current, forward)),
    ...shape.feet.map((foot, i) => stateMark(layout.place(foot), cycle, 'bump_sleeve', index, i, current, forward)),
  ];
}

function numbers({ geometry }: Scene, layout: UnwrappedLayout, current: Look): SVGElement[] {
  const spacing = (layout.right - layout.left) / geometry.crestPlaces.length;
  const step = [1, 2, 5, 10, 20, 50, 100].find((every) => every * spacing >= 24) ?? 200;
  return geometry.crestPlaces.flatMap((along, bump) => {
    if (bump !== 0 && (bump + 1) % step !== 0) return [];
    const { x } = layout.place({ along, height: 0, moveAlong: 0, moveIn: 0 });
    return [text({ x, y: height - 6 }, String(bump + 1), current, { 'text-anchor': 'middle', 'font-size': 11 })];
  });
}
