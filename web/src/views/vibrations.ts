import { FamilyPanel, type Loops } from '../charts/family';
import { padCoordinate, padParts } from '../charts/grid_pads';
import { OverPanel, type Measure, type Part } from '../charts/over';
import { valueText } from '../data/case_values';
import type { CaseKeys, GridData, ResultData } from '../data/format';
import { Grid, numbersOf, vectorText, type Coordinate, type Place } from '../data/grid';
import { directionName } from '../data/kinds';
import { gridWarnings } from '../data/outcome';
import { at, capital } from '../data/run';
import { caseSection } from '../tables/case';
import type { Entry } from '../tables/glossary';
import { columnOf, gridTable, namesOfFirst, type GridColumn } from '../tables/grid';
import { el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { gridControls } from './grid_controls';
import { foldCase, part, type View } from './view';

const entries = ['xx', 'xy', 'yx', 'yy'] as const;

interface Coordinates {
  load: Coordinate;
  /** Direction, or sense of an orbit. */
  motion: Coordinate;
  amplitude: Coordinate;
  frequency: Coordinate;
}

function isOrbit(grid: Grid): boolean {
  return grid.variable('sense') !== undefined;
}

function coordinatesOf(grid: Grid): Coordinates {
  const y = numbersOf(grid, 'load_y');
  const amplitudes = numbersOf(grid, 'amplitude');
  const frequencies = numbersOf(grid, 'frequency');
  return {
    load: { name: 'load', title: 'Static load', texts: numbersOf(grid, 'load_x').map((x, i) => vectorText(x, at(y, i), 'N')), unit: '' },
    motion: isOrbit(grid)
      ? { name: 'sense', title: 'Sense', texts: ['Counterclockwise', 'Clockwise'], unit: '' }
      : { name: 'direction', title: 'Direction', texts: numbersOf(grid, 'direction').map(directionName), unit: '' },
    amplitude: { name: 'amplitude', title: 'Amplitude', texts: amplitudes.map((size) => valueText(size, 'm')), numbers: amplitudes, unit: 'm' },
    frequency: {
      name: 'frequency',
      title: 'Frequency',
      texts: frequencies.map((frequency) => `${Number((frequency / (2 * Math.PI)).toPrecision(5))} Hz`),
      numbers: frequencies,
      unit: 'rad/s',
    },
  };
}

/** A variable as a part of a measure, with a factor; nothing where it is known nowhere. */
function partOf(grid: Grid, name: string, text: string, key: string, factor = (_: Place): number => 1): Part[] {
  const variable = grid.variable(name);
  if (!variable?.values.some(Number.isFinite)) return [];
  return [{ key, text, has: (dimension) => dimension !== 'frequency' && variable.has(dimension), value: (place) => variable.at(place) * factor(place) }];
}

/** All parts in one chart, and each by itself: then lines tell loads apart. */
function measuresOf(text: string, unit: string, parts: Part[]): Measure[] {
  const each = parts.map((one) => ({ text: one.text, unit, parts: [one] }));
  return parts.length > 1 ? [{ text, unit, parts }, ...each] : each;
}

/** Their charts, each of quantities of one unit. */
function chartsOf(grid: Grid): { title: string; measures: Measure[] }[] {
  const omega = numbersOf(grid, 'frequency')[0] ?? NaN;
  const ofName = (name: string, text: string): Measure[] => measuresOf(text, '', partOf(grid, name, text, name));
  return [
    { title: 'Stiffness', measures: measuresOf('Stiffness K', 'N/m', entries.flatMap((axes) => partOf(grid, `k${axes}`, `K${axes}`, `k${axes}_N_per_m`))) },
    {
      // The same at every frequency.
      title: 'Damping',
      measures: measuresOf('Damping ωc', 'N/m', entries.flatMap((axes) => partOf(grid, `c${axes}`, `ωc${axes}`, `omega_c${axes}_N_per_m`, () => omega))),
    },
    { title: 'Loss factor', measures: [...ofName('loss_factor', 'Loss factor'), ...ofName('harmonic_residual', 'Harmonic residual')] },
    {
      title: 'Maximum forces of the pads',
      measures: measuresOf('Maximum force', 'N', padParts(grid, ['max_pad_forces'], '_N')),
    },
    { title: 'Other quantities', measures: otherMeasuresOf(grid) },
  ].filter(({ measures }) => measures.length > 0);
}

/** Of every number that has no chart of its own. */
function otherMeasuresOf(grid: Grid): Measure[] {
  const { vibrations, loads } = columnsOf(grid);
  return [...vibrations, ...loads]
    .filter(({ name, words }) => words.length === 0 && name !== 'loss_factor' && name !== 'harmonic_residual')
    .flatMap(({ name, key, label, unit }) => measuresOf(capital(label), unit, partOf(grid, name, capital(label), key)));
}

function loopsOf(grid: Grid): Loops | undefined {
  const displacement = grid.variable('displacement');
  const [x, y] = [grid.variable('force_x'), grid.variable('force_y')];
  if (!displacement || !x || !y) return undefined;
  // Those of orbits are drawn over X.
  const orbit = isOrbit(grid);
  const angles = orbit ? [] : numbersOf(grid, 'direction').map((degrees) => (degrees * Math.PI) / 180);
  const force = (key: string, text: string, turn: number): Loops['forces'][number] => ({
    key,
    text,
    title: orbit ? `Force ${text}` : `${text} force`,
    values: (place) => {
      const angle = (orbit ? 0 : (angles[place['direction'] ?? 0] ?? NaN)) + turn;
      const forceY = y.along(place);
      return x.along(place).map((forceX, i) => forceX * Math.cos(angle) + at(forceY, i) * Math.sin(angle));
    },
  });
  return {
    counter: 'point',
    displacement: (place) => displacement.along(place),
    forces: orbit
      ? [force('force_x', 'X', 0), force('force_y', 'Y', Math.PI / 2)]
      : [force('force_direct', 'Direct', 0), force('force_cross', 'Cross', Math.PI / 2)],
  };
}

function columnsOf(grid: Grid): Record<'vibrations' | 'coefficients' | 'loads' | 'pads' | 'padsAtLoads', GridColumn[]> {
  const of = (name: string, label: string): GridColumn[] => columnOf(grid, name, label);
  return {
    vibrations: grid.data.quantities.flatMap(({ name, label }) => of(name, label)),
    coefficients: [
      ...entries.flatMap((axes) => of(`k${axes}`, `K${axes}`)),
      ...entries.flatMap((axes) => of(`c${axes}`, `c${axes}`)),
      ...of('loss_factor_x', 'loss factor X'),
      ...of('loss_factor_y', 'loss factor Y'),
      ...of('residual', 'residual'),
    ],
    loads: [
      ...of('load_status', 'status'),
      ...of('x', 'journal X'),
      ...of('y', 'journal Y'),
      ...entries.flatMap((axes) => of(`k${axes}_stuck`, `K${axes}, full stick`)),
      ...entries.flatMap((axes) => of(`k${axes}_further`, `K${axes}, sliding`)),
    ],
    pads: of('max_pad_forces', 'maximum force'),
    padsAtLoads: [...of('load_pad_force_x', 'force X'), ...of('load_pad_force_y', 'force Y')],
  };
}

/** What the sections of vibrations are called, and what they are of. */
export interface VibrationSections {
  id: string;
  title: (text: string) => string;
  /** Of the first. */
  name: string;
  /** Beside the case. */
  note: string;
  /** Swept keys, if any: they come before loads and amplitudes. */
  keys: Coordinate[];
}

/** The sections of vibrations, of one run or of the points of a sweep. */
export function vibrationSections(grid: Grid, caseKeys: CaseKeys, { id, title, name: first, note, keys }: VibrationSections): HTMLElement[] {
  const { load, motion, amplitude, frequency } = coordinatesOf(grid);
  const selection = new GridSelection([...keys, load, motion, amplitude], [...keys, amplitude, load]);
  const loops = loopsOf(grid);
  const charts = chartsOf(grid).map(({ title: name, measures }) => new OverPanel(name, measures, selection, grid.label).root);
  const columns = columnsOf(grid);
  const { label } = grid;
  const compared = { several: false, focus: [grid], shown: [grid], names: label, onChange: () => undefined };
  const ofCase = caseSection(compared, caseKeys, { shortfalls: () => [grid.attribute('status_message')].filter((text) => text !== ''), note });
  return [
    part(
      `${id}-charts`,
      title(first),
      gridControls(selection),
      el('div', { class: 'multiples' }, ...charts, ...(loops ? [new FamilyPanel(loops, selection, label).root] : [])),
    ),
    part(
      `${id}-tables`,
      title('Coefficients'),
      gridTable({
        title: 'Coefficients by load',
        label,
        coordinates: [...keys, load, amplitude, frequency],
        columns: columns.coefficients,
        main: ['k', 'c'].flatMap((letter) => entries.map((axes) => `${letter}${axes}`)),
      }),
      gridTable({
        title: 'Loops by vibration',
        label,
        coordinates: [...keys, load, motion, amplitude],
        columns: columns.vibrations,
        main: namesOfFirst(grid.data.quantities),
      }),
      gridTable({ title: 'At the static loads', label, coordinates: [...keys, load], columns: columns.loads, main: [] }),
      ...padCoordinate(grid).flatMap((pad) => [
        gridTable({ title: 'Maximum force of each pad, by vibration', label, coordinates: [...keys, load, motion, amplitude, pad], columns: columns.pads, main: [] }),
        gridTable({ title: 'Forces of the pads at the static loads', label, coordinates: [...keys, load, pad], columns: columns.padsAtLoads, main: [] }),
      ]),
    ),
    part(`${id}-case`, title('Case and origin'), keys.length > 0 ? foldCase(ofCase) : ofCase),
  ];
}

/** Of the glossary. */
export function vibrationEntries(grid: Grid): Entry[] {
  return Object.values(columnsOf(grid)).flat().map(({ name, label, unit, meaning }) => ({ name, label, unit, text: meaning }));
}

/** Vibrations about static loads, one run after the other. */
export function vibrationView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const grids = results.map((data) => new Grid(data as GridData));
  return {
    sections: grids.flatMap((grid, i) => {
      const several = grids.length > 1 || !alone;
      const title = (text: string): string => (several ? `${text}, ${grid.label}` : text);
      return vibrationSections(grid, caseKeys, { id: `vibration-${i + 1}`, title, name: 'Vibrations', note: '', keys: [] });
    }),
    warnings: grids.map((grid) => gridWarnings(grid)),
    entries: grids.flatMap(vibrationEntries),
  };
}
