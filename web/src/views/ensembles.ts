import { BearingPanels } from '../bearing/panel';
import { player } from '../bearing/player';
import { colourSample, curvesOf } from '../charts/curves';
import { FactorPanel } from '../charts/factors';
import { HistogramPanel } from '../charts/histogram';
import { loadSpread } from '../charts/load_spread';
import { LoopPanel } from '../charts/loops';
import { axisText } from '../data/counted';
import { Ensemble } from '../data/ensemble';
import type { CaseKeys, EnsembleData, Quantity, ResultData } from '../data/format';
import { mainQuantities } from '../data/main_quantities';
import { partialWarning } from '../data/outcome';
import { allKeys } from '../data/run';
import { caseSection } from '../tables/case';
import { entryOf } from '../tables/glossary';
import { statisticsTable, statisticTiles, yieldTable } from '../tables/statistics';
import { Comparison } from '../ui/comparison';
import { dropDown, el } from '../ui/dom';
import { EnsembleSelection } from '../ui/ensemble_selection';
import { Selection } from '../ui/selection';
import { familyScale } from './chooser';
import { fold, part, type View } from './view';

/** Hidden where there is no choice. */
function directionChooser(ensemble: Ensemble, selection: EnsembleSelection): HTMLElement[] {
  const { directions } = ensemble;
  if (directions.length < 2) return [];
  const list = dropDown(`${ensemble.placeWord} shown`, directions.map((text, value) => ({ value, text })), (direction) => selection.show({ direction }));
  selection.onChange(() => void (list.selectedIndex = selection.direction));
  return [el('div', { class: 'tools', role: 'group', 'aria-label': 'What is shown' }, el('label', { class: 'control' }, ensemble.placeWord, list))];
}

/** Direction and bearing are those that the reader looks at everywhere. */
function link(ensemble: Ensemble, looked: EnsembleSelection, selection: Selection): void {
  const { directions } = ensemble.data;
  selection.onChange(() => looked.show({ direction: directions.indexOf(selection.cycle.key), run: selection.run }));
  looked.onChange(() => {
    const key = directions[looked.direction];
    if (key === undefined || (key === selection.cycle.key && looked.run === selection.run)) return;
    selection.show({ key, ...(looked.run ? { run: looked.run } : {}) });
  });
}

/** The loops of the first bearings, and the one of them that is looked at. */
function bearings(ensemble: Ensemble, looked: EnsembleSelection, id: string, title: string): HTMLElement[] {
  const { runs } = ensemble;
  if (runs.length === 0) return [];
  const selection = new Selection(runs);
  link(ensemble, looked, selection);
  const forces = new Map(runs.map((run) => [run, ensemble.numberOf(run, 'max_force', 0)]));
  const known = [...forces.values()].every(Number.isFinite);
  const comparison = new Comparison(selection, known ? [{ title: 'Maximum force', unit: 'N', values: forces }] : []);
  // Told apart from all others is the one that is looked at.
  selection.onChange(() => {
    if (comparison.reference !== selection.run) comparison.set({ reference: selection.run });
  });
  const keys = allKeys(runs).filter((key) => runs.some((run) => (run.cycle(key)?.size ?? 0) > 0));
  const bearing = new BearingPanels(selection);
  const loops = keys.map(
    (key) =>
      new LoopPanel(
        {
          title: `Loops, ${ensemble.directions[ensemble.data.directions.indexOf(key)] ?? ''}`,
          curves: () => curvesOf(comparison, key, runs),
          focus: () => curvesOf(comparison, key, [selection.run]),
          legend: () => [colourSample((current) => comparison.colour(selection.run, current), selection.run.label)],
        },
        comparison,
      ).root,
  );
  return [
    player(selection, comparison),
    part(
      id,
      title,
      ...(comparison.family ? [el('p', { class: 'note scale' }, ...familyScale(comparison))] : []),
      el('div', { class: 'beside' }, el('div', { class: keys.length > 1 ? 'multiples' : 'single' }, ...loops), el('div', { class: 'in-sight' }, bearing.round)),
      bearing.unwrapped,
    ),
  ];
}

function sectionsOf(ensemble: Ensemble, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const { label, runs, quantities } = ensemble;
  const looked = new EnsembleSelection(runs[0]);
  const histograms = (those: Quantity[]): HTMLElement[] =>
    those.flatMap((quantity) => {
      const distribution = ensemble.distribution(quantity.name);
      return distribution && distribution.from !== null ? [new HistogramPanel(ensemble, quantity, distribution, looked).root] : [];
    });
  const main = mainQuantities(quantities, ensemble.limited);
  const others = histograms(quantities.filter((quantity) => !main.includes(quantity)));
  const factors = [
    { name: 'Sensitivity to bump heights', along: axisText('bump', ensemble.hasPads), of: ensemble.heightFactors },
    { name: 'Sensitivity to inputs common to a bearing', along: 'What scatters', of: ensemble.commonFactors(caseKeys) },
  ].flatMap(({ name, along, of }) => (of.length > 0 ? [new FactorPanel(name, of, along, ensemble, looked).root] : []));
  const compared = { several: false, focus: [ensemble], shown: [ensemble], names: label, onChange: () => undefined };
  const first = runs.length === 1 ? 'A bearing' : `The first ${runs.length} bearings`;
  return [
    part(`${id}-distributions`, title('Ensemble'), ...directionChooser(ensemble, looked), ...yieldTable(ensemble), statisticTiles(ensemble, looked, main), el('div', { class: 'multiples maps' }, ...histograms(main)), ...(others.length > 0 ? [fold(`${others.length} more distributions`, el('div', { class: 'multiples' }, ...others))] : [])),
    ...bearings(ensemble, looked, `${id}-bearings`, title(first)),
    part(`${id}-factors`, title('Sensitivities'), el('div', { class: 'multiples' }, ...factors, ...(ensemble.hasLoads ? [loadSpread(ensemble, looked)] : []))),
    part(`${id}-statistics`, title('Statistics'), fold(`Mean, scatter and percentiles of ${quantities.length} quantities`, statisticsTable(ensemble, looked))),
    part(
      `${id}-case`,
      title('Case and origin'),
      fold('The case as interpreted, and where the results come from', caseSection(compared, caseKeys, { shortfalls: () => [ensemble.attribute('status_message')].filter((text) => text !== ''), note: '' })),
    ),
  ];
}

function warningsOf(ensemble: Ensemble): string[] {
  const { samples, samples_due: due } = ensemble.data.summary;
  const message = ensemble.attribute('status_message');
  const messages = [message, ...ensemble.attribute('warnings').split('\n')].filter((text) => text !== '');
  return [
    ...partialWarning(ensemble),
    ...messages.map((text) => `${text}.`),
    ...(samples < due && message === '' ? [`${samples} of ${due} samples are available.`] : []),
  ];
}

/** Ensembles, one after the other. */
export function ensembleView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const ensembles = results.map((data) => new Ensemble(data as EnsembleData));
  return {
    sections: ensembles.flatMap((ensemble, i) => {
      const several = ensembles.length > 1 || !alone;
      return sectionsOf(ensemble, `ensemble-${i + 1}`, (text) => (several ? `${text}, ${ensemble.label}` : text), caseKeys);
    }),
    warnings: ensembles.map(warningsOf),
    entries: ensembles.flatMap(({ quantities }) => quantities.map(entryOf)),
  };
}
