import { OverPanel, type Measure, type Part } from '../charts/over';
import { numbersOf, type Coordinate, type Grid, type Place } from '../data/grid';
import type { Entry } from '../tables/glossary';
import { gridTable, type GridColumn } from '../tables/grid';
import { el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { gridControls, type ControlNames } from './grid_controls';
import { part } from './view';

const entries = ['xx', 'xy', 'yx', 'yy'] as const;

/** Stiffness, then damping, of contacts that slip on and of stuck ones. */
const kinds = [
  { letter: 'k', symbol: 'K', stuck: '', text: 'Stiffness K' },
  { letter: 'k', symbol: 'K', stuck: '_stuck', text: 'Stiffness K, full stick' },
  { letter: 'c', symbol: 'c', stuck: '', text: 'Damping c' },
  { letter: 'c', symbol: 'c', stuck: '_stuck', text: 'Damping c, full stick' },
] as const;

/** Other sections have controls of the same labels. */
const names: ControlNames = { along: 'Frequencies: over', by: 'Frequencies: lines', at: (title) => `Frequencies: ${title}` };

/** Where small motions of running bearings are looked at. */
export interface Motions {
  id: string;
  title: (text: string) => string;
  /** What tells states apart. */
  coordinates: Coordinate[];
  /** Those of them that charts may go along. */
  axes: Coordinate[];
  value: (name: string, place: Place) => number;
}

/** Coefficients over the frequency, or at one that every state has. */
type Of = '_at_frequency' | '_whirl';

function columnsOf(grid: Grid, value: Motions['value'], of: Of = '_at_frequency'): GridColumn[] {
  return kinds.flatMap(({ letter, symbol, stuck }) =>
    entries.flatMap((axes): GridColumn[] => {
      const name = `${letter}${axes}${of}${stuck}`;
      const variable = grid.variable(name);
      if (!variable) return [];
      const { unit, text } = variable;
      const key = variable.key.replace(of, ''); // as in coefficients.csv
      return [{ key, name, label: `${symbol}${axes}${stuck === '' ? '' : ', full stick'}`, unit, whole: false, meaning: text, words: [], value: (place) => value(name, place) }];
    }),
  );
}

/** Stiffness, then damping: all four together, each by itself, and the same of full stick. */
function chartsOf(columns: GridColumn[], of: Of): Measure[][] {
  return (['N/m', 'N s/m'] as const).map((unit) =>
    kinds.flatMap(({ letter, stuck, text }): Measure[] => {
      const parts = columns
        .filter((one) => one.unit === unit && one.name.startsWith(letter) && one.name.endsWith(`${of}${stuck}`))
        .map(({ key, label, value }): Part => ({ key, text: label, has: () => true, value }));
      return parts.length === 0 ? [] : [{ text, unit, parts }, ...parts.map((one) => ({ text: one.text, unit, parts: [one] }))];
    }),
  );
}

/** Charts of stiffness and damping in a whirl at the speed of every state. */
export function synchronousCharts(grid: Grid, value: Motions['value']): { title: string; measures: Measure[] }[] {
  return chartsOf(columnsOf(grid, value, '_whirl'), '_whirl').map((measures, i) => ({ title: i === 0 ? 'Synchronous stiffness' : 'Synchronous damping', measures }));
}

/** Of the glossary. */
export function frequencyEntries(grid: Grid): Entry[] {
  return columnsOf(grid, () => NaN).map(({ name, label, unit, meaning }) => ({ name, label: `frequency-dependent ${label}`, unit, text: meaning }));
}

/** Stiffness and damping of running bearings over the frequency of small motions; none where no file has them. */
export function frequencySections(grid: Grid, { id, title, coordinates, axes, value }: Motions): HTMLElement[] {
  const frequencies = numbersOf(grid, 'frequency');
  if (frequencies.length === 0) return [];
  const frequency: Coordinate = {
    name: 'frequency',
    title: 'Frequency',
    texts: frequencies.map((one) => `${Number((one / (2 * Math.PI)).toPrecision(5))} Hz`),
    numbers: frequencies,
    unit: 'rad/s',
  };
  const selection = new GridSelection([...coordinates, frequency], [frequency, ...axes]);
  const columns = columnsOf(grid, value);
  const panels = chartsOf(columns, '_at_frequency').map((own, i) => new OverPanel(i === 0 ? 'Frequency-dependent stiffness' : 'Frequency-dependent damping', own, selection, grid.label).root);
  return [
    part(
      `${id}-frequency`,
      title('Frequency-dependent coefficients'),
      gridControls(selection, names),
      el('div', { class: 'multiples' }, ...panels),
      gridTable({
        title: 'Coefficients by frequency',
        label: grid.label,
        coordinates: [...coordinates, frequency],
        columns,
        main: columns.filter(({ name }) => name.endsWith('at_frequency')).map(({ name }) => name),
      }),
    ),
  ];
}
