import { toCsv } from '../data/csv';
import type { TimeRun } from '../data/time_run';
import { formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { scroller } from '../ui/scroller';

/** Rows that are shown; the file has more. */
const mostRows = 200;

/** Stretches of time in which asperities of a bearing carry load. */
export function rubTable(run: TimeRun): HTMLElement {
  const { rubs, rub_count: count } = run.summary;
  const shown = rubs.slice(0, mostRows);
  const head = ['Bearing', 'From', 'To', 'Lasts', 'Largest load'];
  const table = el(
    'table',
    { class: 'results' },
    el('thead', {}, el('tr', {}, ...head.map((text) => el('th', { scope: 'col' }, text)))),
    el(
      'tbody',
      {},
      ...shown.map(({ bearing, begin_s: begin, end_s: end, asperity_load_N: load }) =>
        el('tr', {}, el('th', { scope: 'row' }, run.station.texts[bearing - 1] ?? String(bearing)), ...[begin, end, end - begin].map((time) => el('td', {}, formatQuantity(time, 's'))), el('td', {}, formatQuantity(load, 'N'))),
      ),
    ),
  );
  const some = count > shown.length ? `the first ${shown.length} of ${count}; summary.json has them all` : `${count}`;
  return new Panel(
    {
      title: 'Rubs',
      subject: () => `Asperities carry more than a hundredth of the weight: ${some} · ${run.label}`,
      file: () => fileName('rubs', run.label),
      csv: () => toCsv(['bearing', 'begin_s', 'end_s', 'asperity_load_N'], rubs.map((rub) => [rub.bearing, rub.begin_s, rub.end_s, rub.asperity_load_N])),
    },
    scroller('Table of rubs', table),
  ).root;
}
