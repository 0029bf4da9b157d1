/** The running bearing over speed and over load, about the point at which it is looked at. */
import { OverPanel, type Measure } from '../charts/over';
import type { Quantity } from '../data/format';
import { mainQuantities, numbersAmong } from '../data/main_quantities';
import { at, capital } from '../data/run';
import { speedText, States } from '../data/states';
import { el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import type { EquilibriumAnswer } from './format';
import { isSame, type Point } from './point';

/** Of the speed that is looked at. */
const speedRatios = [0.25, 0.5, 0.75, 1, 1.25, 1.5];
/** Of the load or the position that is looked at. */
const journalRatios = [0.25, 0.5, 1, 1.5, 2, 3];
/** So many speeds or loads of the case make a curve of their own. */
const fewest = 3;

/** What results are drawn over: `speeds`, and `loads` or `positions`. */
export interface Line {
  over: 'speed' | 'journal';
  points: { speeds: number[]; loads?: [number, number][]; positions?: [number, number][] };
}

/** With one that is requested among them, rising. */
function withOne(numbers: number[], one: number): number[] {
  const others = numbers.filter((number) => Math.abs(number - one) > 1e-9 * Math.abs(one));
  return [...others, one].sort((a, b) => Math.abs(a) - Math.abs(b));
}

/** @param ofCase  speeds, and loads or positions, that the case names */
export function linesAbout({ speed, journal, held }: Point, ofCase: { speeds?: number[]; loads?: [number, number][]; positions?: [number, number][] } = {}): Line[] {
  const given = ofCase[held] ?? [];
  const speeds = (ofCase.speeds ?? []).length >= fewest ? withOne(ofCase.speeds ?? [], speed) : speedRatios.map((ratio) => ratio * speed);
  const journals = given.length >= fewest ? (given.some((one) => isSame(one, journal)) ? given : [...given, journal]) : journalRatios.map((ratio): [number, number] => [ratio * journal[0], ratio * journal[1]]);
  const lines: Line[] = [{ over: 'speed', points: { speeds, [held]: [journal] } }];
  // Nothing times any factor is nothing.
  if (given.length >= fewest || Math.hypot(...journal) > 0) lines.push({ over: 'journal', points: { speeds: [speed], [held]: journals } });
  return lines;
}

/** States of a line, drawn over what differs in them, beside those of the baseline. */
export class CurvePanel {
  readonly root: HTMLElement;
  private states: States | undefined;
  private before: States | undefined;
  private panel: OverPanel | undefined;
  private layout = '';

  /** @param choose  called with the speed or the place in the list of loads that is clicked */
  constructor(
    title: string,
    private readonly over: Line['over'],
    private readonly choose: (index: number) => void,
  ) {
    // Its place is kept for it.
    this.root = el('div', { class: 'curve' }, el('section', { class: 'panel', 'aria-label': title }, el('header', {}, el('h3', {}, title)), el('p', { class: 'note' }, 'Computed once the state is found.')));
  }

  show(title: string, now: EquilibriumAnswer, before: EquilibriumAnswer | undefined, index: number): void {
    const data = { ...now.run, name: '' };
    this.states ? this.states.replace(data) : (this.states = new States(data));
    this.before = before && new States({ ...before.run, name: 'baseline' });
    const { states } = this;
    const layout = JSON.stringify([states.coordinates, before !== undefined]);
    if (this.panel && layout === this.layout) return this.panel.refresh();
    this.layout = layout;
    const along = this.over === 'speed' ? states.speed : states.journal;
    const selection = new GridSelection(states.coordinates, [along]);
    selection.show({ place: { [along.name]: index } });
    selection.onChange(() => this.choose(selection.index(along)));
    const main = now.run.quantities.filter(({ first }) => first);
    const drawn = mainQuantities(numbersAmong(main, (key) => now.states.map((state) => state[key])), [], main.length);
    this.panel = new OverPanel(title, this.measures(drawn), selection, '');
    this.root.replaceChildren(this.panel.root);
  }

  private measures(quantities: Quantity[]): Measure[] {
    return quantities.map((quantity): Measure => {
      const degrees = quantity.unit === 'degree';
      const text = capital(degrees ? `${quantity.label} (°)` : quantity.label);
      const part = (of: () => States | undefined, words: string): Measure['parts'][number] => ({ key: words === '' ? quantity.key : `${quantity.key}_${words}`, text: words === '' ? text : words, has: () => true, value: (place) => of()?.numberAt(quantity.name, place) ?? NaN });
      return { text, unit: degrees ? '' : quantity.unit, parts: this.before ? [part(() => this.states, 'current'), part(() => this.before, 'baseline')] : [part(() => this.states, '')] };
    });
  }
}

/** Where on a line there is no state, and where film and foils leave it. */
export function verdictOf({ over }: Line, { run, states }: EquilibriumAnswer): string[] {
  const of = new States({ ...run, name: '' });
  const words = (among: EquilibriumAnswer['states']): string => among.map((state) => (over === 'speed' ? speedText(Number(state['speed_rad_per_s'])) : at(of.journal.texts, states.indexOf(state)))).join(', ');
  const missing = states.filter((state) => state['status'] !== 'converged');
  const unstable = states.filter((state) => state['stable'] === false);
  return [...(missing.length > 0 ? [`no state at ${words(missing)}`] : []), ...(unstable.length > 0 ? [`unstable at ${words(unstable)}`] : [])];
}
