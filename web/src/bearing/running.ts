import { toCsv } from '../data/csv';
import { numbersOf } from '../data/grid';
import type { GridData } from '../data/format';
import { largest, type Cycle } from '../data/run';
import type { States } from '../data/states';
import { formatQuantity } from '../data/units';
import { svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { look, onLookChange, type Look } from '../ui/theme';
import { arrowPath, letters, pathOf, text, type Place } from './drawing';
import { gradingOf } from './foil_lines';
import { BearingGeometry } from './geometry';
import { marks } from './panel';
import { drawRound } from './round';
import { fittingAlong, fittingInwards, shapeAt } from './shape';
import { spaceView } from './space';

/** A drawing of the state that the reader looks at, redrawn with it. */
function drawnPanel(
  states: States,
  selection: GridSelection,
  contents: { title: string; what: string; caption: () => string; legend: () => LegendEntry[]; csv: () => string; draw: (root: SVGSVGElement, current: Look, shown: number) => void },
): HTMLElement {
  const root = svg('svg', { class: 'round', role: 'img' });
  const where = (): string => selection.textAt(selection.place);
  const panel = new Panel(
    {
      title: contents.title,
      subject: () => [contents.caption(), where(), states.label].filter((words) => words !== '').join(' · '),
      legend: contents.legend,
      file: () => fileName(contents.what, states.label, where()),
      drawing: () => root,
      csv: contents.csv,
    },
    root,
  );
  const draw = (): void => {
    contents.draw(root, look(), Math.min(root.clientWidth, root.clientHeight));
    panel.refresh();
    root.setAttribute('aria-label', `${contents.title}: ${contents.caption()}; ${where()}`);
  };
  selection.onChange(draw);
  onLookChange(draw);
  draw();
  // Letters fit the size on the screen, which is not known before.
  new ResizeObserver(draw).observe(root);
  return panel.root;
}

/** What the bearing is drawn from. */
interface Drawn {
  data: GridData;
  cycle: Cycle;
  geometry: BearingGeometry;
  inwards: number;
  largestForce: number;
}

function drawnOf(states: States): Drawn | undefined {
  const run = states.bearing;
  const cycle = run?.cycles[0];
  if (!run || !cycle) return undefined;
  const geometry = new BearingGeometry(run);
  return { data: states.data, cycle, geometry, inwards: fittingInwards(geometry), largestForce: largest(cycle.field('normal_force_bump_sleeve').values) || 1 };
}

/** Foils and cycle of the states as they are, found once for each of them; nothing without foils. */
function drawnOnce(states: States): () => Drawn | undefined {
  let drawn = drawnOf(states);
  return () => (drawn?.data === states.data ? drawn : (drawn = drawnOf(states)));
}

/** The bearing in three dimensions. */
export function bearingInSpace(states: States, selection: GridSelection): HTMLElement[] {
  return spaceView(states, selection, drawnOnce(states));
}

/** The journal among the foils at the state; nothing without foils. */
export function runningBearing(states: States, selection: GridSelection): HTMLElement[] {
  const current = drawnOnce(states);
  if (!current()) return [];
  let stretch = 1;
  return [
    drawnPanel(states, selection, {
      title: 'Bearing in operation',
      what: 'bearing',
      caption: () => {
        const { place } = selection;
        if (!states.isFound(place)) return 'no state found';
        const [x, y] = ['x', 'y'].map((name) => formatQuantity(states.numberAt(name, place), 'm', 3));
        const times = (factor: number): string => `×${Number(factor.toPrecision(2))}`;
        const bearing = current();
        const scales = `displacements and gaps ${times(stretch * (bearing?.inwards ?? 1))}, height of bumps ${times(stretch)} true scale`;
        const grading = bearing ? gradingOf(bearing.geometry) : '';
        return [`journal at (${x ?? ''}, ${y ?? ''})`, scales, grading].filter((words) => words !== '').join(', ');
      },
      legend: () => [
        { width: 26, draw: (current) => [svg('path', { d: arrowPath({ x: 1, y: 6 }, { x: 25, y: 6 }), fill: current.force })], text: 'force of the sleeve on a foot' },
        { width: 26, draw: (current) => [svg('path', { d: arrowPath({ x: 1, y: 6 }, { x: 25, y: 6 }, 3), fill: current.accent })], text: 'applied force' },
        ...marks,
      ],
      csv: () =>
        toCsv(
          ['bump', 'crest_outward_m', 'top_foil_outward_m', 'load_N'],
          numbersOf(states, 'bump').map((bump, i) => [bump, ...['crest_v', 'top_displacement', 'normal_force_top_bump'].map((name) => states.along(name, 'bump', selection.place)[i])]),
        ),
      draw: (root, colours, shown) => {
        const index = states.stateAt(selection.place);
        root.replaceChildren();
        const bearing = current();
        if (!bearing || !states.isFound(selection.place)) return;
        const { cycle, geometry, inwards, largestForce } = bearing;
        const shape = shapeAt(geometry, cycle, index);
        stretch = drawRound(root, { geometry, cycle, index, shape, inwards, along: fittingAlong(geometry), largestForce, forces: true, bump: undefined }, colours, shown);
      },
    }),
  ];
}

const size = 480;
const centre = size / 2;
/** Of the circle that ambient pressure lies on, and how far the largest pressure and film thickness reach from it. */
const circle = 128;
const reach = 88;

/** Pressure in the mid-plane outwards, film thickness inwards, around the journal. */
export function polarPlot(states: States, selection: GridSelection): HTMLElement {
  const angles = (): number[] => numbersOf(states, 'column_phi');
  const pressure = (): number[] => {
    const state = states.stateAt(selection.place);
    const ambient = states.variable('ambient_pressure')?.at({}) ?? NaN;
    return angles().map((_, column) => (state < 0 ? NaN : (states.variable('pressure')?.at({ state, row: states.midRow, column }) ?? NaN) - ambient));
  };
  const film = (): number[] => states.along('film_thickness', 'column', selection.place);
  const onCircle = (angle: number, radius: number): Place => ({ x: centre + radius * Math.cos(angle), y: centre - radius * Math.sin(angle) });
  const around = (values: number[], perUnit: number): Place[] => angles().map((angle, i) => onCircle(angle, circle + (values[i] ?? 0) * perUnit));
  return drawnPanel(states, selection, {
    title: 'Film around the journal',
    what: 'film-polar',
    caption: () =>
      states.isFound(selection.place)
        ? `gauge pressure in the mid-plane up to ${formatQuantity(Math.max(...pressure()), 'Pa')}; film up to ${formatQuantity(largest(film()), 'm')} thick`
        : 'no state found',
    legend: () => [
      { width: 26, draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 26, y2: 6, stroke: current.friction, 'stroke-width': 2.4 })], text: 'gauge pressure, outwards' },
      { width: 26, draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 26, y2: 6, stroke: current.accent, 'stroke-width': 2.4, 'stroke-dasharray': '6 3' })], text: 'film thickness, inwards' },
      { width: 26, draw: (current) => [svg('path', { d: arrowPath({ x: 1, y: 6 }, { x: 25, y: 6 }, 3), fill: current.text })], text: 'applied force' },
    ],
    csv: () => {
      const [p, h] = [pressure(), film()];
      return toCsv(['phi_deg', 'gauge_pressure_Pa', 'film_thickness_m'], angles().map((angle, i) => [(angle * 180) / Math.PI, p[i], h[i]]));
    },
    draw: (root, current, shown) => {
      const font = { 'font-size': letters(size, shown) };
      root.setAttribute('viewBox', `0 0 ${size} ${size}`);
      const found = states.isFound(selection.place);
      const [p, h] = [pressure(), film()];
      const force = ['force_x', 'force_y'].map((name) => states.numberAt(name, selection.place));
      const length = Math.hypot(force[0] ?? 0, force[1] ?? 0) || 1;
      const tip = { x: centre + (0.25 * circle * (force[0] ?? 0)) / length, y: centre - (0.25 * circle * (force[1] ?? 0)) / length };
      const pads = states.padColumns;
      const ofPads = (points: Place[]): string => pads.map((pad) => pathOf(points.slice(pad.first, pad.first + pad.angles.length))).join('');
      root.replaceChildren(
        svg('circle', { cx: centre, cy: centre, r: circle, fill: 'none', stroke: current.muted, 'stroke-width': 1 }),
        ...[0, 0.5, 1, 1.5].map((turn) => {
          const [from, to] = [circle - reach, circle + reach].map((radius) => onCircle(turn * Math.PI, radius));
          return svg('line', { x1: from?.x ?? 0, y1: from?.y ?? 0, x2: to?.x ?? 0, y2: to?.y ?? 0, stroke: current.grid, 'stroke-width': 1 });
        }),
        text(onCircle(0, circle + reach + 8), 'X', current, font),
        text(onCircle(Math.PI / 2, circle + reach + 6), 'Y', current, { ...font, 'text-anchor': 'middle' }),
        ...(found
          ? [
              svg('path', { d: ofPads(around(p, reach / largest(p))), fill: 'none', stroke: current.friction, 'stroke-width': 2.4, 'stroke-linejoin': 'round' }),
              svg('path', { d: ofPads(around(h, -reach / largest(h))), fill: 'none', stroke: current.accent, 'stroke-width': 2.4, 'stroke-dasharray': '6 3', 'stroke-linejoin': 'round' }),
              svg('path', { d: arrowPath({ x: centre, y: centre }, tip, 3), fill: current.text }),
            ]
          : []),
        ...pads.flatMap(({ name, first }) => {
          const weld = angles()[first] ?? 0;
          return [
            svg('path', { d: pathOf([onCircle(weld, circle - 7), onCircle(weld, circle + 7)]), stroke: current.topFoil, 'stroke-width': 3.4 }),
            text(onCircle(weld, circle + reach + 12), name === '' ? 'weld' : `weld of ${name}`, current, { ...font, 'text-anchor': Math.cos(weld) < -0.5 ? 'start' : 'middle', 'font-weight': 'bold' }),
          ];
        }),
      );
    },
  });
}
