/** The running bearing in three dimensions: pressure or film thickness as colour on the top foil, turned by pointer and keys. */
import { numbersOf, type Place } from '../data/grid';
import { fractionIn, rangeOf, type Range } from '../data/range';
import { at, capital } from '../data/run';
import { toCsv } from '../data/csv';
import type { States } from '../data/states';
import { formatQuantity } from '../data/units';
import { colourBar, rangeText } from '../charts/colour_bar';
import { dropDown, el, svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { fontFamily, isPrinting, look, onLookChange, rampColour, type Look } from '../ui/theme';
import type { BearingGeometry } from './geometry';
import type { Cycle } from '../data/run';
import { coloured, solidAt, type Coloured, type Facet, type Point3, type Solid } from './solid';

const degree = Math.PI / 180;
/** Turned so far at first, towards where the inside is seen that carries; of keys, rad. */
const [firstYaw, firstPitch, step] = [38 * degree, 22 * degree, 6 * degree];
/** A drag over the width of the drawing turns by so much, rad. */
const perWidth = Math.PI;
const [closest, farthest] = [3, 0.5];

/** How it is seen: turned about the vertical, then about the horizontal axis of the drawing. */
class View {
  yaw = 0;
  pitch = 0;
  zoom = 1;

  /** @param peak  polar angle at which the pressure is highest */
  constructor(private readonly peak: number) {
    this.reset();
  }

  reset(): void {
    this.yaw = Math.cos(this.peak) < 0 ? -firstYaw : firstYaw;
    this.pitch = Math.sin(this.peak) > 0.3 ? -firstPitch : firstPitch;
    this.zoom = 1;
  }

  /** To the right, upwards, towards the reader. */
  seen([x, y, z]: Point3): Point3 {
    const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    const [right, towards] = [cy * x + sy * z, cy * z - sy * x];
    return [right, cp * y - sp * towards, cp * towards + sp * y];
  }

  turn(yaw: number, pitch: number): void {
    this.yaw += yaw;
    this.pitch = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, this.pitch + pitch));
  }
}

const colours: Record<Coloured, { text: string; unit: string }> = { pressure: { text: 'pressure', unit: 'Pa' }, film_thickness: { text: 'film thickness', unit: 'm' } };

/** By how much it is exaggerated, and where the film is thinnest. */
function wordsOf(states: States, place: Place, solid: Solid | undefined): string {
  if (!solid) return 'no state found';
  const bumps = solid.bumps > 1 ? `, heights of bumps ×${solid.bumps}` : '';
  const tilt = Math.hypot(states.numberAt('tilt_x', place), states.numberAt('tilt_y', place));
  const tilted = tilt > 0 ? `; journal tilted by ${formatQuantity(tilt, 'rad', 3)}` : '';
  return `film and displacements ×${solid.film}${bumps} against the radius${tilted}; minimum film thickness ${formatQuantity(states.numberAt('h_min', place), 'm')}`;
}

/** Follows the state that the reader looks at. @param bearing  foils of the states, where there are any */
export function spaceView(states: States, selection: GridSelection, bearing: () => { geometry: BearingGeometry; cycle: Cycle } | undefined): HTMLElement[] {
  if (!states.variable('pressure') || states.data.left_out.includes('pressure')) return [];
  const canvas = el('canvas', { class: 'space', role: 'img', tabindex: 0 });
  let solid = solidAt(states, selection.place, bearing());
  const peak = (solid?.facets ?? []).filter(({ of }) => of === 'top foil').reduce<Facet | undefined>((most, one) => (one.values.pressure > (most?.values.pressure ?? -Infinity) ? one : most), undefined);
  const view = new View(peak ? Math.atan2(peak.outward[1], peak.outward[0]) : 0);
  const where = (): string => selection.textAt(selection.place);
  const ambient = (): number => states.variable('ambient_pressure')?.at({}) ?? NaN;
  let by: Coloured = 'pressure';
  const range = (): Range => rangeOf((solid?.facets ?? []).map(({ values }) => values[by]));
  const panel = new Panel(
    {
      title: 'Bearing in 3D',
      controls: [
        dropDown('Colour of the top foil', coloured.map((value) => ({ value, text: capital(colours[value].text) })), (chosen) => {
          by = chosen;
          follow();
        }),
      ],
      note: 'Drag to rotate it, or focus it and use the arrow keys; + and − zoom, Home resets the view.',
      subject: () => [`top foil coloured by ${colours[by].text}`, wordsOf(states, selection.place, solid), where(), states.label].filter((words) => words !== '').join(' · '),
      legend: () => [
        ...(solid ? [colourBar(range(), colours[by].unit, by === 'pressure' ? { value: ambient(), text: 'ambient' } : undefined)] : []),
        { width: 14, draw: (current) => [svg('rect', { x: 1, y: 1, width: 12, height: 10, fill: filmColour(current), 'fill-opacity': 0.5 })], text: 'film at the ends' },
        { width: 26, draw: (current) => [svg('path', { d: 'M1 6H25', stroke: current.muted, 'stroke-width': 1.2 })], text: 'journal' },
        ...(bearing() ? [{ width: 14, draw: (current: Look) => [svg('rect', { x: 1, y: 1, width: 12, height: 10, fill: current.bumpFoil, 'fill-opacity': 0.45 })], text: 'bump foil' }] : []),
      ],
      canvas: () => canvas,
      file: () => fileName('bearing-in-3d', states.label, where()),
      csv: () => csvOf(states, selection.place),
    },
    canvas,
  );
  let due = 0;
  const draw = (): void => {
    due = 0;
    paint(canvas, solid, view, look(), { by, range: range() });
  };
  const later = (): void => {
    if (due === 0) due = requestAnimationFrame(draw);
  };
  const follow = (): void => {
    solid = solidAt(states, selection.place, bearing());
    panel.refresh();
    canvas.setAttribute('aria-label', `Bearing in 3D: ${solid ? `${colours[by].text} on the top foil ${rangeText(range(), colours[by].unit)}, ambient pressure ${formatQuantity(ambient(), 'Pa')}; ` : ''}${wordsOf(states, selection.place, solid)}; ${where()}. Arrow keys rotate it.`);
    later();
  };
  selection.onChange(follow);
  // Paper takes what is drawn at once.
  onLookChange(draw);
  new ResizeObserver(later).observe(canvas);
  steer(canvas, view, later);
  follow();
  return [panel.root];
}

/** Pointer and keys. */
function steer(canvas: HTMLCanvasElement, view: View, redraw: () => void): void {
  let from: { x: number; y: number } | undefined;
  canvas.addEventListener('pointerdown', (event) => {
    from = { x: event.clientX, y: event.clientY };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!from) return;
    const scale = perWidth / Math.max(1, canvas.clientWidth);
    view.turn((event.clientX - from.x) * scale, (event.clientY - from.y) * scale);
    from = { x: event.clientX, y: event.clientY };
    redraw();
  });
  for (const end of ['pointerup', 'pointercancel'] as const) canvas.addEventListener(end, () => (from = undefined));
  canvas.addEventListener('keydown', (event) => {
    const turns: Record<string, [number, number]> = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] };
    const turn = turns[event.key];
    if (turn) view.turn(...turn);
    else if (event.key === '+' || event.key === '=') view.zoom = Math.min(closest, view.zoom * 1.15);
    else if (event.key === '-') view.zoom = Math.max(farthest, view.zoom / 1.15);
    else if (event.key === 'Home') view.reset();
    else return;
    event.preventDefault();
    redraw();
  });
}

function filmColour(current: Look): string {
  return at(current.series, 5);
}

interface Drawn {
  /** Shells lie in each other: the far sides from outside to inside, then the near sides. */
  layer: number;
  depth: number;
  paint: () => void;
}

const layers: Record<Facet['of'], number> = { 'bump foil': 0, 'top foil': 1, film: 2 };
const [journalLayer, sleeveLayer, nearest] = [3, -1, 7];

/** The farthest first. What faces the reader from outside is pale: the inside is to be seen. */
function paint(canvas: HTMLCanvasElement, solid: Solid | undefined, view: View, current: Look, { by, range }: { by: Coloured; range: Range }): void {
  const width = canvas.clientWidth;
  const context = canvas.getContext('2d');
  if (!context || width === 0) return;
  const height = Math.min(width, isPrinting() ? 330 : 640);
  const ratio = isPrinting() ? 3 : Math.max(1, window.devicePixelRatio);
  canvas.style.height = `${height}px`;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillStyle = current.background;
  context.fillRect(0, 0, width, height);
  if (!solid) return;
  const outer = Math.hypot(1.14 * solid.radius, solid.halfLength);
  const scale = (0.49 * Math.min(width, height) * view.zoom) / outer;
  const placed = (point: Point3): Point3 => {
    const [right, up, depth] = view.seen(point);
    return [width / 2 + scale * right, height / 2 - scale * up, depth];
  };
  const trace = (points: Point3[], close: boolean): void => {
    context.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
    if (close) context.closePath();
  };
  const facet = (one: Facet): Drawn => {
    const points = one.corners.map(placed);
    const near = view.seen([...one.outward, 0])[2] > 0;
    const fill = one.of === 'top foil' ? rampColour(current, fractionIn(range, one.values[by])) : one.of === 'film' ? filmColour(current) : current.bumpFoil;
    const alpha = one.of === 'film' ? 0.5 : one.of === 'bump foil' ? (near ? 0.1 : 0.55) : near ? 0.12 : 1;
    return {
      layer: near ? nearest - layers[one.of] : layers[one.of],
      depth: points.reduce((sum, [, , depth]) => sum + depth, 0) / points.length,
      paint: () => {
        trace(points, true);
        context.globalAlpha = alpha;
        context.fillStyle = fill;
        context.fill();
        // Without seams between them.
        if (alpha === 1) {
          context.strokeStyle = fill;
          context.lineWidth = 0.8;
          context.stroke();
        }
      },
    };
  };
  const line = ({ points, of }: Solid['lines'][number]): Drawn[] =>
    points.slice(1).map((end, i) => {
      const piece = [placed(at(points, i)), placed(end)];
      const depth = 0.5 * (at(piece, 0)[2] + at(piece, 1)[2]);
      return {
        layer: of === 'journal' ? journalLayer : depth < 0 ? sleeveLayer : nearest + 1,
        depth,
        paint: () => {
          trace(piece, false);
          context.globalAlpha = of === 'journal' ? 0.75 : 1;
          context.strokeStyle = of === 'journal' ? current.muted : current.sleeve;
          context.lineWidth = of === 'journal' ? 1 : 2;
          context.stroke();
        },
      };
    });
  const drawn = [...solid.facets.map(facet), ...solid.lines.flatMap(line)].sort((a, b) => a.layer - b.layer || a.depth - b.depth);
  for (const one of drawn) one.paint();
  context.globalAlpha = 1;
  context.fillStyle = current.text;
  context.strokeStyle = current.text;
  context.font = `12px ${fontFamily}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  // Axes at the middle of the near end; the welds by name.
  const axes: [string, Point3][] = [['X', [0.34 * solid.radius, 0, 0]], ['Y', [0, 0.34 * solid.radius, 0]], ['Z', [0, 0, 1.25 * solid.halfLength]]];
  const origin = placed([0, 0, 0]);
  for (const [name, end] of axes) {
    const tip = placed(end);
    trace([origin, tip], false);
    context.lineWidth = 1.2;
    context.stroke();
    context.fillText(name, tip[0] + 8 * Math.sign(tip[0] - origin[0] || 1), tip[1] - 6);
  }
  solid.welds.forEach((weld, i) => {
    const [x, y] = placed(weld.map((one, axis) => (axis < 2 ? 1.1 * one : one)) as Point3);
    context.fillText(solid.welds.length > 1 ? `weld ${i + 1}` : 'weld', x, y);
  });
}

function csvOf(states: States, place: Place): string {
  const state = states.stateAt(place);
  const [phi, z] = [numbersOf(states, 'column_phi'), numbersOf(states, 'z')];
  const [owners, middles] = [numbersOf(states, 'column_pad'), numbersOf(states, 'pad_z')];
  const middle = (column: number): number => middles[(owners[column] ?? 1) - 1] ?? 0;
  const value = (name: string, row: number, column: number): number => states.variable(name)?.at({ state, row, column }) ?? NaN;
  return toCsv(
    ['phi_deg', 'z_m', 'pressure_Pa', 'film_thickness_m', 'film_top_displacement_m'],
    z.flatMap((across, row) => phi.map((angle, column) => [angle / degree, middle(column) + across, ...['pressure', 'film_thickness', 'film_top_displacement'].map((name) => value(name, row, column))])),
  );
}
