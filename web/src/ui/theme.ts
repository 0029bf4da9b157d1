import type { ContactState } from '../data/run';

/** Colours that drawings need as values, since they are saved without the style sheet. */
export interface Look {
  background: string;
  text: string;
  muted: string;
  line: string;
  grid: string;
  /** Of curves: safe for the colour-blind, each with its own marker and dash besides. */
  series: string[];
  /** Of families of curves, from the least to the greatest value. */
  ramp: string[];
  states: Record<ContactState, string>;
  journal: string;
  topFoil: string;
  bumpFoil: string;
  sleeve: string;
  force: string;
  friction: string;
  accent: string;
}

const light: Look = {
  background: '#ffffff',
  text: '#1c2329',
  muted: '#5a6670',
  line: '#b9c1c8',
  grid: '#e7eaed',
  series: ['#0067a8', '#cf5200', '#00825f', '#a4478a', '#7a6a00', '#3f8fc4', '#5b5f66', '#8c3b2e'],
  ramp: ['#1f3ea8', '#7a2ea0', '#c0306e', '#d4570f', '#a87400'],
  states: { open: '#ffffff', stick: '#7d8890', 'slip forward': '#d55e00', 'slip backward': '#0072b2' },
  journal: '#e3e8ec',
  topFoil: '#1c2329',
  bumpFoil: '#0067a8',
  sleeve: '#8b959e',
  force: '#1c2329',
  friction: '#cf5200',
  accent: '#0067a8',
};

const dark: Look = {
  background: '#1a2026',
  text: '#e5e9ec',
  muted: '#a0abb5',
  line: '#56616b',
  grid: '#2b333b',
  series: ['#5eb3ee', '#ff9252', '#43c99d', '#e39acb', '#d8c44a', '#9ccbea', '#b9bfc6', '#e08a7b'],
  ramp: ['#7f9bff', '#b98af5', '#f07aa8', '#ff9d66', '#ffd166'],
  states: { open: '#1a2026', stick: '#8b97a1', 'slip forward': '#ff9252', 'slip backward': '#5eb3ee' },
  journal: '#2f3942',
  topFoil: '#e5e9ec',
  bumpFoil: '#5eb3ee',
  sleeve: '#7b8791',
  force: '#e5e9ec',
  friction: '#ff9252',
  accent: '#5eb3ee',
};

export const fontFamily = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

/** Markers of curves, in the order of the colours. */
export const markers = ['circle', 'triangle', 'rect', 'diamond', 'pin', 'roundRect', 'arrow', 'circle'] as const;

const prefersDark = window.matchMedia('(prefers-color-scheme: dark)');
const listeners: (() => void)[] = [];
let chosen: 'light' | 'dark' | undefined;
let printing = false;

export function isDark(): boolean {
  return !printing && (chosen ? chosen === 'dark' : prefersDark.matches);
}

export function isPrinting(): boolean {
  return printing;
}

/** Colour of a family at a fraction of its range. */
export function rampColour(current: Look, fraction: number): string {
  return mixedColour(current.ramp, fraction);
}

/** Colour of an intensity: none of it is that of the background. */
export function intensityColour(current: Look, fraction: number): string {
  return mixedColour([current.background, ...current.ramp], fraction);
}

function mixedColour(stops: string[], fraction: number): string {
  const place = Math.min(Math.max(0, fraction), 1) * (stops.length - 1);
  const lower = Math.min(Math.floor(place), stops.length - 2);
  const channels = [lower, lower + 1].map((i) => [1, 3, 5].map((k) => parseInt(stops[i]?.slice(k, k + 2) ?? '0', 16)));
  const mixed = [0, 1, 2].map((k) => {
    const [from, to] = [channels[0]?.[k] ?? 0, channels[1]?.[k] ?? 0];
    return Math.round(from + (place - lower) * (to - from));
  });
  return `#${mixed.map((value) => value.toString(16).padStart(2, '0')).join('')}`;
}

export function look(): Look {
  return isDark() ? dark : light;
}

export function onLookChange(listener: () => void): void {
  listeners.push(listener);
}

/** Before paper is drawn on, and after. */
export function onPrint(listener: () => void): void {
  for (const event of ['beforeprint', 'afterprint']) window.addEventListener(event, listener);
}

function apply(): void {
  document.documentElement.dataset['theme'] = isDark() ? 'dark' : 'light';
  for (const listener of listeners) listener();
}

export function toggleTheme(): void {
  chosen = isDark() ? 'light' : 'dark';
  apply();
}

/** Follows the system until the user chooses; paper is always light. */
export function startTheme(): void {
  apply();
  prefersDark.addEventListener('change', apply);
  const print = (now: boolean): void => {
    printing = now;
    document.documentElement.classList.toggle('printing', now);
    apply();
  };
  window.addEventListener('beforeprint', () => print(true));
  window.addEventListener('afterprint', () => print(false));
}
