import type { CaseKeys, ReportData } from './data/format';
import { readRuns, type Run } from './data/run';
import { warningsOf } from './tables/results';
import { el } from './ui/dom';
import { isDark, onLookChange, startTheme, toggleTheme } from './ui/theme';
import { loopView } from './views/loops';
import './style.css';

/** One view per kind of result; runs of one kind are compared in it. */
const views: Record<string, (runs: Run[], keys: CaseKeys) => HTMLElement[]> = {
  cycle: loopView,
  strip: loopView,
};

function themeButton(): HTMLElement {
  const button = el('button', { type: 'button', class: 'quiet' });
  const name = (): void => {
    button.textContent = isDark() ? 'Light' : 'Dark';
    button.title = `Change to ${isDark() ? 'light' : 'dark'} colours`;
  };
  button.addEventListener('click', toggleTheme);
  onLookChange(name);
  name();
  return button;
}

function printButton(): HTMLElement {
  const button = el('button', { type: 'button', class: 'quiet' }, 'Print');
  button.addEventListener('click', () => window.print());
  return button;
}

function masthead(report: ReportData, runs: Run[], sections: HTMLElement[]): HTMLElement {
  const titles = [...new Set(runs.map((run) => run.attribute('title')))].filter((title) => title !== '');
  const title = titles.length === 0 ? 'Untitled case' : titles.join(' / ');
  document.title = `${title} – Bumpfoil report`;
  const solvers = [...new Set(runs.map((run) => run.data.summary.solver))].join(', ');
  const dates = runs.map((run) => run.attribute('date_created').slice(0, 10)).sort();
  const about = [
    runs.length > 1 ? `${runs.length} runs compared` : '',
    `solver ${solvers}`,
    `bumpfoil ${report.version} (${report.commit})`,
    dates[dates.length - 1] ?? '',
  ];
  const links = sections.flatMap((section) => {
    const heading = section.querySelector('h2')?.textContent;
    return heading ? [el('a', { href: `#${section.id}` }, heading)] : [];
  });
  return el(
    'header',
    { class: 'masthead' },
    el('div', { class: 'bar' }, el('span', { class: 'brand' }, 'Bumpfoil report'), printButton(), themeButton()),
    el('h1', {}, title),
    el('p', { class: 'about' }, about.filter((text) => text !== '').join(' · ')),
    el('nav', { 'aria-label': 'Parts of the report' }, ...links),
  );
}

function warnings(runs: Run[]): HTMLElement[] {
  const items = runs.flatMap((run) =>
    warningsOf(run).map((text) => el('li', {}, runs.length > 1 ? `${run.label}: ${text}` : text)),
  );
  return items.length === 0 ? [] : [el('div', { class: 'warnings', role: 'note' }, el('strong', {}, 'Mind'), el('ul', {}, ...items))];
}

function start(): void {
  const report = JSON.parse(document.getElementById('bumpfoil-data')?.textContent ?? '') as ReportData;
  const runs = readRuns(report);
  startTheme();
  const parts: HTMLElement[][] = [];
  for (const [kind, show] of Object.entries(views)) {
    const members = runs.filter((run) => run.data.kind === kind);
    if (members.length > 0) parts.push(show(members, report.keys));
  }
  document.getElementById('report')?.append(
    masthead(report, runs, parts.flat()),
    ...warnings(runs),
    ...parts.map((sections) => el('div', { class: 'view' }, ...sections)),
    el('footer', {}, 'Drawn with Apache ECharts, © The Apache Software Foundation, Apache License 2.0.'),
  );
}

start();
