import { at } from '../data/run';
import { svg } from '../ui/dom';
import type { Look } from '../ui/theme';
import { arrowPath, letters, pathOf, stateMark, text, type Place } from './drawing';
import { foilLines } from './foil_lines';
import type { Pad } from './geometry';
import { partNames, type PartName } from './parts';
import { onGround, type ShapePoint } from './shape';
import type { Scene } from './unwrapped';

const size = 480;
const centre = size / 2;
/** Radius of the sleeve, and height of an undeformed bump, on the drawing. */
const sleeveRadius = 192;
const bumpHeight = 30;
const foilGap = 2.2;
const longestArrow = 30;
/** Between the loads on the journal and its middle. */
const padNameRadius = 92;

/** The bearing as it stands, seen along its axis: X to the right, Y up. */
class RoundLayout {
  readonly perHeight: number;

  constructor(private readonly scene: Scene) {
    const { geometry, inwards } = scene;
    // However much displacements are magnified, all of the foils stays on the drawing and leaves its middle free.
    const lobes = [0, ...geometry.pads.map(({ lobe }) => lobe)];
    const above = geometry.rise + inwards * (geometry.reach.inwards + Math.max(...lobes));
    const below = Math.max(0, -inwards * (geometry.reach.outwards + Math.min(...lobes)) - geometry.rise);
    this.perHeight = Math.min(bumpHeight / geometry.rise, (0.6 * sleeveRadius) / above, (0.8 * (centre - sleeveRadius)) / below);
  }

  /** How much larger heights of bumps are drawn than the radius. */
  get stretch(): number {
    return (this.perHeight * this.scene.geometry.radius) / sleeveRadius;
  }

  /** Polar angle and radius on the drawing. */
  polar(point: ShapePoint, lift: number): [number, number] {
    const { geometry, inwards, along } = this.scene;
    const moveIn = point.moveIn + geometry.lobeAt(point.pad, point.along);
    const radius = sleeveRadius - (point.height + inwards * moveIn) * this.perHeight - lift;
    return [geometry.polarAngle(point.pad, point.along + along * point.moveAlong), radius];
  }

  place(point: ShapePoint, lift = 0): Place {
    return onCircle(...this.polar(point, lift));
  }

  /** Unit vector of increasing place along the foil. */
  forward(point: ShapePoint): Place {
    const [angle] = this.polar(point, 0);
    const { sense } = point.pad;
    return { x: -sense * Math.sin(angle), y: -sense * Math.cos(angle) };
  }
}

function onCircle(angle: number, radius: number): Place {
  return { x: centre + radius * Math.cos(angle), y: centre - radius * Math.sin(angle) };
}

/**
 * Draws the bearing; returns how much larger heights are than the radius.
 * @param shown  size of the drawing on the screen, px; 0 where it is not known
 */
export function drawRound(root: SVGSVGElement, scene: Scene, current: Look, shown: number): number {
  const { geometry, shape, cycle, index } = scene;
  const layout = new RoundLayout(scene);
  const topFoils = shape.pads.map(({ topFoil }) => pathOf(topFoil.map((point) => layout.place(point, foilGap)))).join('');
  const scale = scene.inwards * layout.perHeight;
  const journal = {
    x: centre + scale * cycle.value('x', index),
    y: centre - scale * cycle.value('y', index),
  };
  const journalRadius = sleeveRadius - bumpHeight - scale * geometry.clearance - 2 * foilGap;
  const welds = shape.pads.map(({ topFoil }) => {
    const top = at(topFoil, 0);
    return pathOf([layout.place(onGround(top.pad, 0), -5), layout.place(top, foilGap)]);
  });
  root.setAttribute('viewBox', `0 0 ${size} ${size}`);
  const font = letters(size, shown);
  root.replaceChildren(
    svg('circle', { cx: centre, cy: centre, r: sleeveRadius + 13, fill: current.grid }),
    svg('path', { d: sleeve(scene, layout), fill: current.background, stroke: current.sleeve, 'stroke-width': 1.4 }),
    svg('circle', { cx: journal.x, cy: journal.y, r: Math.max(0, journalRadius), fill: current.journal, stroke: current.line, 'stroke-width': 1.2 }),
    ...axes(current, font),
    svg('path', { d: welds.join(''), stroke: current.topFoil, 'stroke-width': 3.4 }),
    ...foilLines(scene, (point) => layout.place(point), 1.7, current),
    svg('path', { d: topFoils, class: 'foil top-foil', fill: 'none', stroke: current.topFoil, 'stroke-width': 1.7, 'stroke-linejoin': 'round' }),
    ...(scene.forces ? forceArrows(scene, layout, journal, current) : []),
    ...shape.feet.map((foot, i) => stateMark(layout.place(foot), cycle, 'bump_sleeve', index, i, current, layout.forward(foot))),
    ...numbers(scene, current, font),
    ...partNames(names(scene, layout, journal), current, font),
  );
  return layout.stretch;
}

/** How far two angles are apart. */
function between(a: number, b: number): number {
  return Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)));
}

/** Its inner side: under pads where these have it, and round between them. */
function sleeve({ geometry }: Scene, layout: RoundLayout): string {
  const under = (pad: Pad): Place[] => {
    const pieces = Math.ceil(90 * (pad.length / geometry.radius / Math.PI)) + 1;
    const places = Array.from({ length: pieces + 1 }, (_, i) => layout.place(onGround(pad, (pad.length * i) / pieces), -foilGap / 2));
    return pad.sense > 0 ? places : places.reverse();
  };
  const turn = 2 * Math.PI;
  const first = (pad: Pad): number => geometry.polarAngle(pad, pad.sense > 0 ? 0 : pad.length);
  const order = [...geometry.pads].sort((a, b) => ((first(a) % turn) + turn) % turn - ((first(b) % turn) + turn) % turn);
  return pathOf(
    order.flatMap((pad, i) => {
      const end = first(pad) + pad.length / geometry.radius;
      const free = (((first(at(order, (i + 1) % order.length)) - end) % turn) + turn) % turn;
      const pieces = Math.ceil((90 * free) / Math.PI);
      return [...under(pad), ...Array.from({ length: pieces + 1 }, (_, k) => onCircle(end + (free * k) / Math.max(1, pieces), sleeveRadius + foilGap / 2))];
    }),
    true,
  );
}

/** In the corners beside what they name, the weld in the one that is next to it; pads by their middles. */
function names({ geometry, shape }: Scene, layout: RoundLayout, journal: Place): PartName[] {
  const nearest = (points: ShapePoint[], angle: number, lift: number): Place => {
    const apart = (point: ShapePoint): number => between(layout.polar(point, 0)[0], angle);
    return layout.place(points.reduce((best, one) => (apart(one) < apart(best) ? one : best)), lift);
  };
  const corner = (right: boolean, low: boolean): Pick<PartName, 'at' | 'anchor'> => ({
    at: { x: right ? size - 6 : 6, y: low ? size - 8 : 18 },
    anchor: right ? 'end' : 'start',
  });
  const corners = [0.25, 0.75, 1.25, 1.75].map((turns) => turns * Math.PI);
  const { weldAngle } = at(geometry.pads, 0);
  const order = [...corners].sort((a, b) => between(a, weldAngle) - between(b, weldAngle));
  const parts: [string, (angle: number) => Place][] = [
    ['weld', () => onCircle(weldAngle, sleeveRadius + 4)],
    ['sleeve', (angle) => onCircle(angle, sleeveRadius + 8)],
    ['bump foil', (angle) => nearest(shape.crests, angle, 0)],
    ['top foil', (angle) => nearest(shape.pads.flatMap(({ topFoil }) => topFoil), angle, foilGap)],
  ];
  return [
    { content: 'journal', at: { x: journal.x, y: journal.y + 0.2 * sleeveRadius }, anchor: 'middle' },
    ...parts.map(([content, place], i): PartName => {
      const angle = order[i] ?? 0;
      return { content, ...corner(Math.cos(angle) > 0, Math.sin(angle) < 0), to: place(angle) };
    }),
    ...geometry.pads.filter(({ name }) => name !== '').map((pad): PartName => {
      const middle = onCircle(geometry.polarAngle(pad, 0.5 * pad.length), padNameRadius);
      return { content: pad.name, at: { x: middle.x, y: middle.y + 4 }, anchor: 'middle' };
    }),
  ];
}

function axes(current: Look, font: number): SVGElement[] {
  const line = { stroke: current.line, 'stroke-width': 0.8, 'stroke-dasharray': '5 4' };
  const reach = sleeveRadius - bumpHeight - 26;
  return [
    svg('line', { x1: centre - reach, y1: centre, x2: centre + reach, y2: centre, ...line }),
    svg('line', { x1: centre, y1: centre - reach, x2: centre, y2: centre + reach, ...line }),
    text({ x: centre + reach - 10, y: centre - 6 }, 'X', current, { 'font-size': font }),
    text({ x: centre + 6, y: centre - reach + 12 }, 'Y', current, { 'font-size': font }),
  ];
}

/** Loads of the journal on the top foil, of the sleeve on the feet, and the applied force. */
function forceArrows(scene: Scene, layout: RoundLayout, journal: Place, current: Look): SVGElement[] {
  const { shape, cycle, index } = scene;
  const scale = longestArrow / scene.largestForce;
  let normals = '';
  const radial = (point: ShapePoint, lift: number, load: number): void => {
    const [angle, radius] = layout.polar(point, lift);
    normals += arrowPath(onCircle(angle, radius - load * scale), onCircle(angle, radius));
  };
  shape.topNodes.forEach((node, bump) => {
    radial(node, 2 * foilGap, cycle.field('normal_force_journal_top').at(index, bump));
  });
  shape.feet.forEach((foot, i) => radial(foot, -3, -cycle.field('normal_force_bump_sleeve').at(index, i)));
  const force = { x: cycle.value('force_x', index), y: cycle.value('force_y', index) };
  const most = Math.max(...['force_x', 'force_y'].flatMap((name) => [...cycle.values(name)].map(Math.abs)), 1e-30);
  const reach = (0.5 * sleeveRadius) / most;
  const tip = { x: journal.x + force.x * reach, y: journal.y - force.y * reach };
  return [
    svg('path', { d: normals, fill: current.force }),
    svg('circle', { cx: journal.x, cy: journal.y, r: 3, fill: current.accent }),
    svg('path', { d: arrowPath(journal, tip, 3), fill: current.accent }),
  ];
}

function numbers({ geometry, bump }: Scene, current: Look, font: number): SVGElement[] {
  const radius = sleeveRadius + 26;
  const most = Math.min(40, (2 * Math.PI * radius) / (2.5 * font));
  const step = [1, 2, 5, 10, 20, 50, 100].find((every) => most * every >= geometry.crestPlaces.length) ?? 200;
  return geometry.crestPlaces.flatMap((along, i) => {
    const pad = geometry.padOfBump(i);
    const number = i - pad.firstBump + 1;
    if (i !== bump && number !== 1 && number % step !== 0) return [];
    const { x, y } = onCircle(geometry.polarAngle(pad, along), radius);
    const chosen = i === bump ? { fill: current.accent, 'font-weight': 'bold' } : {};
    return [text({ x, y: y + 0.36 * font }, String(number), current, { 'text-anchor': 'middle', 'font-size': font, ...chosen })];
  });
}
