import { modeShape } from '../charts/mode_shape';
import { motionCharts } from '../charts/motions';
import { OverPanel, type Measure } from '../charts/over';
import type { CaseKeys, GridData, ResultData } from '../data/format';
import { gridWarnings } from '../data/outcome';
import { capital } from '../data/run';
import { Whirls } from '../data/whirls';
import { caseSection } from '../tables/case';
import { entryOf } from '../tables/glossary';
import { columnOf, gridTable, namesOfFirst, type GridColumn } from '../tables/grid';
import { onsetTable } from '../tables/onsets';
import { choice, el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { valueChooser } from './grid_controls';
import { part, type View } from './view';

/** Of every speed: film, the motion that grows fastest, and whether all decay. */
function columnsOf(whirls: Whirls): GridColumn[] {
  return whirls.data.quantities.flatMap(({ name, label }): GridColumn[] => {
    const variable = whirls.variable(name);
    if (variable?.dims.join() !== 'speed') return [];
    return columnOf(whirls, name, label).map((column) => (name.startsWith('fastest_of_foils') ? { ...column, label: label.replace(' of the foils', ' of'), words: ['rotor', 'foils'] } : column));
  });
}

/** Over speed, each by itself: what has no diagram of its own. */
function measuresOf(whirls: Whirls): Measure[] {
  return ['h_min', 'whirl_ratio', 'whirl_ratio_stuck', 'least_log_decrement', 'least_log_decrement_stuck'].flatMap((name) => {
    const quantity = whirls.data.quantities.find((one) => one.name === name);
    const variable = whirls.variable(name);
    if (!quantity || !variable?.values.some(Number.isFinite)) return [];
    const text = capital(quantity.label);
    return [{ text, unit: quantity.unit, parts: [{ key: quantity.key, text, has: (dimension: string) => variable.has(dimension), value: variable.at.bind(variable) }] }];
  });
}

function controls(whirls: Whirls, selection: GridSelection): HTMLElement {
  const { speed, contacts, motion } = whirls;
  const kinds = contacts.texts.map((text, value) => ({ value, text: capital(text) }));
  return el(
    'div',
    { class: 'tools', role: 'group', 'aria-label': 'What is shown' },
    choice('Contacts shown', kinds, 0, (value) => selection.show({ place: { contacts: value } })),
    ...[speed, motion].filter(({ texts }) => texts.length > 1).map((one) => valueChooser(selection, one, `${one.title} shown`)),
  );
}

function sectionsOf(whirls: Whirls, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const { label, speed, contacts, motion } = whirls;
  const selection = new GridSelection([speed, contacts, motion], [speed]);
  selection.show({ place: whirls.first });
  const measures = measuresOf(whirls);
  const over = measures.length > 0 && speed.texts.length > 1 ? [new OverPanel('Film and fastest motion', measures, selection, label).root] : [];
  const motions = motion.texts.length > 0 ? [controls(whirls, selection), el('div', { class: 'multiples' }, ...motionCharts(whirls, selection), modeShape(whirls, selection), ...over)] : [el('div', { class: 'multiples' }, ...over)];
  const compared = { several: false, focus: [whirls], shown: [whirls], names: label, onChange: () => undefined };
  return [
    part(`${id}-motions`, title('Free motions over speed'), onsetTable(whirls), ...motions),
    part(`${id}-speeds`, title('Speeds'), gridTable({ title: 'Results by speed', label, coordinates: [speed], columns: columnsOf(whirls), main: namesOfFirst(whirls.data.quantities) })),
    part(
      `${id}-case`,
      title('Case and origin'),
      caseSection(compared, caseKeys, { shortfalls: () => [whirls.attribute('status_message')].filter((text) => text !== ''), note: '' }),
    ),
  ];
}

/** Rotors on their bearings, one run after the other. */
export function stabilityView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const all = results.map((data) => new Whirls(data as GridData));
  return {
    sections: all.flatMap((whirls, i) => {
      const several = all.length > 1 || !alone;
      return sectionsOf(whirls, `stability-${i + 1}`, (text) => (several ? `${text}, ${whirls.label}` : text), caseKeys);
    }),
    warnings: all.map((whirls) => gridWarnings(whirls)),
    entries: all.flatMap((whirls) => whirls.data.quantities.map(entryOf)),
  };
}
