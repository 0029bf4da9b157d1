/** How numbers of bearings spread, while bearings are being added. */
import { HistogramPanel } from '../charts/histogram';
import { Ensemble } from '../data/ensemble';
import type { DistributionData, EnsembleData, Quantity, RunData, StatisticsData } from '../data/format';
import { at } from '../data/run';
import { choice, el } from '../ui/dom';
import { EnsembleSelection } from '../ui/ensemble_selection';
import { countsOf } from './counts';

const intervals = 16;

/** What is known of bearings so far. */
export interface Spread {
  /** Directions of their cycles, or else their states by name. */
  directions: number[];
  states: string[];
  quantities: Quantity[];
  /** By bearing, direction or state, and quantity. */
  samples: (number | null)[][][];
  /** Of all of them, by direction or state and key. */
  statistics: Record<string, StatisticsData>[];
}

/** Histograms, one for each quantity. */
export class SpreadCharts {
  readonly tools = el('div', { class: 'tools' });
  readonly root = el('div', { class: 'multiples' });
  private readonly selection = new EnsembleSelection(undefined);
  private drawn: { layout: string; data: EnsembleData; histograms: HistogramPanel[] } | undefined;

  draw(summary: RunData['summary'], { directions, states, quantities, samples, statistics }: Spread): void {
    const layout = JSON.stringify([directions, states, quantities.map(({ name }) => name)]);
    const same = this.drawn?.layout === layout;
    if (!this.drawn || !same) {
      const distributions = Object.fromEntries(quantities.map(({ name }): [string, DistributionData] => [name, { unit: '', text: '', from: null, to: null, counts: [], first: [] }]));
      const data: EnsembleData = {
        name: 'design',
        kind: 'montecarlo',
        attributes: {},
        summary: { ...summary, samples: 0, samples_due: samples.length, statistics: {}, bump_loads: {}, sensitivities: {}, limits: [] },
        quantities,
        directions,
        states,
        sample_count: samples.length,
        distributions,
        samples: [],
      };
      this.drawn = { layout, data, histograms: [] };
    }
    const { data } = this.drawn;
    data.summary.statistics = Object.fromEntries(statistics.map((of, place) => [String(place), of]));
    quantities.forEach(({ name }, quantity) => {
      const each = (states.length > 0 ? states : directions).map((_, place) => samples.map((sample) => sample[place]?.[quantity] ?? null));
      const known = each.flat().filter((value): value is number => value !== null);
      const [from, to] = known.length > 0 ? [Math.min(...known), Math.max(...known)] : [null, null];
      Object.assign(data.distributions[name] ?? {}, { from, to, counts: each.map((values) => (from === null || to === null ? [] : countsOf(values, from, to, intervals))) });
    });
    if (same) for (const histogram of this.drawn.histograms) histogram.refresh();
    else this.build(this.drawn);
  }

  private build(drawn: { data: EnsembleData; histograms: HistogramPanel[] }): void {
    const ensemble = new Ensemble(drawn.data);
    if (this.selection.direction >= ensemble.directions.length) this.selection.show({ direction: 0 });
    drawn.histograms = ensemble.quantities.map((quantity) => new HistogramPanel(ensemble, quantity, at([ensemble.distribution(quantity.name)].flatMap((one) => one ?? []), 0), this.selection));
    const places = ensemble.directions.map((text, value) => ({ value, text }));
    this.tools.replaceChildren(...(places.length > 1 ? [choice('Direction of the bearings', places, this.selection.direction, (direction) => this.selection.show({ direction }))] : []));
    this.root.replaceChildren(...drawn.histograms.map(({ root }) => root));
  }
}
