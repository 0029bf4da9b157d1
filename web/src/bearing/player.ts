import { shortfallOf } from '../data/outcome';
import { at, type Run } from '../data/run';
import type { Comparison } from '../ui/comparison';
import { formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import { playback } from '../ui/playback';
import type { Selection } from '../ui/selection';

/** A whole cycle takes this long, ms. */
const duration = 9000;

/** Bar at the foot of the window that moves all views along the cycle. */
export function player(selection: Selection, comparison: Comparison): HTMLElement {
  const { slider, play, refresh: move } = playback({
    size: () => selection.cycle.size,
    index: () => selection.index,
    show: (index) => selection.show({ index }),
    duration: () => duration,
    of: () => selection.cycle,
    changed: () => refresh(),
    words: { slider: 'Increment of the cycle', play: 'Play the cycle' },
  });
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

  let listed: Run | undefined;
  const refresh = (): void => {
    const { run, cycle, index } = selection;
    if (run !== listed) {
      listed = run;
      runs.selectedIndex = comparison.shownFoils.indexOf(run);
      cycles.replaceChildren(...run.cycles.map(({ name }) => el('option', {}, name)));
    }
    cycles.selectedIndex = run.cycles.indexOf(cycle);
    move();
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
