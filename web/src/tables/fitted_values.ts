import { toCsv } from '../data/csv';
import type { Fit, FittedParameter } from '../data/fit';
import { formatNumber, scaleFor } from '../data/units';
import { el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';

function scrolled(label: string, heads: string[], rows: HTMLElement[]): HTMLElement {
  return el(
    'div',
    { class: 'scroller', tabindex: 0, role: 'group', 'aria-label': label },
    el('table', { class: 'results' }, el('thead', {}, el('tr', {}, ...heads.map((head) => el('th', { scope: 'col' }, head)))), el('tbody', {}, ...rows)),
  );
}

/** One unit for all numbers of a parameter, with the digits that its standard error leaves. */
function cells({ unit, start, value, standardError, interval, profileInterval, atBound, atJump }: FittedParameter, profiled: boolean): string[] {
  const scale = scaleFor(Math.abs(value), unit);
  const text = (number: number | null, digits = 5): string => formatNumber(number === null ? null : number * scale.factor, digits);
  const range = ([from, to]: [number | null, number | null]): string => (from === null && to === null ? '–' : `${text(from)} to ${text(to)}`);
  return [text(value), text(standardError, 3), range(interval), ...(profiled ? [range(profileInterval)] : []), text(start), scale.unit, atBound ? 'at a bound' : atJump ? 'at a jump' : ''];
}

/** Best values with their intervals, and how well the model follows the data. */
export function valueTable(fit: Fit): HTMLElement {
  const { parameters, summary } = fit;
  const profiled = parameters.some(({ profile }) => profile.length > 0);
  const heads = ['Parameter', 'Value', 'Standard error', '95 % interval', ...(profiled ? ['95 % by profile'] : []), 'Start', 'Unit', 'Remark'];
  const rows = parameters.map((parameter) => el('tr', {}, el('th', { scope: 'row' }, parameter.title), ...cells(parameter, profiled).map((cell) => el('td', {}, cell))));
  const quality = [
    `chi-square per degree of freedom ${formatNumber(fit.reducedChiSquare, 3)}, 1 where noise explains all (${summary.degrees_of_freedom ?? 0} degrees of freedom)`,
    `collinearity ${formatNumber(summary.collinearity, 3)}; parameters are hardly separable above 10`,
  ].join(' · ');
  return new Panel(
    {
      title: 'Fitted values',
      subject: () => `${quality} · ${fit.label}`,
      file: () => fileName('fitted_values', fit.label),
      csv: () =>
        toCsv(
          ['parameter', 'unit', 'fitted_value', 'standard_error', 'lower_95', 'upper_95', 'profile_lower_95', 'profile_upper_95', 'at_bound'],
          parameters.map((one) => [one.key, one.unit, one.value, one.standardError, ...one.interval, ...one.profileInterval, one.atBound]),
        ),
    },
    parameters.length > 0 ? scrolled('Table of fitted values', heads, rows) : el('p', {}, 'No minimum was found.'),
  ).root;
}

/** Which parameters the data determine only together: fields are darker the nearer a correlation is to 1 or −1. */
export function correlationTable(fit: Fit): HTMLElement {
  const { parameters } = fit;
  const shade = (correlation: number | null, self: boolean): string => {
    if (correlation === null || self) return '';
    const colour = correlation < 0 ? '0 103 168' : '207 82 0';
    return `background: rgb(${colour} / ${Math.round(70 * Math.min(1, Math.abs(correlation)) ** 2)}%)`;
  };
  const rows = parameters.map(({ title, correlations }, i) =>
    el('tr', {}, el('th', { scope: 'row' }, `${i + 1}  ${title}`), ...correlations.map((one, k) => el('td', { style: shade(one, i === k) }, formatNumber(one, 3)))),
  );
  return new Panel(
    {
      title: 'Correlations',
      subject: () => `of the errors of two parameters; beyond ±0.9 only a combination of them is known well · ${fit.label}`,
      file: () => fileName('correlations', fit.label),
      csv: () => toCsv(['parameter', ...parameters.map(({ key }) => key)], parameters.map(({ key, correlations }) => [key, ...correlations])),
    },
    scrolled('Table of correlations', ['Parameter', ...parameters.map((_, i) => String(i + 1))], rows),
  ).root;
}
