import { OverPanel, type Measure, type Part } from '../charts/over';
import { responseCharts } from '../charts/responses';
import { rotorOrbits } from '../charts/rotor_orbits';
import type { CaseKeys, GridData, ResultData } from '../data/format';
import type { Place } from '../data/grid';
import { gridWarnings } from '../data/outcome';
import { periodic, Responses } from '../data/responses';
import { capital } from '../data/run';
import { caseSection } from '../tables/case';
import { entryOf } from '../tables/glossary';
import { columnOf, gridTable, inDegrees, namesOfFirst, type GridColumn } from '../tables/grid';
import { peakTable } from '../tables/peaks';
import { el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { valueChooser } from './grid_controls';
import { part, type View } from './view';

/** What a bearing does in a turn of a periodic orbit, and what all of them do together. */
const ofBearings: [string, (values: number[]) => number][] = [
  ['h_min', (values) => Math.min(...values)],
  ['friction_loss', (values) => values.reduce((sum, value) => sum + value, 0)],
  ['power', (values) => values.reduce((sum, value) => sum + value, 0)],
];

function labelOf(responses: Responses, name: string): string {
  return responses.data.quantities.find((one) => one.name === name)?.label ?? name;
}

function equilibriumFilm(responses: Responses): Part {
  const variable = responses.variable('equilibrium_h_min');
  return { key: 'equilibrium_h_min_m', text: 'in equilibrium, all bearings', has: (dimension) => dimension === 'speed', value: (place) => variable?.at(place) ?? NaN };
}

/** Of the bearings in periodic orbits, and the film without unbalance. */
function measuresOf(responses: Responses): Measure[] {
  const all = responses.hasOrbits ? ofBearings : ofBearings.slice(0, 1);
  return all.flatMap(([name]): Measure[] => {
    const variable = responses.variable(name);
    if (!variable) return [];
    const bearings = Array.from({ length: responses.bearings }, (_, station): Part => ({
      key: `${variable.key}_${station + 1}`,
      text: `periodic orbit, ${responses.stations[station] ?? ''}`,
      has: (dimension) => dimension === 'speed',
      value: (place) => variable.at({ ...place, kind: periodic, station }),
    }));
    const parts = [...(responses.hasOrbits ? bearings : []), ...(name === 'h_min' ? [equilibriumFilm(responses)] : [])];
    const perTurn = name === 'friction_loss' ? ' in a turn' : '';
    return [{ text: `${capital(labelOf(responses, name))}${perTurn}`, unit: variable.unit, parts }];
  });
}

function quantityColumn(responses: Responses, name: string): GridColumn[] {
  return columnOf(responses, name, labelOf(responses, name));
}

/** Of every speed: the film without unbalance, and what the periodic orbit is like. */
function speedColumns(responses: Responses): GridColumn[] {
  const together = ofBearings.flatMap(([name, all]) =>
    quantityColumn(responses, name).map((column): GridColumn => ({ ...column, label: `${column.label}, orbit`, value: (place: Place) => responses.ofBearings(name, place, all) })),
  );
  const lasting = quantityColumn(responses, 'orbit_lasts').map((column) => ({ ...column, label: 'orbit', words: ['does not last', 'lasts'] }));
  return [
    ...quantityColumn(responses, 'equilibrium_h_min'),
    ...(responses.hasOrbits ? [...together, ...quantityColumn(responses, 'largest_multiplier'), ...lasting] : []),
    ...['speed_status', 'orbit_status', 'orbit_turns', 'orbit_change'].flatMap((name) => quantityColumn(responses, name)),
  ];
}

function responseColumns(responses: Responses): GridColumn[] {
  return responses.data.quantities.flatMap(({ name, label }): GridColumn[] => {
    const columns = responses.variable(name)?.has('station') ? columnOf(responses, name, label) : [];
    return columns.map(inDegrees);
  });
}

function sectionsOf(responses: Responses, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const { label, speed, station, kind } = responses;
  const selection = new GridSelection([speed, station], [speed]);
  selection.show({ place: responses.first });
  const measures = measuresOf(responses);
  const over = measures.length > 0 && speed.texts.length > 1 ? [new OverPanel('Film and losses', measures, selection, label).root] : [];
  const choosers = [speed, station].filter(({ texts }) => texts.length > 1).map((one) => valueChooser(selection, one, `${one.title} shown`));
  const compared = { several: false, focus: [responses], shown: [responses], names: label, onChange: () => undefined };
  return [
    part(
      `${id}-responses`,
      title('Response to unbalance'),
      peakTable(responses),
      ...(choosers.length > 0 ? [el('div', { class: 'tools', role: 'group', 'aria-label': 'What is shown' }, ...choosers)] : []),
      el('div', { class: 'multiples' }, ...responseCharts(responses, selection), rotorOrbits(responses, selection), ...over),
    ),
    part(
      `${id}-speeds`,
      title('Speeds'),
      gridTable({ title: 'Results by speed', label, coordinates: [speed], columns: speedColumns(responses), main: [] }),
      gridTable({ title: 'Responses', label, coordinates: [speed, kind, station], columns: responseColumns(responses), main: namesOfFirst(responses.data.quantities) }),
    ),
    part(
      `${id}-case`,
      title('Case and origin'),
      caseSection(compared, caseKeys, { shortfalls: () => [responses.attribute('status_message')].filter((text) => text !== ''), note: '' }),
    ),
  ];
}

/** Rotors and their unbalance, one run after the other. */
export function unbalanceView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const all = results.map((data) => new Responses(data as GridData));
  return {
    sections: all.flatMap((responses, i) => {
      const several = all.length > 1 || !alone;
      return sectionsOf(responses, `unbalance-${i + 1}`, (text) => (several ? `${text}, ${responses.label}` : text), caseKeys);
    }),
    warnings: all.map((responses) => gridWarnings(responses)),
    entries: all.flatMap((responses) => responses.data.quantities.map(entryOf).map((entry) => ({ ...entry, label: capital(entry.label) }))),
  };
}
