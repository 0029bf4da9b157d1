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
  runs.addEventListener('change', () => selection.show({ run: at(comparison.shown, runs.selectedIndex) }));
  const listRuns = (): void => {
    runs.replaceChildren(...comparison.shown.map(({ label }) => el('option', {}, label)));
    runs.selectedIndex = comparison.shown.indexOf(selection.run);
  };
  const loops = el('select', { 'aria-label': at(selection.runs, 0).kind.loops.title });
  loops.addEventListener('change', () => {
    selection.show({ key: at(selection.run.loops, loops.selectedIndex).key });
  });

  let frame = 0;
  const stop = (): void => {
    cancelAnimationFrame(frame);
    frame = 0;
    refresh();
  };
  const start = (): void => {
    const { loop } = selection;
    const first = selection.index >= loop.size - 1 ? 0 : selection.index;
    const began = performance.now() - (duration * first) / Math.max(1, loop.size - 1);
    const step = (now: number): void => {
      if (selection.loop !== loop) return stop();
      const index = Math.floor((Math.max(0, now - began) / duration) * (loop.size - 1));
      frame = requestAnimationFrame(step);
      if (index !== selection.index) selection.show({ index });
      if (index >= loop.size - 1) stop();
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
    const { run, loop, index } = selection;
    if (run !== listed) {
      listed = run;
      runs.selectedIndex = comparison.shown.indexOf(run);
      loops.replaceChildren(...run.loops.map(({ name }) => el('option', {}, name)));
    }
    loops.selectedIndex = run.loops.indexOf(loop);
    slider.max = String(Math.max(0, loop.size - 1));
    slider.value = String(index);
    slider.disabled = loop.size === 0;
    play.disabled = loop.size === 0;
    play.textContent = frame === 0 ? '▶' : '❚❚';
    play.setAttribute('aria-label', frame === 0 ? 'Play the cycle' : 'Pause');
    if (loop.size === 0) {
      readout.textContent = `${loop.name}: ${shortfallOf(run, loop) ?? 'no increment'}`;
      return;
    }
    const branch = loop.isLoading(index) ? 'loading' : 'unloading';
    const text = `${formatQuantity(loop.value('displacement', index), 'm')} · ${formatQuantity(loop.value('force_direct', index), 'N')} · ${branch} ${at(loop.increments, index)} / ${loop.lastIncrement}`;
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
    loops,
    slider,
    readout,
  );
}
