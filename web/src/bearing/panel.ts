import { capital, contactStates, largest, type Cycle } from '../data/run';
import { toCsv } from '../data/csv';
import { formatQuantity } from '../data/units';
import { afterwards } from '../ui/afterwards';
import { dropDown, el, svg, tickBox } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Selection } from '../ui/selection';
import { look, onLookChange } from '../ui/theme';
import { arrowPath } from './drawing';
import { gradingOf } from './foil_lines';
import { BearingGeometry } from './geometry';
import { drawRound } from './round';
import { fittingAlong, fittingInwards, magnifications, shapeAt } from './shape';
import { drawUnwrapped, frictionFactor, leastWidth, type Scene, type UnwrappedLayout } from './unwrapped';

/** What the scales of the drawings follow: the whole of a run, whatever the increment. */
interface Extent {
  /** Magnification along the foil over that inwards, where both are such that the drawing fits. */
  alongOfInwards: number;
  /** Of the contacts, the largest; 1 where there is none, N. */
  force: number;
}

function extentOf(geometry: BearingGeometry): Extent {
  const { cycles, interfaces } = geometry.run;
  return {
    alongOfInwards: fittingAlong(geometry) / fittingInwards(geometry),
    force: largest(...cycles.flatMap((cycle) => interfaces.map(({ name }) => cycle.field(`normal_force_${name}`).values))) || 1,
  };
}

/** The deformed bearing at the chosen increment, round and laid flat, with the values of one bump in words. */
export class BearingPanels {
  readonly round: HTMLElement;
  readonly unwrapped: HTMLElement;
  private readonly panels: { round: Panel; unwrapped: Panel };
  private readonly roundDrawing = svg('svg', { class: 'round', role: 'img' });
  private readonly flatDrawing = svg('svg', { class: 'unwrapped', role: 'img', tabindex: 0 });
  private readonly flatPlace = el('div', { class: 'scroller' }, this.flatDrawing);
  private readonly bumpText = el('p', { class: 'note bump-values', 'aria-live': 'polite' });
  private geometry: BearingGeometry;
  private extent: Extent;
  private inwards: number;
  private forces = true;
  private bump: number | undefined;
  private layout: UnwrappedLayout | undefined;
  /** Width of the place for the foils; asking for it while views change would have the page laid out once more. */
  private room = 0;
  /** Of the round drawing on the screen, px. */
  private roundSize = 0;
  /** How much larger heights are drawn than lengths in the round view. */
  private roundStretch = 1;

  constructor(private readonly selection: Selection) {
    this.geometry = new BearingGeometry(selection.run);
    this.extent = extentOf(this.geometry);
    this.inwards = fittingInwards(this.geometry);
    const factors = dropDown(
      'Magnification of displacements',
      magnifications.map((value) => ({ value, text: `×${value}` })),
      (factor) => {
        this.inwards = factor;
        this.draw();
      },
    );
    factors.selectedIndex = magnifications.indexOf(this.inwards);
    const forces = tickBox('Forces', true, (shown) => {
      this.forces = shown;
      this.draw();
    });
    const common = { csv: () => this.csv() };
    const round = new Panel(
      {
        title: 'The bearing',
        note: 'Seen along its axis.',
        subject: () => this.subject(this.roundStretch),
        legend: () => [
          ...arrows.slice(0, 1),
          { width: 26, draw: (current) => [svg('path', { d: arrowPath({ x: 1, y: 6 }, { x: 25, y: 6 }, 3), fill: current.accent })], text: 'applied force' },
          ...marks,
        ],
        file: () => this.file('bearing'),
        drawing: () => this.roundDrawing,
        ...common,
      },
      this.roundDrawing,
    );
    const unwrapped = new Panel(
      {
        title: selection.run.kind.flat ? 'The foils' : 'The foils, unwrapped',
        subject: () => this.subject(this.layout?.stretch ?? 1),
        legend: () => [...arrows, ...marks],
        controls: [
          el('label', { class: 'control' }, 'Displacements and gaps against heights', factors),
          forces,
        ],
        file: () => this.file('foils'),
        drawing: () => this.flatDrawing,
        ...common,
      },
      this.flatPlace,
      this.bumpText,
    );
    this.panels = { round, unwrapped };
    this.round = round.root;
    this.unwrapped = unwrapped.root;
    this.listen();
    selection.onChange(() => this.follow());
    // Paper has other sizes, and does not wait until they are observed.
    onLookChange(() => this.fit());
    const sizes = new ResizeObserver(() => this.fit());
    sizes.observe(this.flatPlace);
    sizes.observe(this.roundDrawing);
  }

  /** Draws in the sizes of now. */
  private fit(): void {
    this.room = this.flatPlace.clientWidth;
    this.roundSize = Math.min(this.roundDrawing.clientWidth, this.roundDrawing.clientHeight);
    this.draw();
  }

  private follow(): void {
    if (this.geometry.run !== this.selection.run) {
      this.geometry = new BearingGeometry(this.selection.run);
      this.extent = extentOf(this.geometry);
    }
    this.draw();
  }

  /** Chosen together with the other factor, and as much larger as the lengths are. */
  private get along(): number {
    return this.extent.alongOfInwards * this.inwards;
  }

  private get cycle(): Cycle {
    return this.selection.cycle;
  }

  private draw(): void {
    if (this.cycle.size === 0) return;
    if (!this.selection.run.kind.flat) this.roundStretch = drawRound(this.roundDrawing, this.scene, look(), this.roundSize);
    this.panels.round.refresh();
    this.roundDrawing.setAttribute('aria-label', `Deformed bearing, ${this.where}`);
    afterwards(this.drawFlat);
  }

  private readonly drawFlat = (): void => {
    if (this.room > 0) {
      this.layout = drawUnwrapped(this.flatDrawing, this.scene, look(), Math.max(this.room, leastWidth(this.geometry)));
      this.flatDrawing.style.width = `${this.layout.width}px`;
    }
    this.panels.unwrapped.refresh();
    this.flatDrawing.setAttribute('aria-label', `Deformed foils, ${this.where}. Arrow keys choose a bump.`);
    this.bumpText.textContent = this.bump === undefined ? 'Point at a bump to read its values.' : this.bumpValues(this.bump);
  };

  private get scene(): Scene {
    const { index } = this.selection;
    return {
      geometry: this.geometry,
      cycle: this.cycle,
      index,
      shape: shapeAt(this.geometry, this.cycle, index),
      inwards: this.inwards,
      along: this.along,
      largestForce: this.extent.force,
      forces: this.forces,
      bump: this.bump,
    };
  }

  private get where(): string {
    const { cycle, index, run } = this.selection;
    const branch = index === cycle.turning ? 'full displacement' : cycle.isLoading(index) ? 'loading' : 'unloading';
    const values = [formatQuantity(cycle.value('displacement', index), 'm'), formatQuantity(cycle.value('force_direct', index), 'N')];
    return [run.label, cycle.name, branch, ...values].join(' · ');
  }

  /** What is seen, and how much larger than it is. */
  private subject(stretch: number): string {
    const times = (factor: number): string => `×${Number(factor.toPrecision(2))}`;
    const grading = gradingOf(this.geometry);
    return `${this.where}. Against true scale: height of bumps ${times(stretch)}, displacements and gaps ${times(stretch * this.inwards)}, slip ${times(this.along)}; displacements and gaps against heights ×${this.inwards}.${grading === '' ? '' : ` ${capital(grading)}.`}`;
  }

  private bumpValues(bump: number): string {
    const { cycle, index, run } = this.selection;
    const force = (name: string, node: number): string => formatQuantity(cycle.field(name).at(index, node), 'N', 3);
    const length = (name: string): string => formatQuantity(cycle.field(name).at(index, bump), 'm', 3);
    const state = (name: string, node: number): string => contactStates[cycle.states(name).at(index, node)] ?? 'unknown';
    const feet = this.geometry.feetOf(bump).filter((foot): foot is number => foot !== undefined);
    const own = this.geometry.twoFeet ? feet : [bump];
    return [
      `Bump ${run.numberOf('bump', bump)}: load ${force('normal_force_top_bump', bump)}, friction ${force('friction_force_top_bump', bump)}, ${state('top_bump', bump)}`,
      ...(this.geometry.topFoil ? [`${run.kind.journal} ${force('normal_force_journal_top', bump)}`] : []),
      `crest ${length('crest_v')} outwards, ${length('crest_u')} along`,
      ...own.map((foot) => `foot ${run.numberOf('foot', foot)} ${force('normal_force_bump_sleeve', foot)}, ${state('bump_sleeve', foot)}`),
    ].join(' · ');
  }

  private choose(bump: number | undefined): void {
    if (bump === this.bump) return;
    this.bump = bump;
    this.draw();
  }

  private listen(): void {
    this.flatDrawing.addEventListener('pointermove', (event) => {
      const { left } = this.flatDrawing.getBoundingClientRect();
      this.choose(this.layout?.bumpAt(event.clientX - left));
    });
    this.flatDrawing.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      const last = this.selection.run.bumps - 1;
      const bump = Math.min(Math.max(0, (this.bump ?? (step > 0 ? -1 : last + 1)) + step), last);
      this.choose(bump);
      // Where the foils scroll, it stays in sight.
      this.flatPlace.scrollLeft = (this.layout?.placeOfBump(bump) ?? 0) - 0.5 * this.flatPlace.clientWidth;
    });
  }

  private file(what: string): string {
    return fileName(what, this.selection.run.label, this.cycle.name, String(this.cycle.increments[this.selection.index]));
  }

  /** All that is known of bumps and feet at the increment. */
  private csv(): string {
    const { cycle, index, run } = this.selection;
    const atBumps = ['crest_u', 'crest_v', 'normal_force_top_bump', 'friction_force_top_bump'];
    if (this.geometry.topFoil) atBumps.push('top_displacement', 'normal_force_journal_top');
    const atFeet = ['foot_u', 'foot_v', 'normal_force_bump_sleeve', 'friction_force_bump_sleeve'];
    const header = ['run', run.kind.cycles.column, 'increment', 'node', 'number', 'quantity', 'value_SI'];
    const rows = (names: string[], node: string, count: number): (string | number)[][] =>
      names.flatMap((name) =>
        Array.from({ length: count }, (_, i) => [
          run.label,
          cycle.key,
          cycle.increments[index] ?? 0,
          node,
          i + 1,
          name,
          cycle.field(name).at(index, i),
        ]),
      );
    return toCsv(header, [...rows(atBumps, 'bump', run.bumps), ...rows(atFeet, 'foot', run.feet)]);
  }
}

function arrow(colour: 'force' | 'friction', text: string): LegendEntry {
  return { width: 26, draw: (current) => [svg('path', { d: arrowPath({ x: 1, y: 6 }, { x: 25, y: 6 }), fill: current[colour] })], text };
}

const arrows = [arrow('force', 'normal force'), arrow('friction', `friction on the bump foil (×${frictionFactor})`)];

/** States of contacts, as stateMark() draws them. */
export const marks: LegendEntry[] = [
  { width: 14, draw: (c) => [svg('circle', { cx: 7, cy: 6, r: 3, fill: c.background, stroke: c.muted })], text: 'open' },
  { width: 14, draw: (c) => [svg('rect', { x: 4, y: 3, width: 6, height: 6, fill: c.states.stick })], text: 'stick' },
  { width: 14, draw: (c) => [svg('path', { d: 'M3 2L12 6L3 10Z', fill: c.states['slip forward'] })], text: 'slip forward' },
  { width: 14, draw: (c) => [svg('path', { d: 'M11 2L2 6L11 10Z', fill: c.states['slip backward'] })], text: 'slip backward' },
];
