/** Bearings within the tolerances of the case: how the numbers of their cycles spread, while they are being computed. */
import { el } from '../ui/dom';
import type { CyclesAnswer, SamplesAnswer } from './format';
import { isRefused, type Solver } from './solver';
import { SpreadCharts } from './spread';
import { isSeen } from './tabs';

const bearings = 100;
/** So many at a time: what was requested since need not wait long. */
const atATime = 4;

export class EnsembleView {
  readonly root = el('div', { class: 'ensemble' });
  private readonly caption = el('p', { class: 'note', role: 'status' });
  private readonly add = el('button', { type: 'button', class: 'quiet' }, 'Add tolerances');
  private readonly charts = new SpreadCharts();
  private design: { text: string; answer: CyclesAnswer } | undefined;
  /** Text of the design that is computed, or was. */
  private begun = '';

  /** @param give  gives the case tolerances */
  constructor(
    private readonly solver: Solver,
    give: () => void,
  ) {
    this.add.addEventListener('click', give);
    this.root.append(el('div', { class: 'tools' }, this.caption, this.add), this.charts.tools, this.charts.root);
  }

  show(design: { text: string; answer: CyclesAnswer }): void {
    this.design = design;
    this.refresh();
  }

  /** Computes what is in sight, unless it has begun. */
  refresh(): void {
    if (!isSeen(this.root) || !this.design || this.design.text === this.begun) return;
    this.begun = this.design.text;
    void this.compute(this.design);
  }

  private async compute({ text, answer: { run } }: { text: string; answer: CyclesAnswer }): Promise<void> {
    const scatters = run.summary.case['montecarlo'] !== undefined;
    this.add.hidden = scatters;
    this.charts.root.hidden = !scatters;
    this.charts.tools.hidden = !scatters;
    if (!scatters) {
      this.caption.textContent = 'The case has no tolerances: all bearings are identical.';
      return;
    }
    let samples: SamplesAnswer['samples'] = [];
    delete this.root.dataset['done'];
    while (samples.length < bearings) {
      const part = await this.solver.ask<SamplesAnswer>({ what: 'samples', text, first: samples.length, count: atATime, before: samples });
      if (this.begun !== text) return;
      // Another request for bearings came first: repeat this one.
      if (!part) continue;
      if (isRefused(part)) {
        this.caption.textContent = part.errors.map(({ message }) => message).join(' · ');
        return;
      }
      samples = part.samples;
      this.caption.textContent = `${samples.length} of ${bearings} bearings${samples.length < bearings ? ' …' : ''}, drawn as bumpfoil montecarlo draws them.`;
      this.charts.draw(run.summary, { directions: run.cycles.map((cycle) => cycle.at), states: [], ...part });
      if (!isSeen(this.root)) {
        // Looked at again it begins anew.
        this.begun = '';
        return;
      }
    }
    this.root.dataset['done'] = String(samples.length);
  }
}
