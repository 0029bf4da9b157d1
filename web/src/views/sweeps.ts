import { FamilyPanel, type Loops } from '../charts/family';
import { OverPanel, type Measure } from '../charts/over';
import { Limit, mapPanel } from '../charts/map';
import { sweptWaterfall } from '../charts/waterfall';
import { flatten } from '../data/case_values';
import { coordinateOf } from '../data/coordinates';
import type { CaseKeys, GridData, Quantity, ResultData, SweepSummary } from '../data/format';
import { Grid, numbersOf, placesOf, vectorText, type Coordinate, type Place, type Variable } from '../data/grid';
import { kinds } from '../data/kinds';
import { mainQuantities } from '../data/main_quantities';
import { gridWarnings } from '../data/outcome';
import { at, capital } from '../data/run';
import { formatQuantity } from '../data/units';
import { inRevolutions } from '../data/whirls';
import { caseSection } from '../tables/case';
import { entryOf } from '../tables/glossary';
import { gridTable, namesOfFirst } from '../tables/grid';
import { el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { frequencyEntries, frequencySections } from './frequencies';
import { gridControls } from './grid_controls';
import { vibrationEntries, vibrationSections } from './vibrations';
import { fold, foldCase, part, type View } from './view';

/** A quantity of every point and cycle. */
interface SweptQuantity extends Quantity {
  variable: Variable;
  value: (place: Place) => number;
}

function axesOf(grid: Grid): SweepSummary['axes'] {
  return (grid.data.summary as SweepSummary).axes;
}

/** The swept keys. */
function keysOf(grid: Grid): Coordinate[] {
  return axesOf(grid).map(({ name }) => ({ ...coordinateOf(grid, name), title: grid.variable(name)?.text ?? name }));
}

function isOfRotors(grid: Grid): boolean {
  return ['stability', 'unbalance', 'transient'].includes(grid.attribute('swept_command'));
}

/** Of running bearings: speeds, and loads or positions; of rotors, speeds. */
function operatingPointsOf(grid: Grid): Coordinate[] {
  const rpm = numbersOf(grid, 'speed').map((speed) => (speed * 30) / Math.PI);
  const speed = { name: 'speed', title: 'Speed', texts: rpm.map((one) => (Number.isFinite(one) ? `${Number(one.toPrecision(6))} rpm` : 'as swept')), numbers: rpm, unit: 'rpm' };
  if (isOfRotors(grid)) return [speed];
  const [journal, title, unit] = grid.variable('load') ? ['load', 'Load', 'N'] : ['position', 'Position', 'm'];
  const y = numbersOf(grid, `${journal}_y`);
  return [
    speed,
    { name: journal, title, texts: numbersOf(grid, `${journal}_x`).map((x, i) => vectorText(x, at(y, i), unit)), unit: '' },
  ];
}

/** What tells the parts of a point apart. */
function partsOf(grid: Grid): Coordinate[] {
  if (grid.variable('station')) {
    const places = numbersOf(grid, 'station_z').map((z) => formatQuantity(z, 'm'));
    return [{ name: 'station', title: 'Station', texts: numbersOf(grid, 'station').map((number, i) => `station ${number} at ${places[i] ?? ''}`), unit: '' }];
  }
  if (grid.variable('speed')) return operatingPointsOf(grid);
  const kind = kinds[grid.attribute('swept_command')];
  const name = ['direction', 'cycle'].find((one) => grid.variable(one));
  if (kind && name) return [{ name, title: kind.cycles.title, texts: numbersOf(grid, name).map(kind.cycles.name), unit: '' }];
  const dims = new Set(grid.data.quantities.flatMap((quantity) => grid.variable(quantity.name)?.dims ?? []));
  for (const key of axesOf(grid)) dims.delete(key.name);
  return [...dims].map((dim) => coordinateOf(grid, dim));
}

function quantitiesOf(grid: Grid): SweptQuantity[] {
  const keys = axesOf(grid).map(({ name }) => name);
  const clearances = grid.data.quantities.filter(({ name }) => name.startsWith('clearance_'));
  const quantities = grid.data.quantities.flatMap((quantity): SweptQuantity[] => {
    // Clearances are a list, over its forces.
    const force = clearances.indexOf(quantity);
    const variable = grid.variable(force < 0 ? quantity.name : 'clearance');
    // What is the same at all points is a coordinate.
    if (!variable?.dims.some((name) => keys.includes(name))) return [];
    const shown = isOfRotors(grid) ? inRevolutions(quantity) : quantity;
    return [{ ...shown, variable, value: (place) => variable.at(force < 0 ? place : { ...place, clearance_force: force }) }];
  });
  return [...quantities.filter((one) => !one.of_solver), ...quantities.filter((one) => one.of_solver)];
}

/** Of every quantity that is a number and known somewhere; what charts begin with first. */
function measuresOf(quantities: SweptQuantity[]): Measure[] {
  const numbers = quantities.filter(({ variable }) => variable.words.length === 0 && variable.values.some(Number.isFinite));
  const sorted = [...numbers.filter((one) => one.leads), ...numbers.filter((one) => !one.leads)];
  return sorted.map(({ key, label, unit, variable, value }) => ({
    text: capital(label),
    unit,
    parts: [{ key, text: capital(label), has: (dimension: string) => variable.has(dimension), value }],
  }));
}

/** Limits that cases give. */
const limitsOfCases = [
  { name: 'h_min', least: true, path: 'film.h_lift_off' },
  { name: 'max_stress_top_foil', least: false, path: 'top_foil.yield_stress' },
  { name: 'max_stress_bump_foil', least: false, path: 'bump_foil.yield_stress' },
];

/** The first that the case of a sweep gives, where it is not swept itself. */
function limitOf(grid: Grid, quantities: SweptQuantity[], measures: Measure[]): { measure: Measure; least: boolean; bound: number } | undefined {
  const given = flatten(grid.data.summary.case);
  return limitsOfCases.flatMap(({ name, least, path }) => {
    const key = quantities.find((quantity) => quantity.name === name)?.key;
    const measure = measures.find(({ parts }) => at(parts, 0).key === key);
    const bound = given.get(path);
    return measure && typeof bound === 'number' && !axesOf(grid).some(({ key }) => key === path) ? [{ measure, least, bound }] : [];
  })[0];
}

/** Over two keys of numbers: the quantity, with the region that a limit leaves. */
function mapsOf(grid: Grid, keys: Coordinate[], quantities: SweptQuantity[], measures: Measure[], selection: GridSelection): HTMLElement[] {
  const axes = keys.filter(({ numbers = [] }) => new Set(numbers).size > 1);
  const [across, up] = axes;
  if (!across || !up || axes.length > 2 || measures.length === 0) return [];
  const main = mainQuantities(quantities.filter(({ key }) => measures.some(({ parts }) => at(parts, 0).key === key)));
  const sizes = (measure: Measure): number[] => placesOf([across, up]).map((place) => at(measure.parts, 0).value({ ...selection.place, ...place })).filter(Number.isFinite);
  const limit = new Limit(measures, sizes, limitOf(grid, quantities, measures));
  const panels = main.flatMap(({ key }) => measures.filter(({ parts }) => at(parts, 0).key === key)).map((measure) => mapPanel(measures, measure, [across, up], selection, limit, grid.label));
  return [limit.root, el('div', { class: 'multiples maps' }, ...panels)];
}

function loopsOf(grid: Grid): Loops | undefined {
  const displacement = grid.variable('displacement');
  const force = grid.variable('force_direct');
  if (!displacement || !force) return undefined;
  const title = kinds[grid.attribute('swept_command')]?.force ?? 'Force';
  return {
    counter: 'increment',
    displacement: (place) => displacement.along(place),
    forces: [{ key: 'force_direct', text: 'Direct', title, values: (place) => force.along(place) }],
  };
}

/** A key and the values that it takes. */
function sweptText({ title, texts }: Coordinate): string {
  const range = `${texts[0] ?? ''} to ${texts[texts.length - 1] ?? ''} (${texts.length} values)`;
  return `${title} ${texts.length <= 4 ? texts.join(', ') : range}`;
}

function isOfVibrations(grid: Grid): boolean {
  return grid.attribute('swept_command') === 'vibration';
}

function sectionsOf(grid: Grid, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const keys = keysOf(grid);
  const note = `The case of the first point. Swept: ${keys.map(sweptText).join('; ')}.`;
  if (isOfVibrations(grid)) return vibrationSections(grid, caseKeys, { id, title, name: 'Sweep', note, keys });
  const coordinates = [...keys, ...partsOf(grid)];
  // Of parts, speeds lie on an axis; loads are chosen along, too.
  const axes = coordinates.filter(({ name, numbers }) => numbers !== undefined || name === 'load' || name === 'position');
  const selection = new GridSelection(coordinates, axes);
  const quantities = quantitiesOf(grid);
  const loops = loopsOf(grid);
  const measures = measuresOf(quantities);
  const over = measures.length > 0 ? [new OverPanel('Result vs. parameter', measures, selection, grid.label).root] : [];
  const spectra = grid.variable('last_spectrum_speed')?.values.some(Number.isFinite) ? [sweptWaterfall(grid, selection)] : [];
  const charts = [...over, ...(loops ? [new FamilyPanel(loops, selection, grid.label).root] : []), ...spectra];
  const compared = { several: false, focus: [grid], shown: [grid], names: grid.label, onChange: () => undefined };
  const tableOf = (name: string, those: SweptQuantity[], along: Coordinate[]): HTMLElement =>
    gridTable({ title: name, label: grid.label, coordinates: along, columns: those.map((quantity) => ({ ...quantity, words: quantity.variable.words })), main: namesOfFirst(those) });
  // Of rotors some are of all speeds.
  const ofPoints = quantities.filter(({ variable }) => isOfRotors(grid) && !variable.has('speed'));
  const ofParts = quantities.filter((one) => !ofPoints.includes(one));
  return [
    part(`${id}-charts`, title('Sweep'), gridControls(selection), ...mapsOf(grid, keys, quantities, measures, selection), el('div', { class: 'multiples' }, ...charts)),
    ...frequencySections(grid, { id, title, coordinates, axes, value: (name, place) => grid.variable(name)?.at(place) ?? NaN }),
    part(
      `${id}-points`,
      title('Points'),
      fold(
        `${quantities.length} quantities at ${placesOf(keys).length} points`,
        ...(ofPoints.length > 0 ? [tableOf('Results by point', ofPoints, keys)] : []),
        ...(ofParts.length > 0 ? [tableOf(ofPoints.length > 0 ? 'Results by point and speed' : 'Results by point', ofParts, coordinates)] : []),
      ),
    ),
    part(
      `${id}-case`,
      title('Case and origin'),
      foldCase(caseSection(compared, caseKeys, { shortfalls: () => [grid.attribute('status_message')].filter((text) => text !== ''), note })),
    ),
  ];
}

/** Sweeps, one after the other. */
export function sweepView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const grids = results.map((data) => new Grid(data as GridData));
  return {
    sections: grids.flatMap((grid, i) => {
      const several = grids.length > 1 || !alone;
      return sectionsOf(grid, `sweep-${i + 1}`, (text) => (several ? `${text}, ${grid.label}` : text), caseKeys);
    }),
    warnings: grids.map((grid) => gridWarnings(grid)),
    entries: grids.flatMap((grid) => (isOfVibrations(grid) ? vibrationEntries(grid) : [...quantitiesOf(grid).map(entryOf), ...frequencyEntries(grid)])),
  };
}
