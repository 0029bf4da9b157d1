import { toCsv } from '../data/csv';
import type { TimeRun } from '../data/time_run';
import { formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { scroller } from '../ui/scroller';

/** Terms of the balance by their keys in summary.json: what drives, what is taken, what is left. */
const terms: [key: string, side: string, text: string][] = [
  ['entrained_J', 'In', 'work of the journals on the gas they drag along'],
  ['supplied_J', 'In', 'work of gas that enters above ambient pressure'],
  ['forces_J', 'In', 'work of weight, unbalance, pulses and base'],
  ['rubbing_J', 'In', 'work of the friction of asperities on the rotor'],
  ['dissipated_J', 'Out', 'dissipated by the flow of the films'],
  ['friction_J', 'Out', 'friction of the foils'],
  ['damping_J', 'Out', 'damping of the rotor'],
  ['stored_J', 'Stored', 'change of the energy of motion, films and foils'],
  ['defect_J', 'Defect', 'sum of the defects of all revolutions: error of the steps in time'],
];

/** The balance of energy of all whole revolutions; terms that are zero are not listed. */
export function energyTable(run: TimeRun): HTMLElement {
  const rows = terms.map(([key, side, text]) => ({ key, side, text, value: run.summary.energy[key] ?? NaN })).filter(({ value }) => value !== 0);
  const table = el(
    'table',
    { class: 'results' },
    el('thead', {}, el('tr', {}, ...['Term', 'Energy'].map((head) => el('th', { scope: 'col' }, head)))),
    el('tbody', {}, ...rows.map(({ side, text, value }) => el('tr', {}, el('th', { scope: 'row' }, `${side}: ${text}`), el('td', {}, formatQuantity(value, 'J'))))),
  );
  return new Panel(
    {
      title: 'Balance of energy',
      subject: () => `All ${run.summary.revolutions} whole revolutions · ${run.label}`,
      note: 'Energy in = energy out + stored + defect.',
      file: () => fileName('energy', run.label),
      csv: () => toCsv(['term', 'energy_J'], rows.map(({ key, value }) => [key.replace(/_J$/, ''), value])),
    },
    scroller('Table of energies', table),
  ).root;
}
