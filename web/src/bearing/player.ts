import { shortfallOf } from '../data/outcome';
import { at, type Run } from '../data/run';
import type { Comparison } from '../ui/comparison';
import { formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import type { Selection } from '../ui/selection';

/** A whole cycle takes this long, ms. */
const duration = 9000;

/** Bar at the foot of the window that moves all views along the cycle. */
export function player(selection: Selection, comparison: Comparison): HTMLElement {
  const slider = el('input', { type: 'range', min: 0, step: 1, 'aria-label': 'Increment of the cycle' });
  const play = el('button', { type: 'button', class: 'play' });
  const readout = el('output', {});
  const runs = el('select', { 'aria-label': 'Run' });
  runs.addEventListener('change', () => selection.show({ run: at(comparison.shownFoils, runs.selectedIndex) }));
  const listRuns = (): void => {
    runs.replaceChildren(...comparison.shownFoils.map(({ label }) => el('option', {}, label)));
    runs.selectedIndex = comparison.shownFoils.indexOf(selection.run);
  };
  const cycles = el('select', { 'aria-label': at(selection.runs, 0).kind.cycles.title });
  cycles.addEventListener('change', () => {
    selection.show({ key: at(selection.run.cycles, cycles.selectedIndex).key });
  });

  let frame = 0;
  const stop = (): void => {
    cancelAnimationFrame(frame);
    frame = 0;
    refresh();
  };
  const start = (): void => {
    const { cycle } = selection;
    const first = selection.index >= cycle.size - 1 ? 0 : selection.index;
    const began = performance.now() - (duration * first) / Math.max(1, cycle.size - 1);
    const step = (now: number): void => {
      if (selection.cycle !== cycle) return stop();
      const index = Math.floor((Math.max(0, now - began) / duration) * (cycle.size - 1));
      frame = requestAnimationFrame(step);
      if (index !== selection.index) selection.show({ index });
      if (index >= cycle.size - 1) stop();
    };
    frame = requestAnimationFrame(step);
    refresh();
  };
  play.addEventListener('click', () => (frame === 0 ? start() : stop()));
  slider.addEventListener('input', () => {
    if (frame !== 0) stop();
    selection.show({ index: Number(slider.value) });
  });

  let listed: Run | undefined;
  const refresh = (): void => {
    const { run, cycle, index } = selection;
    if (run !== listed) {
      listed = run;
      runs.selectedIndex = comparison.shownFoils.indexOf(run);
      cycles.replaceChildren(...run.cycles.map(({ name }) => el('option', {}, name)));
    }
    cycles.selectedIndex = run.cycles.indexOf(cycle);
    slider.max = String(Math.max(0, cycle.size - 1));
    slider.value = String(index);
    slider.disabled = cycle.size === 0;
    play.disabled = cycle.size === 0;
    play.textContent = frame === 0 ? '▶' : '❚❚';
    play.setAttribute('aria-label', frame === 0 ? 'Play the cycle' : 'Pause');
    if (cycle.size === 0) {
      readout.textContent = `${cycle.name}: ${shortfallOf(run, cycle) ?? 'no increment'}`;
      return;
    }
    const branch = cycle.isLoading(index) ? 'loading' : 'unloading';
    const text = `${formatQuantity(cycle.value('displacement', index), 'm')} · ${formatQuantity(cycle.value('force_direct', index), 'N')} · ${branch} ${at(cycle.increments, index)} / ${cycle.lastIncrement}`;
    readout.textContent = text;
    slider.setAttribute('aria-valuetext', text);
  };
  selection.onChange(refresh);
  comparison.onChange(listRuns);
  listRuns();
  refresh();
  return el(
    'div',
    { class: 'player', role: 'region', 'aria-label': `Position along the cycle of the ${selection.run.kind.name}` },
    play,
    ...(selection.runs.length > 1 ? [runs] : []),
    cycles,
    slider,
    readout,
  );
}
