import { OverPanel, type Measure } from '../charts/over';
import { coordinateOf } from '../data/coordinates';
import type { CaseKeys, GridData, ResultData } from '../data/format';
import { Grid, type Coordinate } from '../data/grid';
import { gridWarnings } from '../data/outcome';
import { capital } from '../data/run';
import { inRevolutions } from '../data/whirls';
import { caseSection } from '../tables/case';
import { columnOf, gridTable, inDegrees, namesOfFirst, type GridColumn } from '../tables/grid';
import { el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { gridControls } from './grid_controls';
import { part, type View } from './view';

/** Quantities of more values are listed, and not shown: increments of a march. */
const mostValues = 20000;

/** Quantities over the same dimensions. */
interface Group {
  coordinates: Coordinate[];
  columns: GridColumn[];
}

/** All variables but coordinates by their dimensions, in the order of the experiment; what it does not name comes last. */
function groupsOf(grid: Grid): Group[] {
  const labels = new Map(grid.data.quantities.map(({ name, label }) => [name, label]));
  const names = [...new Set([...labels.keys(), ...Object.keys(grid.data.variables)])];
  const groups = new Map<string, Group>();
  for (const name of names) {
    const { dims } = grid.variable(name) ?? {};
    if (!dims || dims.join() === name) continue;
    const group = groups.get(dims.join()) ?? { coordinates: dims.map((dim) => coordinateOf(grid, dim)), columns: [] };
    group.columns.push(...columnOf(grid, name, labels.get(name) ?? name.replaceAll('_', ' ')).map(inRevolutions).map(inDegrees));
    groups.set(dims.join(), group);
  }
  return [...groups.values()];
}

function sizeOf({ coordinates }: Group): number {
  return coordinates.reduce((size, { texts }) => size * texts.length, 1);
}

/** "Results by load, amplitude and frequency" */
function titleOf({ coordinates }: Group): string {
  const names = new Intl.ListFormat('en-GB').format(coordinates.map(({ title }) => title.toLowerCase()));
  return names === '' ? 'Results' : `Results by ${names}`;
}

/** A chart of every number of a group that is known somewhere; nothing where there is nothing to draw it over. */
function chartOf(grid: Grid, group: Group): HTMLElement[] {
  const { coordinates, columns } = group;
  const axes = coordinates.filter(({ numbers, texts }) => numbers && texts.length > 1);
  const measures = columns
    .filter(({ name, words }) => words.length === 0 && grid.variable(name)?.values.some(Number.isFinite))
    .map(({ key, label, unit, value }): Measure => ({ text: capital(label), unit, parts: [{ key, text: capital(label), has: () => true, value }] }));
  if (axes.length === 0 || measures.length === 0) return [];
  const selection = new GridSelection(coordinates, axes);
  const title = `${titleOf(group)}: chart`;
  const names = { along: `${title}, over`, by: `${title}, lines`, at: (one: string): string => `${title}, ${one} shown` };
  return [gridControls(selection, names), el('div', { class: 'multiples' }, new OverPanel(title, measures, selection, grid.label).root)];
}

function panelsOf(grid: Grid, group: Group): HTMLElement[] {
  const { coordinates, columns } = group;
  const title = titleOf(group);
  const size = sizeOf(group);
  if (size === 0) return [];
  if (size > mostValues) return [el('p', { class: 'note' }, `${title}: ${columns.map(({ label }) => label).join(', ')} have ${size} values each, too many for this page.`)];
  return [...chartOf(grid, group), gridTable({ title, label: grid.label, coordinates, columns, main: namesOfFirst(grid.data.quantities) })];
}

function sectionsOf(grid: Grid, groups: Group[], id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const compared = { several: false, focus: [grid], shown: [grid], names: grid.label, onChange: () => undefined };
  return [
    part(`${id}-results`, title(`Results of ${grid.data.kind}`), ...groups.flatMap((group) => panelsOf(grid, group))),
    part(
      `${id}-case`,
      title('Case and origin'),
      caseSection(compared, caseKeys, { shortfalls: () => [grid.attribute('status_message')].filter((text) => text !== ''), note: '' }),
    ),
  ];
}

/** Results of experiments without a view of their own, one after the other. */
export function otherView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const all = results.map((data) => new Grid(data as GridData)).map((grid) => ({ grid, groups: groupsOf(grid) }));
  return {
    sections: all.flatMap(({ grid, groups }, i) => {
      const several = all.length > 1 || !alone;
      return sectionsOf(grid, groups, `${grid.data.kind}-${i + 1}`, (text) => (several ? `${text}, ${grid.label}` : text), caseKeys);
    }),
    warnings: all.map(({ grid }) => gridWarnings(grid)),
    entries: all.flatMap(({ groups }) => groups.flatMap(({ columns }) => columns.map(({ name, label, unit, meaning }) => ({ name, label, unit, text: meaning })))),
  };
}
