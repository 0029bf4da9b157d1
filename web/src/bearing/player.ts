import { at, directionName, type Run } from '../data/run';
import { formatQuantity } from '../data/units';
import { dropDown, el } from '../ui/dom';
import type { Selection } from '../ui/selection';

/** A whole cycle takes this long, ms. */
const duration = 9000;

/** Bar at the foot of the window that moves all views along the cycle. */
export function player(selection: Selection): HTMLElement {
  const slider = el('input', { type: 'range', min: 0, step: 1, 'aria-label': 'Increment of the cycle' });
  const play = el('button', { type: 'button', class: 'play' });
  const readout = el('output', {});
  const runs = dropDown<Run>(
    'Run',
    selection.runs.map((run) => ({ value: run, text: run.label })),
    (run) => selection.show({ run }),
  );
  const directions = el('select', { 'aria-label': 'Direction' });
  directions.addEventListener('change', () => {
    selection.show({ degrees: at(selection.run.directions, directions.selectedIndex).degrees });
  });

  let frame = 0;
  const stop = (): void => {
    cancelAnimationFrame(frame);
    frame = 0;
    refresh();
  };
  const start = (): void => {
    const { direction } = selection;
    const first = selection.index >= direction.size - 1 ? 0 : selection.index;
    const began = performance.now() - (duration * first) / Math.max(1, direction.size - 1);
    const step = (now: number): void => {
      if (selection.direction !== direction) return stop();
      const index = Math.floor((Math.max(0, now - began) / duration) * (direction.size - 1));
      frame = requestAnimationFrame(step);
      if (index !== selection.index) selection.show({ index });
      if (index >= direction.size - 1) stop();
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
    const { run, direction, index } = selection;
    if (run !== listed) {
      listed = run;
      runs.selectedIndex = selection.runs.indexOf(run);
      directions.replaceChildren(...run.directions.map(({ degrees }) => el('option', {}, directionName(degrees))));
    }
    directions.selectedIndex = run.directions.indexOf(direction);
    slider.max = String(Math.max(0, direction.size - 1));
    slider.value = String(index);
    slider.disabled = direction.size === 0;
    play.disabled = direction.size === 0;
    play.textContent = frame === 0 ? '▶' : '❚❚';
    play.setAttribute('aria-label', frame === 0 ? 'Play the cycle' : 'Pause');
    if (direction.size === 0) {
      readout.textContent = 'this direction was not begun';
      return;
    }
    const branch = direction.isLoading(index) ? 'loading' : 'unloading';
    const text = `${formatQuantity(direction.value('displacement', index), 'm')} · ${formatQuantity(direction.value('force_direct', index), 'N')} · ${branch} ${at(direction.increments, index)} / ${2 * direction.steps}`;
    readout.textContent = text;
    slider.setAttribute('aria-valuetext', text);
  };
  selection.onChange(refresh);
  refresh();
  return el(
    'div',
    { class: 'player', role: 'region', 'aria-label': 'Position along the cycle' },
    play,
    ...(selection.runs.length > 1 ? [runs] : []),
    directions,
    slider,
    readout,
  );
}
