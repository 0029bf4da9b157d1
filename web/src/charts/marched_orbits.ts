/** Orbits of a rotor in time, revolution by revolution. */
import { toCsv } from '../data/csv';
import { numbersOf } from '../data/grid';
import { at, largest } from '../data/run';
import { speedText } from '../data/states';
import type { TimeRun } from '../data/time_run';
import { formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import { playback } from '../ui/playback';
import { fileName } from '../ui/save';
import { journalEntry, orbitEntry, OrbitPanel, type DrawnOrbit, type OrbitLook, type OrbitStation, type OrbitView } from './orbit_panel';

/** A revolution is played in as long, ms, and the whole run in no longer than the other. */
const playedRevolution = 700;
const playedRun = 60_000;

const shown: OrbitLook = { colour: ({ series }) => at(series, 0) };
/** The revolutions before it, the next one first: an orbit of whirl at half of the speed closes after two. */
const before: OrbitLook[] = [
  { colour: ({ muted }) => muted, width: 1.1 },
  { colour: ({ line }) => line, width: 1.1 },
];
/** In the clearance, from the first revolution to the last: means of two that follow each other, which whirl at half of the speed does not move. */
const means: OrbitLook = { colour: ({ series }) => at(series, 1), width: 1.2 };

/** Journals in their clearance or all stations enlarged, at the revolution chosen, moved by a slider. */
export function marchedOrbits(run: TimeRun, selection: GridSelection): HTMLElement {
  const last = run.orbits.length - 1;
  let orbit = last;
  let step = run.orbit(last).first + run.orbit(last).steps - 1;
  const order = numbersOf(run, 'station_z')
    .map((z, station) => ({ station, z, name: run.station.texts[station] ?? '' }))
    .sort((a, b) => a.z - b.z);
  const orbitsAt = (station: number): DrawnOrbit[] => {
    const now = run.orbit(orbit);
    const points = run.pointsOf(now, station);
    const centre = run.meanOf(points);
    const past = before.flatMap((look, i) => {
      const one = run.orbits[orbit - 1 - i];
      return one?.revolution === now.revolution - 1 - i ? [{ ...look, points: run.pointsOf(one, station), centre }] : [];
    });
    return [...past.reverse(), { ...shown, points, centre }];
  };
  const meansAt = (station: number): DrawnOrbit[] => {
    const mean = (name: string, revolution: number): number => 0.5 * (run.numberAt(name, { revolution, station }) + run.numberAt(name, { revolution: revolution + 1, station }));
    const points = [...run.numbers.keys()].slice(1).map((_, revolution) => ({ x: mean('mean_x', revolution), y: mean('mean_y', revolution) }));
    return points.length > 1 ? [{ ...means, points, centre: at(points, 0) }] : [];
  };
  // The size of the drawing is that of all orbits: they are to be seen to grow.
  const extents = { clearance: 0, enlarged: 0 };
  for (const one of run.orbits) {
    for (const { station } of order) {
      const points = run.pointsOf(one, station);
      const centre = run.meanOf(points);
      if (station < run.bearings) extents.clearance = Math.max(extents.clearance, largest(points.map(({ x, y }) => Math.hypot(x, y))));
      extents.enlarged = Math.max(extents.enlarged, largest(points.map(({ x, y }) => Math.hypot(x - centre.x, y - centre.y))));
    }
  }
  let drawn: { orbit: number; view: OrbitView; lines: OrbitStation[] } | undefined;
  const stations = (view: OrbitView): OrbitStation[] => {
    if (drawn?.orbit !== orbit || drawn.view !== view) {
      const lines = order.filter(({ station }) => view === 'enlarged' || station < run.bearings).map(({ station, z, name }) => ({ name, z, orbits: [...(view === 'clearance' ? meansAt(station) : []), ...orbitsAt(station)] }));
      drawn = { orbit, view, lines };
    }
    const all = order.filter(({ station }) => view === 'enlarged' || station < run.bearings);
    return drawn.lines.map((one, i) => ({ ...one, journal: { at: run.pointAt(step, at(all, i).station), centre: at(one.orbits, one.orbits.length - 1).centre } }));
  };
  const revolutionWords = (): string => {
    const { revolution } = run.orbit(orbit);
    return revolution <= run.summary.revolutions ? `revolution ${revolution} of ${run.summary.revolutions}` : `revolution ${revolution}, not completed`;
  };
  const caption = (view: OrbitView): string => {
    const speed = speedText(Math.abs(run.numberAt('speed', { step: run.orbit(orbit).first + run.orbit(orbit).steps - 1 })));
    return [revolutionWords(), speed, ...(view === 'clearance' ? [`clearance ${formatQuantity(run.clearance, 'm')}`] : [])].join(', ');
  };
  const readout = el('output', {});
  const { slider, play, refresh } = playback({
    size: () => run.size('step'),
    index: () => step,
    show: (index) => lead(index),
    duration: () => Math.min(playedRun, playedRevolution * run.orbits.length),
    of: () => run,
    changed: () => follow(),
    words: { slider: 'Step of the run', play: 'Play the run' },
  });
  const panel = new OrbitPanel({
    note: 'From the dot, where the rotor is at angle 0, to the arrow.',
    clearance: run.clearance,
    stations,
    several: order.length > 1,
    caption,
    label: run.label,
    extent: (view) => extents[view],
    legend: (view) => [orbitEntry(shown, 'this revolution'), ...before.slice(0, last).map((one, i) => orbitEntry(one, i === 0 ? 'the one before' : 'two before')), journalEntry, ...(view === 'clearance' && run.numbers.length > 1 ? [orbitEntry(means, 'mean position of all revolutions')] : [])],
    file: () => fileName('orbits', run.label, `revolution-${run.orbit(orbit).revolution}`),
    csv: () => {
      const { first, steps } = run.orbit(orbit);
      return toCsv(
        ['station', 'time_s', 'x_m', 'y_m'],
        order.flatMap(({ station, name }) => Array.from({ length: steps }, (_, i) => [name, run.numberAt('time', { step: first + i }), ...Object.values(run.pointAt(first + i, station))])),
      );
    },
    foot: [el('div', { class: 'steps', role: 'group', 'aria-label': 'Position in the run' }, play, slider, readout)],
  });
  const follow = (): void => {
    refresh();
    const films = Array.from({ length: run.bearings }, (_, bearing) => run.numberAt('h_min', { step, bearing }));
    const text = `revolution ${run.orbit(orbit).revolution} · ${formatQuantity(run.numberAt('time', { step }), 's')} · ${speedText(Math.abs(run.numberAt('speed', { step })))} · film ${formatQuantity(Math.min(...films), 'm')}`;
    readout.textContent = text;
    slider.setAttribute('aria-valuetext', text);
  };
  const show = (index: number, of: number): void => {
    step = index;
    if (of === orbit) panel.move();
    else {
      orbit = of;
      panel.draw();
    }
    follow();
  };
  let leading = false;
  const lead = (index: number): void => {
    const of = run.orbitOfStep(index);
    const other = of !== orbit;
    show(index, of);
    if (!other) return;
    leading = true;
    selection.show({ place: { revolution: run.indexOfRevolution(run.orbit(of).revolution) } });
    leading = false;
  };
  selection.onChange(() => {
    const revolution = run.numbers[selection.index(run.revolution)];
    if (leading || revolution === undefined) return;
    // Where its own orbit is left out, the one next to it.
    const near = run.orbitNear(revolution);
    if (near !== orbit) show(run.orbit(near).first + run.orbit(near).steps - 1, near);
  });
  follow();
  return panel.root;
}
