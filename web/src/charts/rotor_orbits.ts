import { arrowPath, pathOf, text, type Place as Spot } from '../bearing/drawing';
import { toCsv } from '../data/csv';
import { numbersOf, type Place } from '../data/grid';
import { orbitPoint, periodic, responseKinds, sliding, stuck, type Responses, type RotorOrbit } from '../data/responses';
import { at } from '../data/run';
import { formatQuantity } from '../data/units';
import { choice, svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { look, onLookChange, type Look } from '../ui/theme';
import { roundAbove } from './chart';

/** Of the drawing of one station, and of what is round it. */
const cell = 240;
const reach = 0.36 * cell;
const mostInRow = 2;
/** Letters are to be no larger where there is a single station. */
const leastInWidth = 2;
/** Part of a turn that is drawn: what is left tells the end from the start. */
const drawnTurn = 0.94;
const points = 120;

interface Kind {
  kind: number;
  colour: number;
  dash?: string;
}
const kinds: Kind[] = [{ kind: stuck, colour: 0 }, { kind: sliding, colour: 0, dash: '5 3' }, { kind: periodic, colour: 1 }];

/** What is drawn round a bearing, or as large as it fits. */
type View = 'clearance' | 'enlarged';

interface Drawn extends Kind {
  orbit: RotorOrbit;
}

interface Station {
  name: string;
  z: number;
  orbits: Drawn[];
}

function entry({ kind, colour, dash }: Kind): LegendEntry {
  return {
    width: 30,
    draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: at(current.series, colour), 'stroke-width': 2, ...(dash === undefined ? {} : { 'stroke-dasharray': dash }) })],
    text: at(responseKinds, kind),
  };
}

/** Orbits of the journals in their clearance, or of all stations enlarged, at the speed chosen, in true shape. */
export function rotorOrbits(responses: Responses, selection: GridSelection): HTMLElement {
  const root = svg('svg', { class: 'round', role: 'img' });
  let view: View = Number.isFinite(responses.clearance) ? 'clearance' : 'enlarged';
  const place = (): Place => ({ speed: selection.index(responses.speed) });
  const stations = (): Station[] => {
    const z = numbersOf(responses, 'station_z');
    const count = view === 'clearance' ? responses.bearings : responses.stations.length;
    return Array.from({ length: count }, (_, station) => ({
      name: responses.stations[station] ?? '',
      z: z[station] ?? NaN,
      orbits: kinds.flatMap((one): Drawn[] => {
        const orbit = responses.kinds.includes(one.kind) ? responses.orbitAt({ ...place(), kind: one.kind, station }) : undefined;
        return orbit ? [{ ...one, orbit }] : [];
      }),
    })).sort((a, b) => a.z - b.z);
  };
  const speedWords = (): string => responses.speed.texts[selection.index(responses.speed)] ?? '';
  const told = (): string => {
    const lasting = responses.lastingAt(place());
    const round = view === 'clearance' ? [`clearance ${formatQuantity(responses.clearance, 'm')}`] : [];
    return responses.shortfallAt(place()) || [speedWords(), ...round, ...(lasting === '' ? [] : [`the periodic orbit ${lasting}`])].join(', ');
  };
  const panel = new Panel(
    {
      title: 'Orbits',
      note: 'One turn, from the dot, where the rotor stands at angle 0, to the arrow.',
      controls: Number.isFinite(responses.clearance)
        ? [
            choice<View>(
              'Size of the orbits',
              [
                { value: 'clearance', text: 'In the clearance' },
                { value: 'enlarged', text: 'Enlarged' },
              ],
              view,
              (chosen) => {
                view = chosen;
                draw();
              },
            ),
          ]
        : [],
      subject: () => `${told()} · ${responses.label}`,
      legend: () => kinds.filter(({ kind }) => responses.kinds.includes(kind)).map(entry),
      file: () => fileName('orbits', responses.label, speedWords()),
      drawing: () => root,
      csv: () =>
        toCsv(
          ['station', 'kind', 'turn', 'x_m', 'y_m'],
          stations().flatMap(({ name, orbits }) =>
            orbits.flatMap(({ kind, orbit }) =>
              Array.from({ length: points + 1 }, (_, i) => {
                const { x, y } = orbitPoint(orbit, i / points);
                return [name, responses.variable('kind')?.words[kind], i / points, x, y];
              }),
            ),
          ),
        ),
    },
    root,
  );
  const draw = (): void => {
    const all = stations();
    const columns = Math.min(mostInRow, all.length);
    const width = Math.max(leastInWidth, columns) * cell;
    const left = (width - columns * cell) / 2;
    const size = extentOf(all, view, responses.clearance);
    root.setAttribute('viewBox', `0 0 ${width} ${Math.ceil(all.length / columns) * cell}`);
    root.replaceChildren(
      ...all.flatMap((station, i) => {
        const centre = { x: left + ((i % columns) + 0.5) * cell, y: (Math.floor(i / columns) + 0.46) * cell };
        return [...frame(station, responses.stations.length > 1, centre, size, view, responses.clearance, look()), ...station.orbits.flatMap((one) => orbitDrawing(one, centre, size, view, look()))];
      }),
    );
    panel.refresh();
    root.setAttribute('aria-label', `Orbits ${view === 'clearance' ? 'in the clearance' : 'enlarged'}: ${told()}`);
  };
  selection.onChange(draw);
  onLookChange(draw);
  draw();
  return panel.root;
}

/** Of an orbit, about its mean where it is enlarged. */
function pointsOf({ orbit }: Drawn, view: View): Spot[] {
  return Array.from({ length: points + 1 }, (_, i) => {
    const { x, y } = orbitPoint(orbit, (drawnTurn * i) / points);
    return view === 'clearance' ? { x, y } : { x: x - orbit.x.mean, y: y - orbit.y.mean };
  });
}

/** What is as long as `reach` on the drawing, m: journals may be pressed into the foils beyond the clearance. */
function extentOf(stations: Station[], view: View, clearance: number): number {
  const all = stations.flatMap(({ orbits }) => orbits.flatMap((one) => pointsOf(one, view)));
  const largest = Math.max(0, ...all.map(({ x, y }) => Math.hypot(x, y)));
  return view === 'clearance' ? Math.max(clearance, largest) : roundAbove(1e6 * largest) * 1e-6;
}

function frame({ name, z }: Station, several: boolean, centre: Spot, size: number, view: View, clearance: number, current: Look): SVGElement[] {
  const radius = (reach * (view === 'clearance' ? clearance : size)) / size;
  const line = (from: Spot, to: Spot): SVGElement =>
    svg('path', { d: pathOf([from, to].map(({ x, y }) => ({ x: centre.x + 1.12 * reach * x, y: centre.y - 1.12 * reach * y }))), stroke: current.grid, 'stroke-width': 1 });
  const along = `, z = ${formatQuantity(z, 'm', 3)}`;
  return [
    line({ x: -1, y: 0 }, { x: 1, y: 0 }),
    line({ x: 0, y: -1 }, { x: 0, y: 1 }),
    svg('circle', { cx: centre.x, cy: centre.y, r: radius, fill: 'none', stroke: view === 'clearance' ? current.sleeve : current.line, 'stroke-width': view === 'clearance' ? 2 : 1 }),
    text({ x: centre.x + 1.16 * reach, y: centre.y + 4 }, 'X', current),
    text({ x: centre.x - 3, y: centre.y - 1.17 * reach }, 'Y', current),
    // Between the axes, outside of the circle.
    ...(view === 'enlarged' ? [text({ x: centre.x + 0.72 * radius + 4, y: centre.y + 0.72 * radius + 12 }, formatQuantity(size, 'm', 2), current)] : []),
    ...(several ? [text({ x: centre.x, y: centre.y + 0.5 * cell }, `${name}${along}`, current, { 'text-anchor': 'middle' })] : []),
  ];
}

function orbitDrawing(drawn: Drawn, centre: Spot, size: number, view: View, current: Look): SVGElement[] {
  const spots = pointsOf(drawn, view).map(({ x, y }) => ({ x: centre.x + (reach * x) / size, y: centre.y - (reach * y) / size }));
  const colour = at(current.series, drawn.colour);
  const [start, before, end] = [at(spots, 0), at(spots, spots.length - 6), at(spots, spots.length - 1)];
  return [
    svg('path', { d: pathOf(spots), fill: 'none', stroke: colour, 'stroke-width': 2, 'stroke-linejoin': 'round', ...(drawn.dash === undefined ? {} : { 'stroke-dasharray': drawn.dash }) }),
    svg('path', { d: arrowPath(before, end, 2.6), fill: colour }),
    svg('circle', { cx: start.x, cy: start.y, r: view === 'clearance' ? 2.2 : 3.6, fill: colour }),
  ];
}
