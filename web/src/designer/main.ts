import type { CaseValue, RunData } from '../data/format';
import { flatten } from '../data/case_values';
import { Run } from '../data/run';
import { el } from '../ui/dom';
import { roving } from '../ui/roving';
import { download } from '../ui/save';
import { isDark, onLookChange, startTheme, toggleTheme } from '../ui/theme';
import { Design } from './design';
import { EnsembleView } from './ensemble';
import { form, withTable } from './fields';
import type { CyclesAnswer, InputError, KeysAnswer } from './format';
import { askLoops, withCycle } from './loops';
import { reportOf } from './report';
import { layoutOf, results, type Results } from './results';
import { RotorView } from './rotor';
import { RunningView } from './running';
import { Side } from './side';
import { caseIn, fragmentOf } from './share';
import { isRefused, makeSolvers, type Request } from './solver';
import { tabs } from './tabs';
import { without } from './toml';
import { VibrationView } from './vibration';
import '../style/page.css';
import '../style/panels.css';
import '../style/runs.css';
import '../style/charts.css';
import '../style/tables.css';
import '../style/player.css';
import '../style/designer.css';

function button(text: string, title: string, action: () => void): HTMLButtonElement {
  const one = el('button', { type: 'button', class: 'quiet', title }, text);
  one.addEventListener('click', action);
  return one;
}

/** Of the loops, after which no browser found more to compile. */
const warmingRuns = 8;

function runOf(answer: CyclesAnswer, name: string): Run {
  return new Run({ ...answer.run, name } as RunData);
}

/** The page: what is said of the case on the left, what it does on the right. */
class Page {
  private readonly design: Design;
  private understood = new Map<string, CaseValue>();
  private errors: InputError[] = [];
  /** The design as it stands, and the one it is compared with. */
  private now: { answer: CyclesAnswer; text: string } | undefined;
  private before: { answer: CyclesAnswer; text: string } | undefined;
  private results: Results | undefined;
  private layout = '';
  private readonly views = el('div', { class: 'results' });
  private readonly state = el('p', { class: 'state', role: 'status' });
  private readonly general = el('ul', { class: 'general-errors' });
  private readonly fields;
  private readonly side;
  private readonly vibration;
  private readonly running;
  private readonly rotor;
  private readonly ensemble;
  private readonly editor = el('textarea', { class: 'editor', spellcheck: 'false', 'aria-label': 'Case file', rows: 28 });
  private readonly undo = button('Undo', 'Undo (Ctrl+Z)', () => this.design.undo());
  private readonly redo = button('Redo', 'Redo (Ctrl+Shift+Z)', () => this.design.redo());

  constructor(
    private readonly keys: KeysAnswer,
    private readonly solvers: Awaited<ReturnType<typeof makeSolvers>>,
    text: string,
  ) {
    const { quick, slow } = solvers;
    const giveTolerances = (): void => this.design.change(withTable(this.design.text, 'montecarlo', keys.keys), false);
    this.design = new Design(text);
    this.vibration = new VibrationView(slow);
    this.running = new RunningView(quick, slow, giveTolerances);
    this.rotor = new RotorView(quick, slow, (text) => withTable(text, 'rotor', keys.keys), (text) => this.design.change(text, false));
    this.ensemble = new EnsembleView(slow, giveTolerances);
    this.fields = form(keys.keys, { design: this.design, units: keys.units, understood: (path) => this.understood.get(path) });
    this.side = new Side(this.fields, el('div', { role: 'alert' }, this.general));
    document.getElementById('designer')?.append(
      el('a', { class: 'skip', href: '#contents' }, 'Skip to the results'),
      this.masthead(),
      el(
        'div',
        { class: 'sides' },
        this.side.root,
        el('main', { id: 'contents', tabindex: -1 }, el('h2', { class: 'unseen' }, 'Results'), this.views),
      ),
      el('footer', {}, 'Computed in this page: nothing is sent. Drawn with Apache ECharts, © The Apache Software Foundation, Apache License 2.0.'),
    );
    this.design.onChange(() => this.changed());
    this.editor.addEventListener('input', () => this.design.change(this.editor.value, true));
    this.editor.addEventListener('change', () => this.design.change(this.editor.value, false));
    document.addEventListener('keydown', (event) => this.key(event));
    this.changed();
  }

  /** Browsers compile what is called often once more, into faster code: here before the first change. */
  private async warmUp(): Promise<void> {
    const text = withCycle(this.design.text, this.keys.keys);
    // The first change ends it.
    for (let run = 0; run < warmingRuns && !this.design.canUndo; run += 1) await askLoops(this.solvers.loops, text);
  }

  private masthead(): HTMLElement {
    const presets = el(
      'select',
      { 'aria-label': 'Start from' },
      el('option', {}, 'Start from …'),
      ...Object.keys(this.keys.presets)
        // Bearings: they are pushed and pulled, or run.
        .filter((name) => /^\[(cycle|equilibrium)\]/m.test(this.keys.presets[name] ?? ''))
        .map((name) => el('option', { value: name }, name)),
    );
    presets.addEventListener('change', () => {
      const text = this.keys.presets[presets.value];
      if (text !== undefined) this.design.change(text, false);
      presets.selectedIndex = 0;
    });
    const file = el('input', { type: 'file', accept: '.toml,text/plain', hidden: true });
    file.addEventListener('change', () => {
      void file.files?.[0]?.text().then((text) => this.design.change(text, false));
      file.value = '';
    });
    const theme = button('Dark', 'Change colours', toggleTheme);
    const name = (): void => {
      theme.textContent = isDark() ? 'Light' : 'Dark';
    };
    onLookChange(name);
    name();
    return el(
      'header',
      { class: 'masthead' },
      el('h1', {}, el('span', { class: 'brand' }, 'Bumpfoil designer')),
      this.state,
      presets,
      roving(
        el(
          'div',
          { class: 'page-tools', role: 'toolbar', 'aria-label': 'Design' },
          this.undo,
          this.redo,
          button('Compare from here', 'Use the current design as the baseline', () => this.pin()),
          button('Open …', 'Open a case file', () => file.click()),
          button('Save case', 'Save the case file', () => download('case.toml', new Blob([this.design.text], { type: 'application/toml' }))),
          button('Save report', 'Save what is shown as the page that `bumpfoil report` writes', () => this.saveReport()),
          button('Copy link', 'Put a link to this design into the clipboard and the address', () => void this.share()),
          theme,
        ),
      ),
      file,
    );
  }

  private key(event: KeyboardEvent): void {
    if (!(event.ctrlKey || event.metaKey) || event.target === this.editor) return;
    const name = event.key.toLowerCase();
    if (name === 'z' && !event.shiftKey) this.design.undo();
    else if (name === 'y' || (name === 'z' && event.shiftKey)) this.design.redo();
    else return;
    event.preventDefault();
  }

  private async share(): Promise<void> {
    const fragment = await fragmentOf(this.design.text);
    history.replaceState(null, '', fragment);
    try {
      await navigator.clipboard.writeText(location.href);
      this.state.textContent = 'The link is in the clipboard.';
    } catch {
      this.state.textContent = 'The link is in the address.';
    }
  }

  private saveReport(): void {
    if (!this.now || !this.before) return;
    const designs = this.before.text === this.now.text ? { design: this.now } : { before: this.before, design: this.now };
    download('report.html', new Blob([reportOf(this.keys, designs)], { type: 'text/html' }));
  }

  private pin(): void {
    this.before = this.now;
    this.show()();
  }

  /** The text has changed: it is computed, and shown once that is done. */
  private changed(): void {
    this.undo.disabled = !this.design.canUndo;
    this.redo.disabled = !this.design.canRedo;
    // The solvers begin while the page writes what was typed.
    void this.compute();
    if (this.editor.value !== this.design.text) this.editor.value = this.design.text;
    this.fields.refresh(this.errors);
  }

  private async compute(): Promise<void> {
    const { text } = this.design;
    const began = performance.now();
    const whole = withCycle(text, this.keys.keys);
    const first = await askLoops(this.solvers.loops, whole);
    // A tilted journal runs, but has no loops: they are those of an aligned one.
    const tilted = first && isRefused(first) && first.errors.every(({ key }) => key.startsWith('width.'));
    const answer = tilted ? await askLoops(this.solvers.loops, without(whole, 'width')) : first;
    if (!answer) return;
    let drawRest = (): void => {};
    if (isRefused(answer)) {
      this.errors = answer.errors;
    } else {
      this.errors = [];
      this.understood = flatten(answer.run.summary.case);
      const radius = this.understood.get('bearing.radius');
      if (typeof radius === 'number') this.understood.set('bearing.diameter', 2 * radius);
      this.now = { answer, text };
      this.before ??= this.now;
      drawRest = this.show();
    }
    this.fields.refresh(this.errors);
    const elsewhere = this.errors.filter((error) => !this.fields.tells(error));
    this.general.replaceChildren(...elsewhere.map(({ line, message }) => el('li', {}, line > 0 ? `Line ${line}: ${message}` : message)));
    this.views.classList.toggle('stale', this.errors.length > 0);
    this.state.textContent =
      this.errors.length > 0 ? `${this.errors.length === 1 ? '1 error' : `${this.errors.length} errors`} in the case; showing the last valid results.` : '';
    // Once the browser has painted it.
    requestAnimationFrame(() =>
      setTimeout(() => {
        const { dataset } = document.documentElement;
        dataset['took'] = (performance.now() - began).toFixed(1);
        drawRest();
        const answered = Number(dataset['answered'] ?? 0) + 1;
        dataset['answered'] = String(answered);
        if (answered === 1) void this.warmUp();
      }),
    );
  }

  /** @return what draws all that waits until the rest is painted */
  private show(): () => void {
    let drawRest = (): void => {};
    if (!this.now || !this.before) return drawRest;
    const now = runOf(this.now.answer, 'current');
    const runs = this.before.text === this.now.text ? [now] : [now, runOf(this.before.answer, 'baseline')];
    const { running, rotor } = this.kinds;
    const layout = `${layoutOf(runs)} ${running} ${rotor}`;
    if (this.results && layout === this.layout) drawRest = this.results.show(runs);
    else this.layOut(runs, layout);
    this.vibration.show(this.now.text, this.before.text);
    // What samples are drawn of has a cycle, too.
    const whole = <D extends { text: string }>(design: D): D => ({ ...design, text: withCycle(design.text, this.keys.keys) });
    this.running.show(whole(this.now), whole(this.before));
    this.rotor.show(this.now, this.before);
    this.ensemble.show(whole(this.now));
    return drawRest;
  }

  /** What the case is of, beside loops. */
  private get kinds(): { running: boolean; rotor: boolean } {
    const tables = this.now?.answer.run.summary.case ?? {};
    return { running: tables['equilibrium'] !== undefined, rotor: tables['rotor'] !== undefined };
  }

  /** Views of another layout are made anew, those first that the case is of. */
  private layOut(runs: Run[], layout: string): void {
    this.layout = layout;
    this.results = results(runs);
    const { kinds } = this;
    const loops = { name: 'loops', title: 'Loops', body: this.results.root };
    const running = { name: 'running', title: 'Running', body: this.running.root, shown: () => this.running.refresh() };
    const rotor = { name: 'rotor', title: 'Rotor', body: this.rotor.root, shown: () => this.rotor.refresh() };
    this.views.replaceChildren(
      tabs([
        ...(kinds.running ? [running] : []),
        ...(kinds.rotor ? [rotor] : []),
        loops,
        ...(kinds.running ? [] : [running]),
        ...(kinds.rotor ? [] : [rotor]),
        { name: 'vibration', title: 'Vibration', body: this.vibration.root, shown: () => this.vibration.refresh() },
        { name: 'ensemble', title: 'Ensemble', body: this.ensemble.root, shown: () => this.ensemble.refresh() },
        { name: 'case', title: 'Case file', body: el('div', { class: 'panel' }, this.editor) },
      ]),
    );
  }
}

async function start(): Promise<void> {
  startTheme();
  const solvers = await makeSolvers();
  // For those who want numbers without clicking: include/bumpfoil/pages/designer.hpp lists the requests.
  Object.assign(window, { bumpfoilAsk: (request: Request) => solvers.slow.ask(request) });
  const keys = await solvers.quick.ask<KeysAnswer>({ what: 'keys' });
  if (!keys || isRefused(keys)) throw new Error(keys?.errors[0]?.message ?? 'the solver does not respond');
  const shared = await caseIn(location.hash);
  new Page(keys, solvers, shared ?? Object.values(keys.presets)[0] ?? '');
}

start().catch((error: unknown) => {
  document.getElementById('designer')?.append(el('p', { class: 'warnings', role: 'alert' }, `The designer cannot start: ${String(error)}. It needs a browser of 2023 or later.`));
});
