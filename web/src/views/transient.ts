import { marchedOrbits } from '../charts/marched_orbits';
import { OverPanel, type Measure, type Part } from '../charts/over';
import { waterfall } from '../charts/waterfall';
import { varies } from '../data/bands';
import type { CaseKeys, ResultData, TransientData } from '../data/format';
import type { Place } from '../data/grid';
import { gridWarnings } from '../data/outcome';
import { capital } from '../data/run';
import { speedText } from '../data/states';
import { TimeRun } from '../data/time_run';
import { formatNumber, formatQuantity } from '../data/units';
import { caseSection } from '../tables/case';
import { energyTable } from '../tables/energy';
import { entryOf, term } from '../tables/glossary';
import { columnOf, gridTable, inDegrees, namesOfFirst, type GridColumn } from '../tables/grid';
import { rubTable } from '../tables/rubs';
import { choice, el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import { valueChooser } from './grid_controls';
import { part, type View } from './view';

function quantityOf(run: TimeRun, name: string): { label: string; meaning: string } {
  return run.data.quantities.find((one) => one.name === name) ?? { label: name, meaning: '' };
}

function tiles(run: TimeRun): HTMLElement {
  const tile = (what: HTMLElement | string, value: string, more = ''): HTMLElement =>
    el('div', { class: 'tile', role: 'listitem' }, el('span', { class: 'what' }, what), el('strong', {}, value), ...(more === '' ? [] : [el('span', { class: 'change' }, more)]));
  const { revolutions, rub_count: rubs, status } = run.summary;
  const totals = [...namesOfFirst(run.data.quantities).filter((name) => run.variable(name)?.dims.length === 0), 'energy_defect_of_run'];
  const numbers = (revolutions > 0 ? totals : []).flatMap((name) => {
    const variable = run.variable(name);
    const value = run.total(name);
    if (!variable || !Number.isFinite(value) || (name === 'largest_asperity_load_of_run' && value === 0)) return [];
    const { label, meaning } = quantityOf(run, name);
    const text = name === 'energy_defect_of_run' ? `${formatNumber(100 * value, 2)} %` : formatQuantity(value, variable.unit);
    return [tile(term(name, name === 'energy_defect_of_run' ? 'balance of energy met to' : label, meaning), text)];
  });
  return el(
    'div',
    { class: 'tiles', role: 'list', 'aria-label': 'Main results' },
    tile('Status', run.ending === 'converged' ? status : run.ending),
    tile('Whole revolutions', String(revolutions), `in ${formatQuantity(run.total('end_time'), 's')}, to ${speedText(run.total('end_speed'))}`),
    ...numbers,
    ...(rubs > 0 ? [tile('Rubs', String(rubs))] : []),
  );
}

const overRevolutions = (dimension: string): boolean => dimension === 'revolution';

/** Of the station that is looked at; such as were found somewhere. */
function stationParts(run: TimeRun, names: [string, string][]): Part[] {
  return names.flatMap(([name, text]): Part[] => {
    const variable = run.variable(name);
    return variable?.values.some(Number.isFinite) ? [{ key: variable.key, text, has: (dimension) => variable.has(dimension), value: (place) => variable.at(place) }] : [];
  });
}

function bearingMeasure(run: TimeRun, name: string): Measure[] {
  const variable = run.variable(name);
  const text = capital(quantityOf(run, name).label);
  // Of runs without asperities none carry anything.
  if (!variable?.values.some((value) => Number.isFinite(value) && value !== 0)) return [];
  const parts = Array.from({ length: run.bearings }, (_, station): Part => ({
    key: run.bearings > 1 ? `${variable.key}_${station + 1}` : variable.key,
    text: run.bearings > 1 ? (run.station.texts[station] ?? '') : text,
    has: overRevolutions,
    value: (place) => variable.at({ ...place, station }),
  }));
  return [{ text, unit: variable.unit, parts }];
}

function wholeParts(run: TimeRun, names: string[]): Part[] {
  return names.flatMap((name): Part[] => {
    const variable = run.variable(name);
    if (!variable?.values.some((value) => Number.isFinite(value) && value !== 0)) return [];
    return [{ key: variable.key, text: capital(quantityOf(run, name).label), has: overRevolutions, value: (place) => variable.at(place) }];
  });
}

function measure(text: string, unit: string, parts: Part[]): Measure[] {
  return parts.length > 0 ? [{ text, unit, parts }] : [];
}

/** Charts over the revolutions, each with its choice of quantities. */
function chartsOf(run: TimeRun): { title: string; measures: Measure[] }[] {
  const amplitudes = ['x', 'y'].flatMap((axis) =>
    measure(
      `Amplitude along ${axis.toUpperCase()}`,
      'm',
      stationParts(run, [
        [`half_peak_to_peak_${axis}`, 'half peak-to-peak'],
        [`amplitude_${axis}`, '1x'],
        [`amplitude_${axis}_half`, '½x'],
        [`amplitude_${axis}_2x`, '2x'],
      ]),
    ),
  );
  const mean = measure('Mean position', 'm', stationParts(run, [['mean_x', 'X'], ['mean_y', 'Y']]));
  // Points of a Poincare section: one level where orbits repeat themselves, several where they take several revolutions.
  const section = measure('Position at the end of a revolution', 'm', stationParts(run, [['section_x', 'X'], ['section_y', 'Y']]));
  const phase = measure('Phase at 1x (°)', '', stationParts(run, [['phase_x', 'X'], ['phase_y', 'Y']]));
  const single = (name: string, text: string, unit: string): Measure[] => measure(text, unit, wholeParts(run, [name]));
  const speed = single('revolution_speed', 'Speed', 'rpm').map((one) => ({ ...one, parts: one.parts.map((own): Part => ({ ...own, value: (place: Place) => Math.abs(own.value(place)) })) }));
  const balance = ['revolution_force_work', 'revolution_film_work', 'revolution_rubbing_work', 'revolution_friction_loss', 'revolution_rotor_damping_loss', 'revolution_stored_energy', 'energy_defect'];
  return [
    { title: 'Motion', measures: [...amplitudes, ...mean, ...section, ...phase] },
    { title: 'Film', measures: [...bearingMeasure(run, 'thinnest_film'), ...bearingMeasure(run, 'largest_asperity_load')] },
    { title: 'Speed and losses', measures: [...speed, ...bearingMeasure(run, 'mean_power')] },
    {
      title: 'Energy',
      measures: [
        ...measure('Energy in a revolution', 'J', wholeParts(run, balance)),
        ...single('revolution_friction_loss', 'Friction loss in a revolution', 'J'),
        ...single('revolution_film_dissipation', 'Dissipation of the films in a revolution', 'J'),
        ...single('energy_defect', 'Defect of the balance in a revolution', 'J'),
      ],
    },
  ].filter(({ measures }) => measures.length > 0);
}

function controls(run: TimeRun, selection: GridSelection): HTMLElement[] {
  const alongs = selection.axes.map((value) => ({ value, text: `Over ${value === run.speed ? 'speed' : value.title.toLowerCase()}` }));
  const all = [
    ...(run.numbers.length > 1 ? [choice('What charts go along', alongs, selection.along, (along) => selection.show({ along }))] : []),
    ...(run.station.texts.length > 1 ? [valueChooser(selection, run.station, 'Station shown')] : []),
  ];
  return all.length > 0 ? [el('div', { class: 'tools', role: 'group', 'aria-label': 'What is shown' }, ...all)] : [];
}

function columnsOf(run: TimeRun): GridColumn[] {
  return run.data.quantities.flatMap(({ name, label }): GridColumn[] => {
    const variable = run.variable(name);
    if (!variable?.has('revolution')) return [];
    return columnOf(run, name, label).map((column) => (column.unit === 'rad/s' ? { ...column, unit: 'rpm' } : inDegrees(column)));
  });
}

function sectionsOf(run: TimeRun, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const { label, revolution, time, speed, station } = run;
  const selection = new GridSelection([revolution, station], [revolution, time, ...(varies(speed.numbers ?? []) ? [speed] : [])]);
  const charts = run.numbers.length > 0 ? chartsOf(run).map((one) => new OverPanel(one.title, one.measures, selection, label).root) : [];
  const orbits = run.orbits.length > 0 ? [marchedOrbits(run, selection)] : [];
  const spectra = run.size('spectrum') > 0 && run.variable('spectrum_amplitude') ? [waterfall(run, selection)] : [];
  const { revolutions, rub_count: rubs } = run.summary;
  const compared = { several: false, focus: [run], shown: [run], names: label, onChange: () => undefined };
  return [
    part(
      `${id}-run`,
      title('Run in time'),
      tiles(run),
      ...(run.thinning === '' ? [] : [el('p', { class: 'note thinning' }, run.thinning)]),
      ...controls(run, selection),
      el('div', { class: 'multiples' }, ...orbits, ...spectra, ...charts),
    ),
    ...(revolutions > 0
      ? [
          part(
            `${id}-revolutions`,
            title('Energy, rubs and revolutions'),
            el('div', { class: 'multiples' }, energyTable(run), ...(rubs > 0 ? [rubTable(run)] : [])),
            gridTable({ title: 'Results by revolution', label, coordinates: station.texts.length > 1 ? [revolution, station] : [revolution], columns: columnsOf(run), main: namesOfFirst(run.data.quantities) }),
          ),
        ]
      : []),
    part(
      `${id}-case`,
      title('Case and origin'),
      caseSection(compared, caseKeys, { shortfalls: () => [run.attribute('status_message')].filter((text) => text !== ''), note: '' }),
    ),
  ];
}

/** Rotors in time, one run after the other. */
export function transientView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const all = results.map((data) => new TimeRun(data as TransientData));
  return {
    sections: all.flatMap((run, i) => {
      const several = all.length > 1 || !alone;
      return sectionsOf(run, `transient-${i + 1}`, (text) => (several ? `${text}, ${run.label}` : text), caseKeys);
    }),
    warnings: all.map((run) => gridWarnings(run)),
    entries: all.flatMap((run) => run.data.quantities.map(entryOf).map((entry) => ({ ...entry, label: capital(entry.label) }))),
  };
}
