import type { ReportData } from './data/format';
import { Result } from './data/result';
import { glossary } from './tables/glossary';
import { el } from './ui/dom';
import { roving } from './ui/roving';
import { isDark, isPrinting, onLookChange, onPrint, startTheme, toggleTheme } from './ui/theme';
import { ensembleView } from './views/ensembles';
import { equilibriumView } from './views/equilibria';
import { fitView } from './views/fits';
import { loopView } from './views/loops';
import { optimiseView } from './views/optimisations';
import { otherView } from './views/others';
import { pathView } from './views/paths';
import { stabilityView } from './views/stability';
import { sweepView } from './views/sweeps';
import { transientView } from './views/transient';
import { unbalanceView } from './views/unbalance';
import { vibrationView } from './views/vibrations';
import { part, type MakeView } from './views/view';
import './style/page.css';
import './style/panels.css';
import './style/runs.css';
import './style/charts.css';
import './style/tables.css';
import './style/player.css';
import './style/print.css';

/** Views of the kinds of results that have one of their own, in the order of the page. */
const views: Record<string, MakeView> = {
  cycle: loopView,
  strip: loopView,
  equilibrium: equilibriumView,
  film: equilibriumView,
  fit: fitView,
  montecarlo: ensembleView,
  optimise: optimiseView,
  path: pathView,
  stability: stabilityView,
  sweep: sweepView,
  transient: transientView,
  unbalance: unbalanceView,
  vibration: vibrationView,
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

/** How many runs ended early, where any did. */
function outcomes(runs: Result[]): string {
  return ['failed', 'interrupted']
    .flatMap((outcome) => {
      const count = runs.filter((run) => run.outcome === outcome).length;
      return count === 0 ? [] : [runs.length > 1 ? `${count} ${outcome}` : outcome];
    })
    .join(', ');
}

function masthead(report: ReportData, runs: Result[]): HTMLElement {
  const titles = [...new Set(runs.map((run) => run.attribute('title')))].filter((title) => title !== '');
  const title = titles.length === 0 ? 'Untitled case' : titles.join(' / ');
  document.title = `${title} – Bumpfoil report`;
  const computed = runs.filter((run) => run.data.measured !== true);
  const solvers = [...new Set(computed.map((run) => run.data.summary.solver))].join(', ');
  const dates = runs.map((run) => run.attribute('date_created').slice(0, 10)).sort();
  const about = [
    computed.length > 1 ? `${computed.length} runs compared` : '',
    computed.length < runs.length ? 'compared with measured loops' : '',
    outcomes(runs),
    `solver ${solvers}`,
    `bumpfoil ${report.version} (${report.commit})`,
    dates[dates.length - 1] ?? '',
  ];
  return el(
    'header',
    { class: 'masthead' },
    el('h1', {}, title),
    roving(el('div', { class: 'page-tools', role: 'group', 'aria-label': 'Page' }, printButton(), themeButton())),
    el('p', { class: 'about' }, el('span', { class: 'brand' }, 'Bumpfoil report'), ...about.filter((text) => text !== '').map((text) => ` · ${text}`)),
  );
}

function navigation(sections: HTMLElement[]): HTMLElement {
  const links = sections.flatMap((section) => {
    const heading = section.querySelector('h2')?.textContent;
    if (!heading) return [];
    const link = el('a', { href: `#${section.id}` }, heading);
    const folded = section.querySelector<HTMLDetailsElement>(':scope > h2 + details');
    link.addEventListener('click', () => folded && (folded.open = true));
    return [link];
  });
  return roving(el('nav', { 'aria-label': 'Parts of the report' }, ...links));
}

/** Warnings that are shown whole, those that paper has besides, and those that are listed at all. */
const atOnce = 2;
const mostOnPaper = 6;
const mostListed = 400;

function warnings(texts: string[]): HTMLElement[] {
  const listed = texts.length > mostListed ? [...texts.slice(0, mostListed), `and ${texts.length - mostListed} more, all in summary.json`] : texts;
  const items = listed.map((text) => el('li', {}, text));
  if (items.length === 0) return [];
  // The results are to be in sight, too: of more than a few, one line.
  const first = items.length > atOnce ? items.slice(0, 1) : items;
  return [el('div', { class: 'warnings', role: 'note' }, el('strong', {}, 'Warnings'), el('ul', {}, ...first), ...folded(items.slice(first.length)))];
}

/** Opened by a click, and by paper where they are not too many for it. */
function folded(items: HTMLElement[]): HTMLElement[] {
  if (items.length === 0) return [];
  const more = el('details', {}, el('summary', {}, `${items.length} more`), el('ul', {}, ...items));
  if (items.length <= mostOnPaper) {
    onPrint(() => (more.open = isPrinting()));
  }
  return [more];
}

/** Panels of several kinds of results that have the same title are told apart by that of their section, too. */
function tellApart(panels: HTMLElement[]): void {
  const titles = panels.map((panel) => panel.getAttribute('aria-label'));
  panels.forEach((panel, i) => {
    const [heading, section] = [panel.querySelector('h3'), panel.closest('.part')?.querySelector('h2')];
    if (!heading || !section || titles.filter((title) => title === titles[i]).length < 2) return;
    heading.id = `panel-${i + 1}`;
    panel.setAttribute('aria-labelledby', `${heading.id} ${section.id}`);
  });
}

function start(): void {
  const report = JSON.parse(document.getElementById('bumpfoil-data')?.textContent ?? '') as ReportData;
  const runs = report.runs.map((data) => new Result(data));
  startTheme();
  const kinds = [...new Set([...Object.keys(views), ...report.runs.map(({ kind }) => kind)])]
    .map((kind) => ({ make: views[kind] ?? otherView, members: report.runs.filter((data) => data.kind === kind) }))
    .filter(({ members }) => members.length > 0);
  const parts = kinds.map(({ make, members }) => ({ members, view: make(members, report.keys, kinds.length === 1) }));
  const warned = parts.flatMap(({ members, view }) =>
    view.warnings.flatMap((texts, i) => texts.map((text) => (runs.length > 1 ? `${members[i]?.name ?? ''}: ${text}` : text))),
  );
  const entries = parts.flatMap(({ view }) => view.entries);
  const words = entries.length > 0 ? [part('glossary', 'Glossary', glossary(entries))] : [];
  document.getElementById('report')?.append(
    el('a', { class: 'skip', href: '#contents' }, 'Skip to the results'),
    masthead(report, runs),
    navigation([...parts.flatMap(({ view }) => view.sections), ...words]),
    el('main', { id: 'contents', tabindex: -1 }, ...warnings(warned), ...parts.map(({ view }) => el('div', { class: 'view' }, ...view.sections)), ...words),
    el('footer', {}, 'Drawn with Apache ECharts, © The Apache Software Foundation, Apache License 2.0.'),
  );
  tellApart([...document.querySelectorAll<HTMLElement>('.panel')]);
  // Without charts nothing is left to draw.
  if (!document.querySelector('.chart')) document.documentElement.dataset['drawn'] = 'true';
}

start();
