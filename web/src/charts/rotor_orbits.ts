import { toCsv } from '../data/csv';
import { numbersOf, type Place } from '../data/grid';
import { orbitPoint, periodic, responseKinds, sliding, stuck, type Responses, type RotorOrbit } from '../data/responses';
import { at } from '../data/run';
import { formatQuantity } from '../data/units';
import type { GridSelection } from '../ui/grid_selection';
import { fileName } from '../ui/save';
import { orbitEntry, OrbitPanel, type OrbitLook, type OrbitStation, type OrbitView } from './orbit_panel';

/** Part of a turn that is drawn: what is left tells the end from the start. */
const drawnTurn = 0.94;
const points = 120;

interface Kind extends OrbitLook {
  kind: number;
}
const kinds: Kind[] = [
  { kind: stuck, colour: ({ series }) => at(series, 0) },
  { kind: sliding, colour: ({ series }) => at(series, 0), dash: '5 3' },
  { kind: periodic, colour: ({ series }) => at(series, 1) },
];

/** Orbits of the journals in their clearance, or of all stations enlarged, at the speed chosen, in true shape. */
export function rotorOrbits(responses: Responses, selection: GridSelection): HTMLElement {
  const { clearance, label } = responses;
  const place = (): Place => ({ speed: selection.index(responses.speed) });
  const orbitsAt = (station: number): { kind: Kind; orbit: RotorOrbit }[] =>
    kinds.flatMap((kind) => {
      const orbit = responses.kinds.includes(kind.kind) ? responses.orbitAt({ ...place(), kind: kind.kind, station }) : undefined;
      return orbit ? [{ kind, orbit }] : [];
    });
  const order = numbersOf(responses, 'station_z')
    .map((z, station) => ({ station, z, name: responses.stations[station] ?? '' }))
    .sort((a, b) => a.z - b.z);
  const stations = (view: OrbitView): OrbitStation[] =>
    order
      .filter(({ station }) => view === 'enlarged' || station < responses.bearings)
      .map(({ station, z, name }) => ({
        name,
        z,
        orbits: orbitsAt(station).map(({ kind, orbit }) => ({
          ...kind,
          points: Array.from({ length: points + 1 }, (_, i) => orbitPoint(orbit, (drawnTurn * i) / points)),
          centre: { x: orbit.x.mean, y: orbit.y.mean },
        })),
      }));
  const speedWords = (): string => responses.speed.texts[selection.index(responses.speed)] ?? '';
  const panel = new OrbitPanel({
    note: 'One turn, from the dot, where the rotor is at angle 0, to the arrow.',
    clearance,
    stations,
    several: responses.stations.length > 1,
    caption: (view) => {
      const lasting = responses.lastingAt(place());
      const round = view === 'clearance' ? [`clearance ${formatQuantity(clearance, 'm')}`] : [];
      return responses.shortfallAt(place()) || [speedWords(), ...round, ...(lasting === '' ? [] : [`the periodic orbit ${lasting}`])].join(', ');
    },
    label,
    legend: () => kinds.filter(({ kind }) => responses.kinds.includes(kind)).map((one) => orbitEntry(one, at(responseKinds, one.kind))),
    file: () => fileName('orbits', label, speedWords()),
    csv: () =>
      toCsv(
        ['station', 'kind', 'turn', 'x_m', 'y_m'],
        order.flatMap(({ station, name }) =>
          orbitsAt(station).flatMap(({ kind, orbit }) =>
            Array.from({ length: points + 1 }, (_, i) => {
              const { x, y } = orbitPoint(orbit, i / points);
              return [name, responses.variable('kind')?.words[kind.kind], i / points, x, y];
            }),
          ),
        ),
      ),
  });
  selection.onChange(() => panel.draw());
  return panel.root;
}
