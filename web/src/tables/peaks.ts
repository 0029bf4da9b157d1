import { toCsv } from '../data/csv';
import { responseKinds, type Responses } from '../data/responses';
import { capital } from '../data/run';
import { speedText } from '../data/states';
import { formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { scroller } from '../ui/scroller';

/** Speeds at which the largest orbit of all stations has a maximum. */
export function peakTable(responses: Responses): HTMLElement {
  const { peaks } = responses;
  const words = responses.variable('kind')?.words ?? [];
  const rows = peaks.map(({ kind, speed_rad_per_s: speed, semi_major_m: size, station }) => [capital(responseKinds[words.indexOf(kind)] ?? kind), speedText(speed), formatQuantity(size, 'm'), station]);
  const table = el(
    'table',
    { class: 'results' },
    el('thead', {}, el('tr', {}, ...['Response', 'Speed', 'Semi-major axis', 'Station'].map((head) => el('th', { scope: 'col' }, head)))),
    el('tbody', {}, ...rows.map(([first = '', ...cells]) => el('tr', {}, el('th', { scope: 'row' }, first), ...cells.map((cell) => el('td', {}, cell))))),
  );
  return new Panel(
    {
      title: 'Peaks',
      subject: () => `Speeds at which the largest orbit of all stations has a maximum · ${responses.label}`,
      file: () => fileName('peaks', responses.label),
      csv: () => toCsv(['kind', 'station', 'speed_rad_per_s', 'semi_major_m'], peaks.map(({ kind, station, speed_rad_per_s: speed, semi_major_m: size }) => [kind, station, speed, size])),
    },
    peaks.length > 0 ? scroller('Table of peaks', table) : el('p', {}, 'The orbits have no peak between these speeds.'),
  ).root;
}
