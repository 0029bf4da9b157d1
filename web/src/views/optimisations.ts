import { aimAxis, aimHistory, keyAxis, pointChart } from '../charts/optimised_points';
import type { CaseKeys, GridData, ResultData } from '../data/format';
import { Optimisation } from '../data/optimisation';
import { gridWarnings } from '../data/outcome';
import { caseSection } from '../tables/case';
import { bestTable, limitTable } from '../tables/optimised';
import { el } from '../ui/dom';
import { part, type View } from './view';

function overKeys(result: Optimisation): HTMLElement[] {
  const { keys } = result.summary;
  const aim = aimAxis(result, 0);
  const single = keys.map((_, i) => {
    const across = keyAxis(result, i);
    return pointChart(result, { title: `${aim.name} over ${across.name}`, subject: 'all points', across, upwards: aim, line: [], lineText: '' });
  });
  if (keys.length < 2) return single;
  const [across, upwards] = [keyAxis(result, 0), keyAxis(result, 1)];
  const plane = pointChart(result, { title: `${upwards.name} over ${across.name}`, subject: 'where points meet all limits', across, upwards, line: [], lineText: '' });
  return [plane, ...single];
}

function frontOf(result: Optimisation): HTMLElement[] {
  if (result.front.length < 2) return [];
  const [across, upwards] = [aimAxis(result, 0), aimAxis(result, 1)];
  return [pointChart(result, { title: 'Front of both aims', subject: 'on the line neither aim can improve without the other getting worse', across, upwards, line: result.front, lineText: 'front' })];
}

function sectionsOf(result: Optimisation, id: string, title: (text: string) => string, caseKeys: CaseKeys): HTMLElement[] {
  const compared = { several: false, focus: [result], shown: [result], names: result.label, onChange: () => undefined };
  const front = frontOf(result);
  const histories = result.points.length > 0 ? result.summary.aims.map((_, i) => aimHistory(result, i)) : [];
  return [
    part(`${id}-best`, title('Best point'), el('div', { class: 'multiples of-tables' }, bestTable(result), ...(result.summary.limits.length > 0 ? [limitTable(result)] : []))),
    ...(front.length > 0 ? [part(`${id}-front`, title('Front'), ...front)] : []),
    ...(histories.length > 0
      ? [
          part(`${id}-search`, title('Search'), el('div', { class: 'multiples' }, ...histories)),
          part(`${id}-points`, title('Points'), el('div', { class: 'multiples' }, ...overKeys(result))),
        ]
      : []),
    part(
      `${id}-case`,
      title('Case and origin'),
      caseSection(compared, caseKeys, {
        shortfalls: () => [result.attribute('status_message')].filter((text) => text !== ''),
        note: '',
        text: (_, key, value) => result.caseText(key, value),
      }),
    ),
  ];
}

/** Optimisations of cases, one after the other. */
export function optimiseView(results: ResultData[], caseKeys: CaseKeys, alone: boolean): View {
  const all = results.map((data) => new Optimisation(data as GridData, caseKeys));
  const several = all.length > 1 || !alone;
  return {
    sections: all.flatMap((one, i) => sectionsOf(one, `optimised-${i + 1}`, (text) => (several ? `${text}, ${one.label}` : text), caseKeys)),
    warnings: all.map((one) => gridWarnings(one)),
    entries: [],
  };
}
