import { arrowPath, pathOf, text, type Place as Spot } from '../bearing/drawing';
import { toCsv } from '../data/csv';
import { numbersOf } from '../data/grid';
import { formatNumber, formatQuantity } from '../data/units';
import type { Whirls } from '../data/whirls';
import { svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { look, onLookChange, type Look } from '../ui/theme';

const radians = Math.PI / 180;
/** Of the drawing of one station, and of the largest orbit in it. */
const cell = 220;
const reach = 0.36 * cell;
const mostInRow = 4;
/** Letters are to be no larger where there is a single station. */
const leastInWidth = 2;
/** Part of a turn that is drawn: what is left tells the end from the start. */
const drawnTurn = 0.92;

interface Station {
  name: string;
  z: number;
  amplitudes: [number, number];
  phases: [number, number];
}

/** Along the axis. */
function stationsOf(whirls: Whirls, place: Record<string, number>): Station[] {
  const bearings = whirls.size('bearing');
  const z = numbersOf(whirls, 'station_z');
  const both = (name: string, station: number): [number, number] => [whirls.numberAt(`${name}_x`, { ...place, station }), whirls.numberAt(`${name}_y`, { ...place, station })];
  return z
    .map((along, station) => ({ name: station < bearings ? `bearing ${station + 1}` : `station ${station + 1}`, z: along, amplitudes: both('shape_amplitude', station), phases: both('shape_phase', station) }))
    .sort((a, b) => a.z - b.z);
}

/** Displacements of the station at parts of a turn, over the largest of the motion. */
function orbitOf({ amplitudes, phases }: Station): Spot[] {
  const points = 90;
  return Array.from({ length: points + 1 }, (_, i) => {
    const angle = (2 * Math.PI * drawnTurn * i) / points;
    return { x: amplitudes[0] * Math.cos(angle + phases[0] * radians), y: amplitudes[1] * Math.cos(angle + phases[1] * radians) };
  });
}

/** Orbits of the stations of a rotor in the motion and at the speed chosen, in true shape. */
export function modeShape(whirls: Whirls, selection: GridSelection): HTMLElement {
  const root = svg('svg', { class: 'round', role: 'img' });
  const found = (): boolean => Number.isFinite(whirls.growthRateAt(selection.place));
  const where = (): string =>
    [whirls.motion, whirls.contacts, whirls.speed].map((one) => one.texts[selection.index(one)] ?? '').filter((words) => words !== '').join(', ');
  const caption = (): string => {
    const { place } = selection;
    if (!found()) return whirls.shortfallAt(place) || 'no such motion there';
    const of = whirls.numberAt('of_foils', place) === 1 ? 'foils' : 'rotor';
    return `${formatQuantity(whirls.numberAt('imag', place), 'rad/s')}, growth rate ${formatNumber(whirls.growthRateAt(place))} 1/s, ${whirls.wordAt('direction', place)} whirl of the ${of}`;
  };
  const panel = new Panel(
    {
      title: 'Mode shape',
      note: 'Orbits in one turn without growth, from the dot to the arrow.',
      subject: () => [caption(), where(), whirls.label].join(' · '),
      file: () => fileName('mode-shape', whirls.label, where()),
      drawing: () => root,
      csv: () =>
        toCsv(
          ['station', 'z_m', 'shape_amplitude_x', 'shape_phase_x_deg', 'shape_amplitude_y', 'shape_phase_y_deg'],
          stationsOf(whirls, selection.place).map(({ name, z, amplitudes, phases }) => [name, z, amplitudes[0], phases[0], amplitudes[1], phases[1]]),
        ),
    },
    root,
  );
  const draw = (): void => {
    const stations = stationsOf(whirls, selection.place);
    const columns = Math.min(mostInRow, stations.length);
    const width = Math.max(leastInWidth, columns) * cell;
    const left = (width - columns * cell) / 2;
    root.setAttribute('viewBox', `0 0 ${width} ${Math.ceil(stations.length / columns) * cell}`);
    root.replaceChildren(...stations.flatMap((station, i) => stationDrawing(station, { x: left + ((i % columns) + 0.5) * cell, y: (Math.floor(i / columns) + 0.5) * cell }, stations.length > 1, found(), look())));
    panel.refresh();
    root.setAttribute('aria-label', `Mode shape: ${caption()}; ${where()}`);
  };
  selection.onChange(draw);
  onLookChange(draw);
  draw();
  return panel.root;
}

function stationDrawing(station: Station, centre: Spot, several: boolean, found: boolean, current: Look): SVGElement[] {
  const spot = ({ x, y }: Spot): Spot => ({ x: centre.x + reach * x, y: centre.y - reach * y });
  const line = (from: Spot, to: Spot): SVGElement => svg('path', { d: pathOf([spot(from), spot(to)]), stroke: current.grid, 'stroke-width': 1 });
  const frame = [
    line({ x: -1.1, y: 0 }, { x: 1.1, y: 0 }),
    line({ x: 0, y: -1.1 }, { x: 0, y: 1.1 }),
    text(spot({ x: 1.14, y: -0.05 }), 'X', current),
    text(spot({ x: 0.05, y: 1.08 }), 'Y', current),
    ...(several ? [text({ x: centre.x, y: centre.y + cell / 2 - 8 }, `${station.name}, z = ${formatQuantity(station.z, 'm', 3)}`, current, { 'text-anchor': 'middle' })] : []),
  ];
  if (!found) return frame;
  const points = orbitOf(station).map(spot);
  const [start, before, end] = [points[0], points[points.length - 4], points[points.length - 1]];
  if (!start || !before || !end) return frame;
  return [
    ...frame,
    svg('path', { d: pathOf(points), fill: 'none', stroke: current.accent, 'stroke-width': 2.2, 'stroke-linejoin': 'round' }),
    svg('path', { d: arrowPath(before, end, 3), fill: current.accent }),
    svg('circle', { cx: start.x, cy: start.y, r: 3.6, fill: current.text }),
  ];
}
