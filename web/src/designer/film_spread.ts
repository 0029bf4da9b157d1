/** How the film of the running bearing spreads within the tolerances of the case. */
import type { StatisticsData } from '../data/format';
import { el } from '../ui/dom';
import type { CyclesAnswer, EquilibriumAnswer } from './format';
import { textOf, type Point } from './point';
import { isRefused, quickMesh, type Solver } from './solver';
import { SpreadCharts } from './spread';

const bearings = 40;
/** So many at a time are drawn together. */
const atATime = 4;

export class FilmSpread {
  readonly root: HTMLElement;
  private readonly caption = el('p', { class: 'note', role: 'status' });
  private readonly add = el('button', { type: 'button', class: 'quiet' }, 'Add tolerances');
  private readonly charts = new SpreadCharts();
  /** What was computed to its end. */
  private done = '';

  /** @param give  gives the case tolerances */
  constructor(
    private readonly solver: Solver,
    give: () => void,
  ) {
    this.add.addEventListener('click', give);
    const title = 'Film thickness within tolerances';
    this.root = el('section', { class: 'panel spread', 'aria-label': title }, el('header', {}, el('h3', {}, title), this.add), this.caption, this.charts.root);
  }

  /** @param going  whether it is still wanted */
  async show(text: string, { run }: CyclesAnswer, point: Point, going: () => boolean): Promise<void> {
    const scatters = run.summary.case['montecarlo'] !== undefined;
    this.add.hidden = scatters;
    this.charts.root.hidden = !scatters;
    if (!scatters) {
      this.caption.textContent = 'The case has no tolerances: the film of all bearings is the same.';
      return;
    }
    const { speed, held, journal } = point;
    const wanted = JSON.stringify([text, point]);
    if (wanted === this.done) return;
    const samples: (number | null)[][][] = [];
    let stable = 0;
    while (samples.length < bearings) {
      const answer = await this.solver.ask<EquilibriumAnswer>({ what: 'equilibrium', text, speeds: [speed], [held]: [journal], mesh: quickMesh, sample: samples.length });
      if (!going()) return;
      // Another request for running bearings came first: repeat this one.
      if (!answer) continue;
      if (isRefused(answer) && samples.length === 0) {
        this.caption.textContent = answer.errors.map(({ message }) => message).join(' · ');
        return;
      }
      // What was drawn may be no bearing.
      const [state] = isRefused(answer) ? [] : answer.states;
      const quantities = isRefused(answer) ? [] : answer.run.quantities.filter(({ leads }) => leads);
      samples.push([quantities.map(({ key }) => (typeof state?.[key] === 'number' ? state[key] : null))]);
      stable += Number(state?.['stable'] === true);
      if (samples.length % atATime > 0) continue;
      const statistics: Record<string, StatisticsData> = {};
      for (const [i, { key }] of quantities.entries()) {
        const found = await this.solver.ask<StatisticsData>({ what: 'statistics', values: samples.map(([of]) => of?.[i] ?? null) });
        if (!found || isRefused(found)) return;
        statistics[key] = found;
      }
      this.caption.textContent = `${samples.length} of ${bearings} bearings${samples.length < bearings ? ' …' : ''} within the tolerances, on the coarse mesh: ${stable} stable with the journal held.`;
      if (quantities.length > 0) this.charts.draw(run.summary, { directions: [], states: [textOf(point)], quantities, samples, statistics: [statistics] });
    }
    this.done = wanted;
    this.root.dataset['done'] = String(samples.length);
  }
}
