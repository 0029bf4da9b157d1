import { toCsv } from '../data/csv';
import type { Optimisation } from '../data/optimisation';
import { formatNumber, formatQuantity, scaleFor } from '../data/units';
import { el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';

function table(label: string, heads: string[], rows: string[][]): HTMLElement {
  const lines = rows.map(([first = '', ...cells]) => el('tr', {}, el('th', { scope: 'row' }, first), ...cells.map((cell) => el('td', {}, cell))));
  return el(
    'div',
    { class: 'scroller', tabindex: 0, role: 'group', 'aria-label': label },
    el('table', { class: 'results' }, el('thead', {}, el('tr', {}, ...heads.map((head) => el('th', { scope: 'col' }, head)))), el('tbody', {}, ...lines)),
  );
}

/** Best values with their bounds, and what the aims come to. */
export function bestTable(result: Optimisation): HTMLElement {
  const { keys, aims, ended_by: end } = result.summary;
  const rows = keys.map((key) => {
    const scale = scaleFor(Math.max(Math.abs(key.lower_bound), Math.abs(key.upper_bound)), result.unitOf(key));
    const text = (number: number | null): string => formatNumber(number === null ? null : number * scale.factor, 5);
    return [result.titleOf(key.key), text(key.best_value), text(key.start), text(key.lower_bound), text(key.upper_bound), scale.unit, key.active_bound === null ? '' : `at its ${key.active_bound} bound`];
  });
  const reached = aims.map((aim) => `${aim.maximise ? 'maximise' : 'minimise'} ${result.nameOf(aim.quantity)}: ${formatQuantity(aim.best_value, result.unitOf(aim), 5)}`);
  return new Panel(
    {
      title: 'Best values',
      subject: () => [...reached, `search ended: ${end.replace(/_/g, ' ')}`, result.label].join(' · '),
      file: () => fileName('best_point', result.label),
      csv: () =>
        toCsv(
          ['key', 'unit', 'best_value', 'start', 'lower_bound', 'upper_bound', 'active_bound'],
          keys.map((key) => [key.key, key.unit, key.best_value, key.start, key.lower_bound, key.upper_bound, key.active_bound]),
        ),
    },
    table('Table of best values', ['Key', 'Best', 'Start', 'Lower bound', 'Upper bound', 'Unit', 'Remark'], rows),
  ).root;
}

/** What the best point has to spare. */
export function limitTable(result: Optimisation): HTMLElement {
  const { limits } = result.summary;
  const rows = limits.map((limit) => [
    result.limitText(limit.limit),
    formatQuantity(limit.value, result.unitOf(limit), 5),
    formatQuantity(limit.margin, result.unitOf(limit), 3),
    limit.active === true ? 'active' : '',
  ]);
  return new Panel(
    {
      title: 'Limits',
      subject: () => `at the best point · ${result.label}`,
      file: () => fileName('limits', result.label),
      csv: () =>
        toCsv(
          ['limit', 'unit', 'value', 'margin', 'active'],
          limits.map((limit) => [limit.limit, limit.unit, limit.value, limit.margin, limit.active]),
        ),
    },
    table('Table of limits', ['Limit', 'Value', 'Margin', 'Remark'], rows),
  ).root;
}
