/** The bearing on its gas film, at one speed under one load or at one position. */
import { polarPlot, runningBearing } from '../bearing/running';
import { pressureMap, runningLoads, thicknessChart } from '../charts/film';
import type { CaseValue, Quantity } from '../data/format';
import { vectorText } from '../data/grid';
import { at, Run } from '../data/run';
import { speedText, States } from '../data/states';
import { formatQuantity } from '../data/units';
import { resultTable } from '../tables/results';
import { Comparison } from '../ui/comparison';
import { dropDown, el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { Selection } from '../ui/selection';
import type { CyclesAnswer, EquilibriumAnswer, Faults } from './format';
import { NumberControl } from './number_control';
import { notesOf, remarks } from './remarks';
import { isFaulty, settled, type Solver } from './solver';
import { isSeen } from './tabs';

const rpm = Math.PI / 30;

/** What holds the journal, with its unit as people write it. */
const holds = [
  { key: 'load', text: 'Load', unit: 'N', size: 1, most: 200 },
  { key: 'position', text: 'Position', unit: 'µm', size: 1e-6, most: 60 },
] as const;
type Hold = (typeof holds)[number];

/** Where the bearing runs, as it is asked for; SI. */
interface Point {
  speed: number;
  load?: [number, number];
  position?: [number, number];
}

interface Design {
  text: string;
  answer: CyclesAnswer;
}

/** Whatever the case says of running: the first speed with the first load or position. */
function pointOf(settings: CaseValue | undefined): Point | undefined {
  const { speeds, loads, positions } = (settings ?? {}) as { speeds?: number[]; loads?: [number, number][]; positions?: [number, number][] };
  const [speed, load, position] = [speeds?.[0], loads?.[0], positions?.[0]];
  if (speed === undefined) return undefined;
  return load ? { speed, load } : position ? { speed, position } : undefined;
}

function textOf({ speed, load, position }: Point): string {
  return `${speedText(speed)}, ${load ? `load ${vectorText(...load, 'N')}` : `position ${vectorText(...(position ?? [0, 0]), 'm')}`}`;
}

/** The quantities of a state as those of a cycle, which tables compare. */
function runOf({ run, state }: EquilibriumAnswer, name: string): Run {
  const byLoad = state['load_x_N'] !== null;
  // What is asked for is not found.
  const asked = byLoad ? /^(speed|load_[xy]|force_[xy])$/ : /^(speed|[xy])$/;
  const quantities = run.quantities.filter(({ name: its, key, listed }) => listed && !asked.test(its) && (state[key] ?? null) !== null);
  return new Run({
    ...run,
    name,
    summary: { ...run.summary, cycles: [{ ...state, at: 0, amplitude_m: 0, steps: 0, converged: state['status'] === 'converged' }] },
    quantities: quantities.map((one): Quantity => ({ ...one, ...(one.unit === 'degree' ? { unit: '', label: `${one.label} (°)` } : {}) })),
    meanings: {},
    geometry: {},
    nodes: { bump: 0, foot: 0 },
    last_increment: 0,
    cycles: [{ at: 0, increments: [0], series: {}, fields: {} }],
  });
}

/** Views of one state; the next one takes its place. */
class StateViews {
  readonly root: HTMLElement;
  private readonly states: States;
  private before: States | undefined;
  private readonly selection: GridSelection;
  private readonly tables = el('div');
  private comparison: Comparison | undefined;

  constructor(now: EquilibriumAnswer, name: string) {
    this.states = new States({ ...now.run, name });
    this.selection = new GridSelection(this.states.coordinates, [this.states.speed]);
    const { states, selection } = this;
    this.root = el(
      'div',
      {},
      el('div', { class: 'multiples' }, pressureMap(states, selection), thicknessChart(states, selection, () => this.before), runningLoads(states, selection), polarPlot(states, selection), ...runningBearing(states, selection)),
      this.tables,
    );
  }

  show(now: EquilibriumAnswer, before: EquilibriumAnswer | undefined, name: string): void {
    this.states.replace({ ...now.run, name });
    this.before = before?.state['status'] === 'converged' ? new States({ ...before.run, name: 'baseline' }) : undefined;
    this.selection.show({});
    const runs = [runOf(now, 'current'), ...(before ? [runOf(before, 'baseline')] : [])];
    const reference = at(runs, runs.length - 1);
    if (this.comparison?.runs.length === runs.length) {
      this.comparison.replace(runs, reference);
    } else {
      this.comparison = new Comparison(new Selection(runs), []);
      this.comparison.set({ reference });
      this.tables.replaceChildren(resultTable(this.comparison, [0]));
    }
  }
}

export class RunningView {
  readonly root: HTMLElement;
  private readonly told = el('p', { class: 'note', role: 'status' });
  private readonly notes = el('div');
  private readonly place = el('div');
  private readonly speed = new NumberControl(() => this.refresh());
  private readonly journal = [0, 1].map(() => new NumberControl(() => this.refresh()));
  private readonly holding = dropDown('What holds the journal', holds.map((value) => ({ value, text: value.text })), (hold) => {
    this.hold(hold);
    this.refresh();
  });
  private held: Hold = holds[0];
  private views: StateViews | undefined;
  private designs: { now: Design; before: Design } | undefined;
  /** What the case said of running when it was last asked. */
  private said = '';
  /** What the answers are to, or will be. */
  private begun = '';
  private waiting = 0;
  /** Answers to what is shown, by their requests. */
  private known = new Map<string, EquilibriumAnswer | Faults>();

  constructor(private readonly solver: Solver) {
    this.speed.call('Speed', 'rpm', [1000, 120000, 500]);
    this.take({ speed: 45000 * rpm, load: [50, 0] });
    this.root = el(
      'div',
      { class: 'running' },
      el('div', { class: 'tools', role: 'group', 'aria-label': 'Running' }, this.speed.root, el('label', { class: 'control' }, 'Journal held by', this.holding), ...this.journal.map(({ root }) => root)),
      this.told,
      this.notes,
      this.place,
    );
  }

  show(now: Design, before: Design): void {
    this.designs = { now, before };
    const settings = now.answer.run.summary.case['equilibrium'];
    const said = JSON.stringify(settings) ?? '';
    const point = pointOf(settings);
    if (point && said !== this.said) this.take(point);
    this.said = said;
    this.refresh();
  }

  /** Computes what is in sight once it has settled, unless it has begun. */
  refresh(): void {
    if (!isSeen(this.root) || !this.designs) return;
    const point = this.point;
    if (!point) {
      this.told.textContent = 'Speed, loads and positions are numbers.';
      this.begun = '';
      window.clearTimeout(this.waiting);
      this.root.setAttribute('aria-busy', 'false');
      return;
    }
    const { now, before } = this.designs;
    const texts = now.text === before.text ? [now.text] : [now.text, before.text];
    const wanted = JSON.stringify([texts, point]);
    if (wanted === this.begun) return;
    this.begun = wanted;
    this.told.textContent = 'Computing …';
    this.root.setAttribute('aria-busy', 'true');
    window.clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => void this.compute(wanted, texts, point), settled);
  }

  private async compute(wanted: string, texts: string[], point: Point): Promise<void> {
    if (!isSeen(this.root)) {
      // Looked at again it begins anew.
      this.begun = '';
      return;
    }
    const requests = texts.map((text) => ({ what: 'equilibrium', ...point, text }));
    const keys = requests.map((request) => JSON.stringify(request));
    this.known = new Map([...this.known].filter(([key]) => keys.includes(key)));
    for (const [i, request] of requests.entries()) {
      const key = at(keys, i);
      if (!this.known.has(key)) {
        const answer = await this.solver.ask<EquilibriumAnswer>(request);
        if (this.begun !== wanted) return;
        // Overtaken by what asked for running bearings elsewhere.
        if (!answer) return this.compute(wanted, texts, point);
        this.known.set(key, answer);
      } else if (i > 0) {
        // Drawn already, beside the first.
        continue;
      }
      const [now, before] = keys.map((one) => this.known.get(one));
      if (now) this.draw(now, before && !isFaulty(before) ? before : undefined, point);
    }
    this.root.setAttribute('aria-busy', 'false');
    this.root.dataset['answered'] = String(Number(this.root.dataset['answered'] ?? 0) + 1);
  }

  private draw(now: EquilibriumAnswer | Faults, before: EquilibriumAnswer | undefined, point: Point): void {
    this.place.classList.toggle('stale', isFaulty(now));
    if (isFaulty(now)) {
      this.tell(`This bearing cannot run${this.views ? '; showing the last valid results' : ''}.`, now.faults.map(({ message }) => message));
      return;
    }
    const { state, run } = now;
    const [x, y, film] = ['x_m', 'y_m', 'h_min_m'].map((key) => formatQuantity(state[key] as number | null, 'm', 3));
    const found = state['status'] === 'converged';
    this.tell(
      `${textOf(point)}: ${found ? `the journal runs at x = ${x ?? ''}, y = ${y ?? ''}; minimum film thickness ${film ?? ''}.` : 'no state was found.'}`,
      notesOf(run),
    );
    if (!this.views) {
      this.views = new StateViews(now, textOf(point));
      this.place.replaceChildren(this.views.root);
    }
    this.views.show(now, before, textOf(point));
  }

  private tell(text: string, notes: string[]): void {
    this.told.textContent = text;
    this.notes.replaceChildren(...remarks(notes));
  }

  /** Nothing where it is not given in numbers. */
  private get point(): Point | undefined {
    const speed = this.speed.value * rpm;
    const journal = this.journal.map(({ value }) => value * this.held.size);
    if (![speed, ...journal].every(Number.isFinite)) return undefined;
    return { speed, [this.held.key]: journal };
  }

  private take(point: Point): void {
    const { speed, load, position } = point;
    const hold = at(holds, load ? 0 : 1);
    this.holding.selectedIndex = holds.indexOf(hold);
    this.hold(hold);
    this.speed.value = speed / rpm;
    this.journal.forEach((control, axis) => (control.value = at(load ?? position ?? [0, 0], axis) / hold.size));
  }

  private hold(hold: Hold): void {
    this.held = hold;
    this.journal.forEach((control, axis) => control.call(axis === 0 ? `${hold.text} along X` : 'along Y', hold.unit, [-hold.most, hold.most, 1]));
  }
}
