import { el } from './dom';

/** What a slider and a button beside it move through. */
export interface Played {
  /** Places, from 0. */
  size: () => number;
  index: () => number;
  show: (index: number) => void;
  /** From the first place to the last, ms. */
  duration: () => number;
  /** What it is that is moved through: another one ends the play. */
  of: () => unknown;
  /** After the play began or ended. */
  changed: () => void;
  /** Of the slider and of the button. */
  words: { slider: string; play: string };
}

/** A slider, and a button that moves it along. `refresh` is to be called when anything of it has changed. */
export function playback({ size, index, show, duration, of, changed, words }: Played): { slider: HTMLInputElement; play: HTMLButtonElement; refresh: () => void } {
  const slider = el('input', { type: 'range', min: 0, step: 1, 'aria-label': words.slider });
  const play = el('button', { type: 'button', class: 'play' });
  let frame = 0;
  const stop = (): void => {
    cancelAnimationFrame(frame);
    frame = 0;
    changed();
  };
  const start = (): void => {
    const played = of();
    const last = size() - 1;
    const first = index() >= last ? 0 : index();
    const began = performance.now() - (duration() * first) / Math.max(1, last);
    const step = (now: number): void => {
      if (of() !== played) return stop();
      const reached = Math.min(last, Math.floor((Math.max(0, now - began) / duration()) * last));
      frame = requestAnimationFrame(step);
      if (reached !== index()) show(reached);
      if (reached >= last) stop();
    };
    frame = requestAnimationFrame(step);
    changed();
  };
  play.addEventListener('click', () => (frame === 0 ? start() : stop()));
  slider.addEventListener('input', () => {
    if (frame !== 0) stop();
    show(Number(slider.value));
  });
  const refresh = (): void => {
    slider.max = String(Math.max(0, size() - 1));
    slider.value = String(index());
    slider.disabled = size() === 0;
    play.disabled = size() === 0;
    play.textContent = frame === 0 ? '▶' : '❚❚';
    play.setAttribute('aria-label', frame === 0 ? words.play : 'Pause');
  };
  return { slider, play, refresh };
}
