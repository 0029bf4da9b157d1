import { padCoordinate, padParts } from '../charts/grid_pads';
import { OverPanel, type Measure } from '../charts/over';
import { PlanePanel, type PlaneVector } from '../charts/plane';
import type { CaseKeys, GridData, ResultData } from '../data/format';
import { Grid, numbersOf, type Coordinate } from '../data/grid';
import { gridWarnings } from '../data/outcome';
import { caseSection } from '../tables/case';
import { columnOf, gridTable, type GridColumn } from '../tables/grid';
import { el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { gridControls } from './grid_controls';
import { part, type View } from './view';

const entries = ['xx', 'xy', 'yx', 'yy'] as const;

function counted(name: string, title: string, numbers: number[]): Coordinate {
  return { name, title, numbers, texts: numbers.map(String), unit: '' };
}

/** Variables of one unit in one chart; those that are known somewhere. */
function measureOf(grid: Grid, text: string, unit: string, names: [string, string][]): Measure[] {
  const parts = names.flatMap(([name, label]) => {
    const variable = grid.variable(name);
    if (!variable?.values.some(Number.isFinite)) return [];
    return [{ key: name, text: label, has: (dimension: string) => variable.has(dimension), value: variable.at.bind(variable) }];
  });
  return parts.length > 0 ? [{ text, unit, parts }] : [];
}

function vectorsOf(grid: Grid): PlaneVector[] {
  const pairs = [
    { text: 'Position', unit: 'm', names: ['x', 'y'] },
    { text: 'Force', unit: 'N', names: ['force_x', 'force_y'] },
  ] as const;
  return pairs.flatMap(({ text, unit, names }) => {
    const [x, y] = names.map((name) => grid.variable(name));
    return x && y ? [{ text, unit, x, y }] : [];
  });
}

/** Forces that each of several pads carries. */
function padMeasure(grid: Grid): Measure[] {
  const parts = padParts(grid, ['pad_force_x', 'pad_force_y']);
  return parts.length > 0 ? [{ text: 'Force', unit: 'N', parts }] : [];
}

/** Charts over increments, and what they are of. */
function measuresOf(grid: Grid): { title: string; measures: Measure[] }[] {
  return [
    { title: 'Forces', measures: measureOf(grid, 'Force', 'N', [['force_x', 'X'], ['force_y', 'Y']]) },
    { title: 'Forces of the pads', measures: padMeasure(grid) },
    {
      title: 'Tangent stiffness',
      measures: [
        ...measureOf(grid, 'Sliding contacts', 'N/m', entries.map((axes) => [`k${axes}`, `K${axes}`])),
        ...measureOf(grid, 'Full stick', 'N/m', entries.map((axes) => [`k${axes}_stuck`, `K${axes}`])),
      ],
    },
    {
      title: 'Energies',
      measures: measureOf(grid, 'Energy', 'J', [['work', 'work done on the foils'], ['elastic_energy', 'elastic energy'], ['dissipated_energy', 'dissipated by friction']]),
    },
  ].filter(({ measures }) => measures.length > 0);
}

function columnsOf(grid: Grid): { path: GridColumn[]; orbits: GridColumn[]; pads: GridColumn[] } {
  return {
    pads: columnOf(grid, 'max_pad_forces', 'maximum force'),
    path: grid.data.quantities.flatMap(({ name, label }) => columnOf(grid, name, label)),
    orbits: [
      ...columnOf(grid, 'loop_energies', 'energy'),
      ...columnOf(grid, 'force_defects', 'closure error of the force'),
      ...columnOf(grid, 'position_defects', 'closure error of the position'),
    ],
  };
}

function sectionsOf(grid: Grid, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const { label } = grid;
  const increment = counted('increment', 'Increment', numbersOf(grid, 'increment'));
  const selection = new GridSelection([increment], [increment]);
  const columns = columnsOf(grid);
  const orbitOf = grid.variable('orbit');
  const orbits = counted('orbit', 'Orbit', [...new Set(numbersOf(grid, 'orbit').filter(Number.isFinite))]);
  const charts = measuresOf(grid).map((one) => new OverPanel(one.title, one.measures, selection, label).root);
  const plane = orbitOf ? [new PlanePanel(vectorsOf(grid), orbits, orbitOf, selection, label).root] : [];
  const numbers = counted('orbit_number', 'Orbit', numbersOf(grid, 'orbit_number'));
  const perOrbit = measureOf(grid, 'Energy of an orbit', 'J', [['loop_energies', 'Energy']]);
  const orbitCharts = perOrbit.length > 0 && numbers.texts.length > 1 ? [new OverPanel('Energy per orbit', perOrbit, new GridSelection([numbers], [numbers]), label).root] : [];
  const compared = { several: false, focus: [grid], shown: [grid], names: label, onChange: () => undefined };
  return [
    part(`${id}-charts`, title('Path'), gridControls(selection), el('div', { class: 'multiples' }, ...plane, ...charts, ...orbitCharts)),
    part(
      `${id}-tables`,
      title('Results'),
      gridTable({
        title: 'Results of the path',
        label,
        coordinates: [],
        columns: columns.path,
        main: ['orbit_energy', 'orbit_force_defect', 'orbit_position_defect', 'max_compression', 'max_stress_top_foil', 'max_stress_bump_foil', 'status'],
      }),
      ...(numbers.texts.length > 0 ? [gridTable({ title: 'Orbits', label, coordinates: [numbers], columns: columns.orbits, main: [] })] : []),
      ...padCoordinate(grid).map((pad) => gridTable({ title: 'Maximum force of each pad', label, coordinates: [pad], columns: columns.pads, main: [] })),
    ),
    part(
      `${id}-case`,
      title('Case and origin'),
      caseSection(compared, caseKeys, { shortfalls: () => [grid.attribute('status_message')].filter((text) => text !== ''), note: '' }),
    ),
  ];
}

/** Paths of the journal, one after the other. */
export function pathView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const grids = results.map((data) => new Grid(data as GridData));
  return {
    sections: grids.flatMap((grid, i) => {
      const several = grids.length > 1 || !alone;
      return sectionsOf(grid, `path-${i + 1}`, (text) => (several ? `${text}, ${grid.label}` : text), caseKeys);
    }),
    warnings: grids.map((grid) => gridWarnings(grid)),
    entries: grids.flatMap((grid) => {
      const { path, orbits, pads } = columnsOf(grid);
      return [...path, ...orbits, ...pads].map(({ name, label, unit, meaning }) => ({ name, label, unit, text: meaning }));
    }),
  };
}
