/** Orbits of a rotor at its stations, in the plane of each: in the clearance of its bearing, or enlarged. */
import { arrowPath, pathOf, text, type Place as Spot } from '../bearing/drawing';
import { at, largest } from '../data/run';
import { formatQuantity } from '../data/units';
import { choice, svg, type Child } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { Panel, type PanelContents } from '../ui/panel';
import { look, onLookChange, type Look } from '../ui/theme';
import { roundAbove } from './chart';

/** Of the drawing of one station, and of what is round it. */
const cell = 240;
const reach = 0.36 * cell;
const mostInRow = 2;
/** Letters are to be no larger where there is a single station. */
const leastInWidth = 2;

/** What is drawn round a bearing, or as large as it fits. */
export type OrbitView = 'clearance' | 'enlarged';

export interface OrbitLook {
  colour: (current: Look) => string;
  dash?: string;
  width?: number;
}

/** One turn: points in m, and what they are drawn about where they are enlarged. */
export interface DrawnOrbit extends OrbitLook {
  points: Spot[];
  centre: Spot;
}

export interface OrbitStation {
  name: string;
  z: number;
  orbits: DrawnOrbit[];
  /** Where the axis of the journal is, m, and what it is drawn about where it is enlarged. */
  journal?: { at: Spot; centre: Spot };
}

export interface OrbitContents extends Pick<PanelContents, 'note' | 'file' | 'csv'> {
  /** Radial clearance, m; not a number where there is none for all bearings: orbits are enlarged then. */
  clearance: number;
  /** In the order of the rotor; in the clearance those that are bearings. */
  stations: (view: OrbitView) => OrbitStation[];
  /** Whether the rotor has several stations, be they shown or not. */
  several: boolean;
  /** What is shown, such as the speed. */
  caption: (view: OrbitView) => string;
  label: string;
  legend: (view: OrbitView) => LegendEntry[];
  /** Of the orbits that are enlarged, about their centres, m; those drawn where it is not given. */
  extent?: (view: OrbitView) => number;
  /** Under the drawing. */
  foot?: Child[];
}

function spotsOf(points: Spot[], about: Spot, view: OrbitView): Spot[] {
  return view === 'clearance' ? points : points.map(({ x, y }) => ({ x: x - about.x, y: y - about.y }));
}

/** How far from the middle of the drawing they reach, m. */
function extentOf(stations: OrbitStation[], view: OrbitView): number {
  return largest(...stations.flatMap(({ orbits }) => orbits.map(({ points, centre }) => spotsOf(points, centre, view).map(({ x, y }) => Math.hypot(x, y)))));
}

export function orbitEntry({ colour, dash, width = 2 }: OrbitLook, words: string): LegendEntry {
  return {
    width: 30,
    draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: colour(current), 'stroke-width': width, ...(dash === undefined ? {} : { 'stroke-dasharray': dash }) })],
    text: words,
  };
}

function journalMark(current: Look, r: number): SVGElement {
  return svg('circle', { class: 'journal', cy: 6, cx: 6, r, fill: current.text, stroke: current.background, 'stroke-width': 1.5 });
}

export const journalEntry: LegendEntry = { width: 12, draw: (current) => [journalMark(current, 5)], text: 'axis of the journal' };

/** `draw` is to be called when what is shown has changed, `move` where it is the journals alone. */
export class OrbitPanel {
  readonly root: HTMLElement;
  private readonly drawing = svg('svg', { class: 'round', role: 'img' });
  private readonly panel: Panel;
  private view: OrbitView;
  private size = 1;
  private journals: { mark: SVGElement; centre: Spot; station: number }[] = [];

  constructor(private readonly contents: OrbitContents) {
    const { clearance, note, legend, file, csv, foot = [] } = contents;
    const hasClearance = Number.isFinite(clearance);
    this.view = hasClearance ? 'clearance' : 'enlarged';
    const views: { value: OrbitView; text: string }[] = [
      { value: 'clearance', text: 'In the clearance' },
      { value: 'enlarged', text: 'Enlarged' },
    ];
    const chooser = choice('Size of the orbits', views, this.view, (chosen) => {
      this.view = chosen;
      this.draw();
    });
    this.panel = new Panel(
      {
        title: 'Orbits',
        ...(note === undefined ? {} : { note }),
        controls: hasClearance ? [chooser] : [],
        subject: () => `${contents.caption(this.view)} · ${contents.label}`,
        legend: () => legend(this.view),
        file,
        drawing: () => this.drawing,
        csv,
      },
      this.drawing,
      ...foot,
    );
    this.root = this.panel.root;
    onLookChange(() => this.draw());
    this.draw();
  }

  draw(): void {
    const { contents, view } = this;
    const stations = contents.stations(view);
    const columns = Math.min(mostInRow, stations.length);
    const width = Math.max(leastInWidth, columns) * cell;
    const left = (width - columns * cell) / 2;
    const extent = contents.extent?.(view) ?? extentOf(stations, view);
    // Journals may be pressed into the foils beyond the clearance.
    this.size = view === 'clearance' ? Math.max(contents.clearance, extent) : roundAbove(1e6 * extent) * 1e-6;
    this.drawing.setAttribute('viewBox', `0 0 ${width} ${Math.ceil(stations.length / columns) * cell}`);
    this.journals = [];
    this.drawing.replaceChildren(
      ...stations.flatMap((station, i) => {
        const centre = { x: left + ((i % columns) + 0.5) * cell, y: (Math.floor(i / columns) + 0.46) * cell };
        return [...this.frame(station, centre, look()), ...station.orbits.flatMap((one) => this.orbit(one, centre, look())), ...this.journal(station, i, centre, look())];
      }),
    );
    this.move();
    this.panel.refresh();
    this.drawing.setAttribute('aria-label', `Orbits ${view === 'clearance' ? 'in the clearance' : 'enlarged'}: ${contents.caption(view)}`);
  }

  move(): void {
    if (this.journals.length === 0) return;
    const stations = this.contents.stations(this.view);
    for (const { mark, centre, station } of this.journals) {
      const journal = stations[station]?.journal;
      if (!journal) continue;
      const { x, y } = this.place(at(spotsOf([journal.at], journal.centre, this.view), 0), centre);
      mark.setAttribute('cx', x.toFixed(2));
      mark.setAttribute('cy', y.toFixed(2));
    }
  }

  private place({ x, y }: Spot, centre: Spot): Spot {
    return { x: centre.x + (reach * x) / this.size, y: centre.y - (reach * y) / this.size };
  }

  private frame({ name, z }: OrbitStation, centre: Spot, current: Look): SVGElement[] {
    const { view, size, contents } = this;
    const inClearance = view === 'clearance';
    const radius = (reach * (inClearance ? contents.clearance : size)) / size;
    const line = (from: Spot, to: Spot): SVGElement =>
      svg('path', { d: pathOf([from, to].map(({ x, y }) => ({ x: centre.x + 1.12 * reach * x, y: centre.y - 1.12 * reach * y }))), stroke: current.grid, 'stroke-width': 1 });
    return [
      line({ x: -1, y: 0 }, { x: 1, y: 0 }),
      line({ x: 0, y: -1 }, { x: 0, y: 1 }),
      svg('circle', { cx: centre.x, cy: centre.y, r: radius, fill: 'none', stroke: inClearance ? current.sleeve : current.line, 'stroke-width': inClearance ? 2 : 1 }),
      text({ x: centre.x + 1.16 * reach, y: centre.y + 4 }, 'X', current),
      text({ x: centre.x - 3, y: centre.y - 1.17 * reach }, 'Y', current),
      // Between the axes, outside of the circle.
      ...(inClearance ? [] : [text({ x: centre.x + 0.72 * radius + 4, y: centre.y + 0.72 * radius + 12 }, formatQuantity(size, 'm', 2), current)]),
      ...(contents.several ? [text({ x: centre.x, y: centre.y + 0.5 * cell }, `${name}, z = ${formatQuantity(z, 'm', 3)}`, current, { 'text-anchor': 'middle' })] : []),
    ];
  }

  private orbit({ points, centre: about, colour, dash, width = 2 }: DrawnOrbit, centre: Spot, current: Look): SVGElement[] {
    const spots = spotsOf(points, about, this.view).map((spot) => this.place(spot, centre));
    if (spots.length < 2) return [];
    const fill = colour(current);
    const [start, before, end] = [at(spots, 0), at(spots, Math.max(0, spots.length - 6)), at(spots, spots.length - 1)];
    return [
      svg('path', { d: pathOf(spots), fill: 'none', stroke: fill, 'stroke-width': width, 'stroke-linejoin': 'round', ...(dash === undefined ? {} : { 'stroke-dasharray': dash }) }),
      svg('path', { d: arrowPath(before, end, 1.3 * width), fill }),
      svg('circle', { cx: start.x, cy: start.y, r: this.view === 'clearance' ? 2.2 : 3.6, fill }),
    ];
  }

  private journal({ journal }: OrbitStation, station: number, centre: Spot, current: Look): SVGElement[] {
    if (!journal) return [];
    const mark = journalMark(current, this.view === 'clearance' ? 3 : 5);
    this.journals.push({ mark, centre, station });
    return [mark];
  }
}
