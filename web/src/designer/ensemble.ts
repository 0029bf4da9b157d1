/** Bearings within the tolerances of the case: how their numbers spread, while they are being computed. */
import { HistogramPanel } from '../charts/histogram';
import { Ensemble } from '../data/ensemble';
import type { DistributionData, EnsembleData } from '../data/format';
import { at } from '../data/run';
import { choice, el } from '../ui/dom';
import { EnsembleSelection } from '../ui/ensemble_selection';
import type { CyclesAnswer, SamplesAnswer } from './format';
import { isFaulty, type Solver } from './solver';
import { countsOf } from './spread';
import { isSeen } from './tabs';

const bearings = 100;
/** So many at a time: what was asked for since need not wait long. */
const atATime = 4;
const intervals = 16;

/** What is drawn of an ensemble; its numbers change as bearings are added. */
interface Drawn {
  data: EnsembleData;
  histograms: HistogramPanel[];
}

export class EnsembleView {
  readonly root = el('div', { class: 'ensemble' });
  private readonly told = el('p', { class: 'note', role: 'status' });
  private readonly add = el('button', { type: 'button', class: 'quiet' }, 'Add tolerances');
  private readonly tools = el('div', { class: 'tools' });
  private readonly place = el('div', { class: 'multiples' });
  private readonly selection = new EnsembleSelection(undefined);
  private drawn: Drawn | undefined;
  private design: { text: string; answer: CyclesAnswer } | undefined;
  /** Text of the design that is computed, or was. */
  private begun = '';

  /** @param give  gives the case tolerances */
  constructor(
    private readonly solver: Solver,
    give: () => void,
  ) {
    this.add.addEventListener('click', give);
    this.root.append(el('div', { class: 'tools' }, this.told, this.add), this.tools, this.place);
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

  private async compute({ text, answer }: { text: string; answer: CyclesAnswer }): Promise<void> {
    const scatters = answer.run.summary.case['montecarlo'] !== undefined;
    this.add.hidden = scatters;
    this.place.hidden = !scatters;
    this.tools.hidden = !scatters;
    if (!scatters) {
      this.told.textContent = 'The case has no tolerances: all bearings are identical.';
      return;
    }
    let samples: SamplesAnswer['samples'] = [];
    delete this.root.dataset['done'];
    while (samples.length < bearings) {
      const part = await this.solver.ask<SamplesAnswer>({ what: 'samples', text, first: samples.length, count: atATime, before: samples });
      if (this.begun !== text) return;
      // Overtaken by what asked for bearings elsewhere: it is asked again.
      if (!part) continue;
      if (isFaulty(part)) {
        this.told.textContent = part.faults.map(({ message }) => message).join(' · ');
        return;
      }
      samples = part.samples;
      this.told.textContent = `${samples.length} of ${bearings} bearings${samples.length < bearings ? ' …' : ''}, drawn as bumpfoil montecarlo draws them.`;
      this.draw(answer, part);
      if (!isSeen(this.root)) {
        // Looked at again it begins anew.
        this.begun = '';
        return;
      }
    }
    this.root.dataset['done'] = String(samples.length);
  }

  private draw({ run }: CyclesAnswer, { quantities, samples, statistics }: SamplesAnswer): void {
    const directions = run.cycles.map((cycle) => cycle.at);
    const names = quantities.map(({ name }) => name);
    const same = this.drawn && JSON.stringify([this.drawn.data.directions, Object.keys(this.drawn.data.distributions)]) === JSON.stringify([directions, names]);
    if (!this.drawn || !same) {
      const { summary } = run;
      const distributions = Object.fromEntries(names.map((name): [string, DistributionData] => [name, { unit: '', text: '', from: null, to: null, counts: [], first: [] }]));
      const data: EnsembleData = {
        name: 'design',
        kind: 'montecarlo',
        attributes: {},
        summary: { ...summary, samples: 0, samples_due: bearings, statistics: {}, bump_loads: {}, sensitivities: {}, limits: [] },
        quantities,
        directions,
        states: [],
        sample_count: bearings,
        distributions,
        samples: [],
      };
      this.drawn = { data, histograms: [] };
    }
    const { data } = this.drawn;
    const numbers = (direction: number, quantity: number): (number | null)[] => samples.map((sample) => sample[direction]?.[quantity] ?? null);
    data.summary.statistics = Object.fromEntries(statistics.map((of, direction) => [String(direction), of]));
    quantities.forEach(({ name }, quantity) => {
      const each = directions.map((_, direction) => numbers(direction, quantity));
      const known = each.flat().filter((value): value is number => value !== null);
      const [from, to] = known.length > 0 ? [Math.min(...known), Math.max(...known)] : [null, null];
      Object.assign(data.distributions[name] ?? {}, { from, to, counts: each.map((values) => (from === null || to === null ? [] : countsOf(values, from, to, intervals))) });
    });
    if (same) for (const histogram of this.drawn.histograms) histogram.refresh();
    else this.build(this.drawn);
  }

  private build(drawn: Drawn): void {
    const ensemble = new Ensemble(drawn.data);
    if (this.selection.direction >= ensemble.directions.length) this.selection.show({ direction: 0 });
    drawn.histograms = ensemble.quantities.map((quantity) => new HistogramPanel(ensemble, quantity, at([ensemble.distribution(quantity.name)].flatMap((one) => one ?? []), 0), this.selection));
    const directions = ensemble.directions.map((text, value) => ({ value, text }));
    this.tools.replaceChildren(choice('Direction of the bearings', directions, this.selection.direction, (direction) => this.selection.show({ direction })));
    this.place.replaceChildren(...drawn.histograms.map(({ root }) => root));
  }
}
