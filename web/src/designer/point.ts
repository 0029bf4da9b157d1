/** The requested operating point. */
import type { CaseValue } from '../data/format';
import { vectorText } from '../data/grid';
import { speedText } from '../data/states';

/** SI. */
export interface Point {
  speed: number;
  held: 'loads' | 'positions';
  journal: [number, number];
}

/** Of [equilibrium], as the case is understood. */
export interface RunningSettings {
  speeds?: number[];
  loads?: [number, number][];
  positions?: [number, number][];
}

export function settingsOf(value: CaseValue | undefined): RunningSettings {
  return (value ?? {}) as RunningSettings;
}

/** The first speed of a case with its first load or position. */
export function pointOf({ speeds, loads, positions }: RunningSettings): Point | undefined {
  const [speed, load, position] = [speeds?.[0], loads?.[0], positions?.[0]];
  if (speed === undefined) return undefined;
  return load ? { speed, held: 'loads', journal: load } : position ? { speed, held: 'positions', journal: position } : undefined;
}

export function textOf({ speed, held, journal }: Point): string {
  return `${speedText(speed)}, ${held === 'loads' ? `load ${vectorText(...journal, 'N')}` : `position ${vectorText(...journal, 'm')}`}`;
}

export function isSame([a, b]: [number, number], [x, y]: [number, number]): boolean {
  return Math.hypot(a - x, b - y) <= 1e-9 * Math.hypot(x, y);
}
