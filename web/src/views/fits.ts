import { fittedData } from '../charts/fitted_data';
import { profileChart } from '../charts/fit_profile';
import { Fit } from '../data/fit';
import type { CaseKeys, GridData, ResultData } from '../data/format';
import { gridWarnings } from '../data/outcome';
import { caseSection } from '../tables/case';
import { correlationTable, valueTable } from '../tables/fitted_values';
import { el } from '../ui/dom';
import { part, type View } from './view';

function sectionsOf(fit: Fit, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const profiles = fit.parameters.filter(({ profile }) => profile.length > 0).map((parameter) => profileChart(fit, parameter));
  const charts = [...Array(fit.count).keys()].flatMap((data) => fittedData(fit, data));
  const compared = { several: false, focus: [fit], shown: [fit], names: fit.label, onChange: () => undefined };
  return [
    part(`${id}-values`, title('Fitted parameters'), el('div', { class: 'multiples of-tables' }, valueTable(fit), ...(fit.parameters.length > 1 ? [correlationTable(fit)] : []))),
    ...(charts.length > 0 ? [part(`${id}-data`, title('Measured and fitted'), el('div', { class: 'multiples' }, ...charts))] : []),
    ...(profiles.length > 0 ? [part(`${id}-profiles`, title('Profiles'), el('div', { class: 'multiples' }, ...profiles))] : []),
    part(
      `${id}-case`,
      title('Case and origin'),
      caseSection(compared, caseKeys, { shortfalls: () => [fit.attribute('status_message')].filter((text) => text !== ''), note: '' }),
    ),
  ];
}

/** Fits of cases to measured data, one after the other. */
export function fitView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const all = results.map((data) => new Fit(data as GridData, caseKeys));
  const several = all.length > 1 || !alone;
  return {
    sections: all.flatMap((fit, i) => sectionsOf(fit, `fit-${i + 1}`, (text) => (several ? `${text}, ${fit.label}` : text), caseKeys)),
    warnings: all.map((fit) => gridWarnings(fit)),
    entries: [],
  };
}
