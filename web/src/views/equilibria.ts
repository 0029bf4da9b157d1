import { bearingInSpace, polarPlot, runningBearing } from '../bearing/running';
import { asperityMap, pressureMap, runningLoads, thicknessChart, thicknessMap } from '../charts/film';
import { OverPanel, type Measure, type Part } from '../charts/over';
import type { CaseKeys, GridData, ResultData } from '../data/format';
import { gridWarnings } from '../data/outcome';
import { numbersOf } from '../data/grid';
import { capital } from '../data/run';
import { States } from '../data/states';
import { caseSection } from '../tables/case';
import { entryOf } from '../tables/glossary';
import { gridTable, namesOfFirst, type GridColumn } from '../tables/grid';
import { limitTable } from '../tables/limits';
import { el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { frequencyEntries, frequencySections, synchronousCharts } from './frequencies';
import { gridControls } from './grid_controls';
import { part, type View } from './view';

const entries = ['xx', 'xy', 'yx', 'yy'] as const;

/** What a chart shows of its quantities: each by itself, or all together, in one drawing. */
interface Drawn {
  names: string[];
  /** Of all together, where there are several. */
  all?: string;
}

/** Words and unit come with the quantity. */
function partOf(states: States, name: string): { unit: string; part: Part }[] {
  const quantity = states.data.quantities.find((one) => one.name === name);
  if (!quantity || !states.variable(name)?.values.some(Number.isFinite)) return [];
  const degrees = quantity.unit === 'degree';
  const text = capital(degrees ? `${quantity.label} (°)` : quantity.label);
  return [{ unit: degrees ? '' : quantity.unit, part: { key: name, text, has: () => true, value: (place) => states.numberAt(name, place) } }];
}

/** Those of one unit in one chart, and by themselves where paths or loads are to be told apart. */
function measuresOf(states: States, { names, all }: Drawn): Measure[] {
  const parts = names.flatMap((name) => partOf(states, name));
  const each = parts.map((one): Measure => ({ text: one.part.text, unit: one.unit, parts: [one.part] }));
  return all !== undefined && parts.length > 1 ? [{ text: all, unit: parts[0]?.unit ?? '', parts: parts.map(({ part }) => part) }, ...each] : each;
}

/** What their peaks carry and rub, beside all of the torque. */
const roughSurfaces: [string, Drawn[]] = ['Rough surfaces', [{ all: 'Torque', names: ['torque', 'asperity_torque'] }, { names: ['asperity_share', 'max_asperity_pressure'] }]];

/** Charts over speed or load: which quantities are drawn together. */
function chartsOf(states: States): { title: string; measures: Measure[] }[] {
  const stiffness = (end: string): string[] => entries.map((axes) => `k${axes}${end}`);
  const charts: [string, Drawn[]][] = [
    ['Minimum film thickness', [{ names: ['h_min', 'h_min_crest'] }]],
    ['Journal position', [{ names: ['attitude_angle', 'eccentricity_ratio'] }, { all: 'Journal centre', names: ['x', 'y'] }]],
    ['Losses', [{ names: ['power', 'torque'] }]],
    ...(states.variable('asperity_share') ? [roughSurfaces] : []),
    ['Stiffness', [{ all: 'Stiffness', names: stiffness('') }, { all: 'Stiffness, full stick', names: stiffness('_stuck') }]],
    ['Pressure and force', [{ all: 'Pressure', names: ['p_max', 'p_min'] }, { all: 'Force', names: ['force_x', 'force_y'] }]],
    ['Bumps', [{ names: ['highest_bump_load', 'loaded_bumps', 'lifted_bumps_at_entry'] }]],
  ];
  const synchronous = isSynchronous(states) ? synchronousCharts(states, (name, place) => states.numberAt(name, place)) : [];
  const pads = states.pads > 1 ? [{ text: 'Forces of the pads', unit: 'N', parts: padParts(states) }] : [];
  return charts
    .map(([title, drawn]) => ({ title, measures: [...drawn.flatMap((one) => measuresOf(states, one)), ...(title === 'Pressure and force' ? pads : [])] }))
    .flatMap((chart) => (chart.title === 'Stiffness' ? [chart, ...synchronous] : [chart]))
    .filter(({ measures }) => measures.length > 0);
}

/** Whether small motions are those at the speed of every state, and not at frequencies that were requested. */
function isSynchronous(states: States): boolean {
  const speeds = numbersOf(states, 'speed');
  return numbersOf(states, 'whirl_frequency').every((frequency, i) => Number.isNaN(frequency) || frequency === Math.abs(speeds[i] ?? NaN));
}

/** Forces of several pads. */
function padParts(states: States): Part[] {
  return states.variable('pad_force_x') ? states.padColumns.map(({ name }, pad) => ({ key: `pad_force_${pad + 1}`, text: name, has: () => true, value: (place) => states.padForceAt(pad, place) })) : [];
}

const padForce = 'magnitude of the pad force';

function columnsOf(states: States): GridColumn[] {
  const pads = padParts(states).map(({ key, text, value }): GridColumn => ({ key: `${key}_N`, name: 'pad_force', label: `force of ${text}`, unit: 'N', whole: false, meaning: padForce, words: [], value }));
  return [...pads, ...quantityColumns(states)];
}

function quantityColumns(states: States): GridColumn[] {
  return states.data.quantities.flatMap((quantity): GridColumn[] => {
    const variable = states.variable(quantity.name);
    if (!variable || ['speed', 'load_x', 'load_y', 'path'].includes(quantity.name)) return [];
    const unit = quantity.unit === 'degree' ? '°' : quantity.unit;
    return [{ ...quantity, unit: unit === '°' ? '' : unit, label: unit === '°' ? `${quantity.label} (°)` : quantity.label, words: variable.words, value: (place) => states.numberAt(quantity.name, place) }];
  });
}

function sectionsOf(states: States, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const { label, speed, journal } = states;
  const selection = new GridSelection(states.coordinates, [speed, journal]);
  const several = states.coordinates.some(({ texts }) => texts.length > 1);
  const curves = several ? chartsOf(states).map((one) => new OverPanel(one.title, one.measures, selection, label).root) : [];
  const film = states.data.left_out.includes('pressure') ? [] : [pressureMap(states, selection), ...thicknessMap(states, selection), ...asperityMap(states, selection), thicknessChart(states, selection)];
  const loads = states.variable('normal_force_top_bump') ? [runningLoads(states, selection)] : [];
  const compared = { several: false, focus: [states], shown: [states], names: label, onChange: () => undefined };
  return [
    part(
      `${id}-film`,
      title('Running bearing'),
      gridControls(selection),
      ...(film.length > 0 ? [el('div', { class: 'halves' }, ...bearingInSpace(states, selection), el('div', {}, ...film.slice(0, 2)))] : []),
      el('div', { class: 'multiples' }, ...film.slice(2), ...(film.length > 0 ? [polarPlot(states, selection)] : []), ...runningBearing(states, selection), ...loads),
    ),
    ...(curves.length > 0 ? [part(`${id}-curves`, title('Over speed and load'), el('div', { class: 'multiples' }, ...curves))] : []),
    ...frequencySections(states, { id, title, coordinates: states.coordinates, axes: [speed, journal], value: (name, place) => states.numberAt(name, place) }),
    part(`${id}-states`, title('States'), ...limitTable(states), gridTable({ title: 'Results by state', label, coordinates: states.coordinates, columns: columnsOf(states), main: namesOfFirst(states.data.quantities) })),
    part(
      `${id}-case`,
      title('Case and origin'),
      caseSection(compared, caseKeys, { shortfalls: () => [states.attribute('status_message')].filter((text) => text !== ''), note: '' }),
    ),
  ];
}

/** Running bearings, one after the other. */
export function equilibriumView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const all = results.map((data) => new States(data as GridData));
  return {
    sections: all.flatMap((states, i) => {
      const several = all.length > 1 || !alone;
      return sectionsOf(states, `${states.data.kind}-${i + 1}`, (text) => (several ? `${text}, ${states.label}` : text), caseKeys);
    }),
    warnings: all.map((states) => gridWarnings(states)),
    entries: all.flatMap((states) => [
      ...states.data.quantities.map(entryOf).map((entry) => ({ ...entry, label: capital(entry.label) })),
      ...frequencyEntries(states),
      ...(states.pads > 1 ? [{ name: 'pad_force', label: 'Force of a pad', unit: 'N', text: padForce }] : []),
    ]),
  };
}
