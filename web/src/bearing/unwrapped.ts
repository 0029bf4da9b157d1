import { at, type Cycle } from '../data/run';
import { formatQuantity } from '../data/units';
import { svg } from '../ui/dom';
import type { Look } from '../ui/theme';
import { arrowPath, pathOf, stateMark, text, type Place } from './drawing';
import { foilLines } from './foil_lines';
import type { BearingGeometry } from './geometry';
import { partNames, type PartName } from './parts';
import { onGround, type PadShape, type Shape, type ShapePoint } from './shape';

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
/** At the right, for the names of the foils; where there is little of it they stand in the drawing. */
const room = 74;
/** Width of a bump that is enough for that, and the least that tells the marks of its contacts from those beside it, px. */
const [roomyBump, leastBump] = [24, 10.5];
/** Heights that moving parts stay between. */
const [ceiling, floor] = [44, 222];
/** Height of an undeformed bump on the drawing, at most. */
const bumpHeight = 84;
/** Half a mark of a contact and the thickness of a line. */
const rim = 6;
/** Foils are drawn as lines beside each other, not upon each other. */
const foilGap = 3.4;
const longestArrow = 44;
/** Width of a letter of a name, on average. */
const letter = 7;
/** Friction is a small part of the normal force. */
export const frictionFactor = 4;

function widthOf({ run }: BearingGeometry, perBump: number): number {
  return perBump * (run.bumps + run.pads - 1) + 2 * margin + 2 * rim;
}

/** Of a drawing, px; where there is less, it scrolls. */
export function leastWidth(geometry: BearingGeometry): number {
  return widthOf(geometry, leastBump);
}

/** The bearing cut open at the welds and laid flat, pad after pad: sleeve below, journal above. */
export class UnwrappedLayout {
  /** Ends of the sleeve on the drawing. */
  readonly left: number;
  readonly right: number;
  /** Whether the names of the foils stand beside them. */
  readonly roomy: boolean;
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
    this.roomy = width >= widthOf(geometry, roomyBump);
    this.perLength = (width - margin - (this.roomy ? room : margin) - 2 * rim) / (geometry.length + 2 * beyond);
    this.left = margin + rim + beyond * this.perLength;
    this.right = this.left + geometry.length * this.perLength;
    const above = geometry.rise + inwards * geometry.reach.inwards;
    const below = Math.max(0, -inwards * geometry.reach.outwards - geometry.rise);
    this.perHeight = Math.min(bumpHeight / geometry.rise, (floor - ceiling) / (above + below));
    this.sleeveLevel = Math.min(204, floor - below * this.perHeight);
  }

  place(point: ShapePoint, lift = 0): Place {
    return {
      x: this.left + (point.pad.begin + point.along + this.scene.along * point.moveAlong) * this.perLength,
      y: this.sleeveLevel - (point.height + this.scene.inwards * point.moveIn) * this.perHeight - lift,
    };
  }

  /** How much larger heights are drawn than lengths along the foil. */
  get stretch(): number {
    return this.perHeight / this.perLength;
  }

  /** Where a bump is on the drawing. */
  placeOfBump(bump: number): number {
    const { geometry } = this.scene;
    return this.place(onGround(geometry.padOfBump(bump), at(geometry.crestPlaces, bump))).x;
  }

  /** Bump at a place on the drawing. */
  bumpAt(x: number): number {
    return this.scene.geometry.bumpAt((x - this.left) / this.perLength);
  }
}

export function drawUnwrapped(root: SVGSVGElement, scene: Scene, current: Look, width: number): UnwrappedLayout {
  const { shape } = scene;
  const layout = new UnwrappedLayout(scene, width);
  const line = (part: keyof PadShape, lift: number): Place[][] => shape.pads.map((pad) => pad[part].map((point) => layout.place(point, lift)));
  const stroke = (part: keyof PadShape, lift: number): string => line(part, lift).map((places) => pathOf(places)).join('');
  /** From the line to a level, as far as each pad goes. */
  const body = (part: keyof PadShape, lift: number, level: number): string =>
    line(part, lift)
      .map((places) => pathOf([{ x: at(places, 0).x, y: level }, ...places, { x: at(places, places.length - 1).x, y: level }], true))
      .join('');
  root.setAttribute('viewBox', `0 0 ${width} ${height}`);
  root.replaceChildren(
    ...highlight(scene, layout, current),
    svg('path', { d: body('journal', 2 * foilGap, 0), fill: current.journal }),
    svg('path', { d: stroke('journal', 2 * foilGap), fill: 'none', stroke: current.line, 'stroke-width': 1.2 }),
    svg('path', { d: body('ground', -foilGap / 2, height - 22), fill: current.grid }),
    svg('path', { d: stroke('ground', -foilGap / 2), fill: 'none', stroke: current.sleeve, 'stroke-width': 1.4 }),
    ...shims(scene, layout, current),
    ...welds(scene, layout, current),
    ...foilLines(scene, (point) => layout.place(point), 2, current),
    svg('path', { d: stroke('topFoil', foilGap), class: 'foil top-foil', fill: 'none', stroke: current.topFoil, 'stroke-width': 2, 'stroke-linejoin': 'round' }),
    ...(scene.forces ? forceArrows(scene, layout, current) : []),
    ...marks(scene, layout, current),
    ...numbers(scene, layout, current),
    ...partNames(names(scene, layout), current),
  );
  return layout;
}

/** The foils are named at their free end. */
function names({ shape, geometry }: Scene, layout: UnwrappedLayout): PartName[] {
  const { journal, ground } = geometry.run.kind;
  const aside = layout.width - room + 8;
  const last = at(shape.pads, shape.pads.length - 1);
  const bump = layout.place(lastOf(last.bumpFoil));
  const top = layout.place(lastOf(geometry.topFoil ? last.topFoil : last.journal), foilGap);
  const topName = Math.min(Math.max(top.y - 14, 30), bump.y - 26);
  const foil = (content: string, level: number, inner: Place, to: Place): PartName =>
    layout.roomy ? { content, at: { x: aside, y: level }, to } : { content, at: inner, to, anchor: 'end' };
  return [
    { content: journal, at: { x: layout.left + 10, y: 18 } },
    { content: ground, at: { x: layout.right - 10, y: height - 28 }, anchor: 'end' },
    foil('bump foil', bump.y - 6, { x: layout.right - 64, y: height - 28 }, bump),
    ...(geometry.topFoil ? [foil('top foil', topName, { x: layout.right - 10, y: 18 }, top)] : []),
    ...geometry.shims.map(({ pad, begin, end, thickness }): PartName => {
      const { x, y } = layout.place(onGround(pad, 0.5 * (begin + end)));
      return { content: `shim ${formatQuantity(thickness, 'm')}`, at: { x, y: y + 22 }, anchor: 'middle' };
    }),
    ...(geometry.welded ? weldNames(geometry, layout) : []),
  ];
}

/** Of pads in short where they are close, and none where even that would cover the next name: all welds look alike. */
function weldNames({ pads }: BearingGeometry, layout: UnwrappedLayout): PartName[] {
  const places = pads.map((pad) => layout.place(onGround(pad, 0)));
  // At the end are the names of the sleeve and, without room beside them, of the bump foil.
  const others = layout.right - (layout.roomy ? 60 : 135);
  const ends = [...places.slice(1).map(({ x }) => Math.min(x, others)), others];
  return pads.flatMap(({ name }, i): PartName[] => {
    const to = at(places, i);
    const fits = (content: string): boolean => to.x + 10 + letter * content.length < at(ends, i);
    const content = (name === '' ? ['weld'] : [`weld of ${name}`, `weld ${i + 1}`]).find(fits);
    return content === undefined ? [] : [{ content, at: { x: to.x + 10, y: height - 28 }, to }];
  });
}

function lastOf(points: ShapePoint[]): ShapePoint {
  return at(points, points.length - 1);
}

/** Lines to which the foils are welded. */
function welds({ geometry, shape }: Scene, layout: UnwrappedLayout, current: Look): SVGElement[] {
  if (!geometry.welded) return [];
  const lines = geometry.pads.map((pad, i) => {
    const top = at(shape.pads, i).topFoil[0] ?? { ...onGround(pad, 0), height: 0.12 * geometry.rise };
    return pathOf([layout.place(onGround(pad, 0)), layout.place(top, foilGap)]);
  });
  return [svg('path', { d: lines.join(''), stroke: current.topFoil, 'stroke-width': 3.4 })];
}

/** Bars in the sleeve under the bumps that they lift; how much is seen at the crests. */
function shims({ geometry }: Scene, layout: UnwrappedLayout, current: Look): SVGElement[] {
  return geometry.shims.map(({ pad, begin, end, thickness }) => {
    const [from, to] = [layout.place(onGround(pad, begin)), layout.place(onGround(pad, end))];
    return svg(
      'rect',
      { class: 'shim', x: from.x + 1, y: from.y + foilGap / 2 + 1, width: to.x - from.x - 2, height: 5, fill: current.muted },
      svg('title', {}, `Shim of ${formatQuantity(thickness, 'm')}`),
    );
  });
}

function highlight({ bump, geometry }: Scene, layout: UnwrappedLayout, current: Look): SVGElement[] {
  if (bump === undefined) return [];
  const pad = geometry.padOfBump(bump);
  const edge = (number: number): number => layout.place(onGround(pad, at(pad.borders, number))).x;
  const left = edge(bump - pad.firstBump);
  return [svg('rect', { x: left, y: 0, width: edge(bump - pad.firstBump + 1) - left, height: height - 18, fill: current.accent, opacity: 0.12 })];
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
    // Where nothing lies between, it is the journal that presses.
    if (shape.topNodes.length === 0) normals += arrowPath({ x: tip.x, y: tip.y - load }, tip);
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
    const pad = geometry.padOfBump(bump);
    const number = bump - pad.firstBump + 1;
    if (number !== 1 && number % step !== 0) return [];
    const { x } = layout.place(onGround(pad, along));
    return [text({ x, y: height - 6 }, String(number), current, { 'text-anchor': 'middle', 'font-size': 11 })];
  });
}
