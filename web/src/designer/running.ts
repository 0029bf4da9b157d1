/** The bearing on its gas film, at one speed under one load or at one position, and about that point. */
import { bearingInSpace, polarPlot, runningBearing } from '../bearing/running';
import { pressureMap, runningLoads, thicknessChart, thicknessMap } from '../charts/film';
import type { Quantity } from '../data/format';
import { at, capital, Run } from '../data/run';
import { States } from '../data/states';
import { formatNumber, formatQuantity } from '../data/units';
import { resultTable } from '../tables/results';
import { Comparison } from '../ui/comparison';
import { dropDown, el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { Selection } from '../ui/selection';
import { CurvePanel, linesAbout, verdictOf } from './curves';
import { FilmSpread } from './film_spread';
import type { CyclesAnswer, EquilibriumAnswer, InputErrors, StateOfSummary } from './format';
import { NumberControl } from './number_control';
import { isSame, pointOf, settingsOf, textOf, type Point, type RunningSettings } from './point';
import { notesOf, remarks } from './remarks';
import { isRefused, quickMesh, settled, type Request, type Solver } from './solver';
import { isSeen } from './tabs';
import { compared, tile } from './tiles';

const rpm = Math.PI / 30;

/** What holds the journal, with its unit as people write it. */
const holds = [
  { key: 'loads', text: 'Load', unit: 'N', size: 1, most: 200 },
  { key: 'positions', text: 'Position', unit: 'µm', size: 1e-6, most: 60 },
] as const;
type Hold = (typeof holds)[number];

interface Design {
  text: string;
  answer: CyclesAnswer;
}

function stateOf({ states }: EquilibriumAnswer): StateOfSummary {
  return at(states, 0);
}

function isFound(answer: EquilibriumAnswer): boolean {
  return stateOf(answer)['status'] === 'converged';
}

/** The quantities of a state as those of a cycle, which tables compare. */
function runOf(answer: EquilibriumAnswer, name: string): Run {
  const { run } = answer;
  const state = stateOf(answer);
  const byLoad = state['load_x_N'] !== null;
  // The requested state is not found.
  const requested = byLoad ? /^(speed|load_[xy]|force_[xy])$/ : /^(speed|[xy])$/;
  const quantities = run.quantities.filter(({ name: its, key, listed }) => listed && !requested.test(its) && (state[key] ?? null) !== null);
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

/** Names of the quantities in large letters, with the number of their digits; what is said of stability is second. */
const large = { h_min: 4, attitude_angle: 3, power: 3, p_max: 4, critical_mass: 3 };

/** Main numbers of a state, and whether film and foils stay in it. */
function tilesOf(answer: EquilibriumAnswer, before: StateOfSummary | undefined): HTMLElement[] {
  const now = stateOf(answer);
  const number = (state: StateOfSummary | undefined, key: string): number => (typeof state?.[key] === 'number' ? state[key] : NaN);
  const numbers = Object.entries(large).flatMap(([name, digits]) => {
    const quantity = answer.run.quantities.find((one) => one.name === name);
    if (!quantity) return [];
    const { key, label, unit } = quantity;
    const value = number(now, key);
    const text = unit === 'degree' ? `${formatNumber(value, digits)}°` : formatQuantity(value, unit, digits);
    return [tile(key, capital(label), Number.isFinite(value) ? text : '–', before ? compared(value, number(before, key)) : '')];
  });
  const growth = number(now, 'growth_held');
  const { stable } = now;
  const held = tile('stable', 'Journal held', stable === true ? 'stable' : stable === false ? 'unstable' : '–', Number.isFinite(growth) ? `foils ${growth < 0 ? 'settle' : 'flutter'}: growth ${formatNumber(growth, 2)} × speed` : '');
  return [...numbers.slice(0, 1), held, ...numbers.slice(1)];
}

/** Views of one state; the next one takes its place. */
class StateViews {
  /** The film over the foil first; the others follow the curves. */
  readonly film: HTMLElement;
  readonly others: HTMLElement[];
  readonly tables = el('div');
  private readonly states: States;
  private before: States | undefined;
  private readonly selection: GridSelection;
  private comparison: Comparison | undefined;

  constructor(now: EquilibriumAnswer, name: string) {
    this.states = new States({ ...now.run, name });
    this.selection = new GridSelection(this.states.coordinates, [this.states.speed]);
    const { states, selection } = this;
    this.film = thicknessChart(states, selection, () => this.before);
    this.others = [pressureMap(states, selection), ...thicknessMap(states, selection), ...bearingInSpace(states, selection), polarPlot(states, selection), ...runningBearing(states, selection), runningLoads(states, selection)];
  }

  show(now: EquilibriumAnswer, before: EquilibriumAnswer | undefined, name: string): void {
    this.states.replace({ ...now.run, name });
    this.before = before && isFound(before) ? new States({ ...before.run, name: 'baseline' }) : undefined;
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

/** Answers that are kept. */
const mostKnown = 24;

export class RunningView {
  readonly root: HTMLElement;
  private readonly caption = el('p', { class: 'note', role: 'status' });
  private readonly notes = el('div');
  private readonly tiles = el('div', { class: 'tiles' });
  private readonly verdict = el('p', { class: 'note', role: 'status' });
  private readonly place = el('div');
  private readonly speed = new NumberControl(() => this.refresh());
  private readonly journal = [0, 1].map(() => new NumberControl(() => this.refresh()));
  private readonly holding = dropDown('What holds the journal', holds.map((value) => ({ value, text: value.text })), (hold) => {
    this.hold(hold);
    this.refresh();
  });
  private readonly curves = {
    speed: new CurvePanel('Over speed', 'speed', (index) => this.go(this.lines[0]?.points.speeds[index])),
    journal: new CurvePanel('Over load', 'journal', (index) => this.go(undefined, this.lines[1]?.points[this.held.key]?.[index])),
  };
  private readonly spread: FilmSpread;
  private held: Hold = holds[0];
  private views: StateViews | undefined;
  /** Of another design layout the views are made anew: pads, modes over the width. */
  private layout = '';
  private lines: ReturnType<typeof linesAbout> = [];
  private designs: { now: Design; before: Design } | undefined;
  /** Operating points of the case when it was last read. */
  private said = '';
  /** What the answers are to, or will be. */
  private begun = '';
  /** Answers by their requests. */
  private known = new Map<string, EquilibriumAnswer | InputErrors>();

  /**
   * @param quick  for the answer on a coarse mesh, which comes first
   * @param give   gives the case tolerances
   */
  constructor(
    private readonly quick: Solver,
    private readonly slow: Solver,
    give: () => void,
  ) {
    this.spread = new FilmSpread(slow, give);
    this.speed.call('Speed', 'rpm', [1000, 120000, 500]);
    this.take({ speed: 45000 * rpm, held: 'loads', journal: [50, 0] });
    this.root = el(
      'div',
      { class: 'running' },
      el('div', { class: 'tools', role: 'group', 'aria-label': 'Running' }, this.speed.root, el('label', { class: 'control' }, 'Journal held by', this.holding), ...this.journal.map(({ root }) => root)),
      this.tiles,
      this.caption,
      this.notes,
      this.verdict,
      this.place,
    );
  }

  show(now: Design, before: Design): void {
    this.designs = { now, before };
    const settings = this.settings;
    const said = JSON.stringify(settings);
    const point = pointOf(settings);
    if (point && said !== this.said) this.take(point);
    this.said = said;
    this.refresh();
  }

  private get settings(): RunningSettings {
    return settingsOf(this.designs?.now.answer.run.summary.case['equilibrium']);
  }

  /** Computes what is in sight, unless it has begun. */
  refresh(): void {
    if (!isSeen(this.root) || !this.designs) return;
    const point = this.point;
    if (!point) {
      this.caption.textContent = 'Enter speed, loads and positions as numbers.';
      this.begun = '';
      this.root.setAttribute('aria-busy', 'false');
      return;
    }
    const { now, before } = this.designs;
    const texts = now.text === before.text ? [now.text] : [now.text, before.text];
    const wanted = JSON.stringify([texts, point]);
    if (wanted === this.begun) return;
    this.begun = wanted;
    this.root.setAttribute('aria-busy', 'true');
    void this.compute(wanted, texts, point);
  }

  /** What answers soon, and once the design has settled what answers exactly; then what is about the point. */
  private async compute(wanted: string, texts: string[], point: Point): Promise<void> {
    const began = performance.now();
    const { speed, held, journal } = point;
    for (const quick of [true, false]) {
      if (!quick) await new Promise((resolve) => setTimeout(resolve, Math.max(0, began + settled - performance.now())));
      const answers: (EquilibriumAnswer | InputErrors)[] = [];
      for (const text of texts) {
        const answer = await this.answer(quick ? this.quick : this.slow, { what: 'equilibrium', text, speeds: [speed], [held]: [journal], ...(quick ? { mesh: quickMesh } : {}) }, wanted);
        if (!answer) return;
        answers.push(answer);
        // Drawn at once, and again beside the one before.
        const [now, before] = answers;
        if (now) this.draw(now, before && !isRefused(before) ? before : undefined, point, quick);
      }
      this.count(quick ? 'quick' : 'answered');
      if (quick) this.root.dataset['took'] = (performance.now() - began).toFixed(0);
    }
    this.root.setAttribute('aria-busy', 'false');
    await this.drawCurves(wanted, texts, point);
    if (this.begun === wanted && this.designs) await this.spread.show(at(texts, 0), this.designs.now.answer, point, () => this.begun === wanted && isSeen(this.root));
  }

  /** Of both designs on the coarse mesh, over speed and over load. */
  private async drawCurves(wanted: string, texts: string[], point: Point): Promise<void> {
    this.lines = linesAbout(point, this.settings);
    this.curves.journal.root.hidden = this.lines.length < 2;
    const verdicts: string[] = [];
    // Of the state at the point, on each of the lines through it.
    const stable = new Set<unknown>();
    for (const line of this.lines) {
      const { over, points } = line;
      const answers: (EquilibriumAnswer | InputErrors)[] = [];
      for (const text of texts) {
        const answer = await this.answer(this.slow, { what: 'equilibrium', text, ...points, mesh: quickMesh }, wanted);
        if (!answer) return;
        answers.push(answer);
      }
      const [now, before] = answers;
      if (!now || isRefused(now)) continue;
      const index = over === 'speed' ? points.speeds.indexOf(point.speed) : (points[point.held] ?? []).findIndex((one) => isSame(one, point.journal));
      const what = over === 'speed' ? 'speed' : point.held === 'loads' ? 'load' : 'position';
      this.curves[over].show(`Over ${what}`, now, before && !isRefused(before) ? before : undefined, Math.max(0, index));
      stable.add(now.states[Math.max(0, index)]?.['stable']);
      const words = verdictOf(line, now);
      verdicts.push(`over ${what} ${words.length > 0 ? words.join(', ') : 'all states are stable'}`);
    }
    const history = stable.size > 1 ? ' There are several states at this point: the history of the bearing decides which one it runs in.' : '';
    this.verdict.textContent = verdicts.length > 0 ? `On the coarse mesh ${verdicts.join('; ')}.${history}` : '';
    this.count('curves');
  }

  /** Kept; nothing where something else is wanted by now. */
  private async answer(solver: Solver, request: Request, wanted: string): Promise<EquilibriumAnswer | InputErrors | undefined> {
    const key = JSON.stringify(request);
    while (!this.known.has(key)) {
      // What is no longer in sight begins anew when it is looked at again.
      if (!isSeen(this.root)) this.begun = '';
      if (this.begun !== wanted) return undefined;
      // Without one, another request for running bearings came first.
      const answer = await solver.ask<EquilibriumAnswer>(request);
      if (answer) this.known.set(key, answer);
    }
    for (const old of [...this.known.keys()].slice(0, -mostKnown)) this.known.delete(old);
    return this.begun === wanted ? this.known.get(key) : undefined;
  }

  private count(name: string): void {
    this.root.dataset[name] = String(Number(this.root.dataset[name] ?? 0) + 1);
  }

  private draw(now: EquilibriumAnswer | InputErrors, before: EquilibriumAnswer | undefined, point: Point, quick: boolean): void {
    this.place.classList.toggle('stale', isRefused(now));
    if (isRefused(now)) {
      this.tell(`This bearing cannot run${this.views ? '; showing the last valid results' : ''}.`, now.errors.map(({ message }) => message));
      return;
    }
    const state = stateOf(now);
    const [x, y] = ['x_m', 'y_m'].map((key) => formatQuantity(state[key] as number | null, 'm', 3));
    this.tell(
      `${textOf(point)}: ${isFound(now) ? `the journal runs at x = ${x ?? ''}, y = ${y ?? ''}` : 'no state was found'}${quick ? ', on a coarse mesh; that of the case follows …' : ', on the mesh of the case.'}`,
      notesOf(now.run),
    );
    this.tiles.replaceChildren(...tilesOf(now, before && stateOf(before)));
    const { dimensions, variables } = now.run;
    const layout = JSON.stringify([dimensions['pad'], Object.keys(variables), variables['film_thickness']?.dims]);
    if (!this.views || layout !== this.layout) {
      this.layout = layout;
      this.views = new StateViews(now, textOf(point));
      this.place.replaceChildren(el('div', { class: 'multiples' }, this.views.film, this.curves.speed.root, this.curves.journal.root, this.spread.root, ...this.views.others), this.views.tables);
    }
    this.views.show(now, before, textOf(point));
  }

  private tell(text: string, notes: string[]): void {
    this.caption.textContent = text;
    this.notes.replaceChildren(...remarks(notes));
  }

  /** Nothing where it is not given in numbers. */
  private get point(): Point | undefined {
    const speed = this.speed.value * rpm;
    const [x = NaN, y = NaN] = this.journal.map(({ value }) => value * this.held.size);
    return [speed, x, y].every(Number.isFinite) ? { speed, held: this.held.key, journal: [x, y] } : undefined;
  }

  /** To a point of a curve. */
  private go(speed: number | undefined, journal?: [number, number]): void {
    const { point } = this;
    if (!point || (speed === undefined && !journal)) return;
    this.take({ ...point, ...(speed === undefined ? {} : { speed }), ...(journal ? { journal } : {}) });
    this.refresh();
  }

  private take({ speed, held, journal }: Point): void {
    const hold = at(holds, holds.findIndex(({ key }) => key === held));
    this.holding.selectedIndex = holds.indexOf(hold);
    this.hold(hold);
    this.speed.value = speed / rpm;
    this.journal.forEach((control, axis) => (control.value = at(journal, axis) / hold.size));
  }

  private hold(hold: Hold): void {
    this.held = hold;
    this.journal.forEach((control, axis) => control.call(axis === 0 ? `${hold.text} along X` : 'along Y', hold.unit, [-hold.most, hold.most, 1]));
  }
}
