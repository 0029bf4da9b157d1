import { toCsv } from '../data/csv';
import type { LimitData } from '../data/format';
import { vectorText } from '../data/grid';
import { speedText, type States } from '../data/states';
import { formatQuantity } from '../data/units';
import { el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { scroller } from '../ui/scroller';

function isSpeed({ kind }: LimitData): boolean {
  return kind === 'lift_off_speed';
}

function nameOf(limit: LimitData): string {
  const { speed_rad_per_s: speed, load_x_N: x, load_y_N: y } = limit.thick;
  return isSpeed(limit) ? `Lift-off speed under ${vectorText(x, y, 'N')}` : `Load capacity at ${speedText(speed)}`;
}

function sizeText(speed: number | null | undefined, load: number | null | undefined): string {
  if (typeof speed === 'number') return speedText(speed);
  return typeof load === 'number' ? formatQuantity(load, 'N') : 'none';
}

function unstableText({ unstable = [] }: LimitData): string {
  const ranges = unstable.map((range) => {
    const from = sizeText(range.from_speed_rad_per_s, range.from_load_N);
    const to = sizeText(range.to_speed_rad_per_s, range.to_load_N);
    return from === to ? from : `${from} to ${to}`;
  });
  return ranges.join(', ') || '–';
}

function boundText(limit: LimitData): string {
  return limit.bounded_by?.replaceAll('_', ' ') ?? '–';
}

/** Lift-off speeds and load capacities, with the film on both sides of them and unstable states on the way; nothing where they were not requested. */
export function limitTable(states: States): HTMLElement[] {
  const { limits } = states;
  if (limits.length === 0) return [];
  const rows = limits.map((limit) => [
    sizeText(limit.speed_rad_per_s, limit.load_N),
    boundText(limit),
    unstableText(limit),
    formatQuantity(limit.thick.h_min_m, 'm'),
    formatQuantity(limit.thin.h_min_m, 'm'),
    limit.status.replaceAll('_', ' '),
  ]);
  const heads = ['Limit', 'value', 'bounded by', 'unstable', 'film at the limit', 'film beyond it', 'status'];
  const panel = new Panel(
    {
      title: 'Lift-off speeds and load capacities',
      subject: () => `Up to the last state that is stable with the journal held, on a film of film.h_lift_off or more · ${states.label}`,
      file: () => fileName('limits', states.label),
      csv: () =>
        toCsv(
          ['limit', 'speed_rad_per_s', 'load_N', 'bounded_by', 'unstable', 'h_thick_m', 'h_thin_m', 'status'],
          limits.map((limit) => [nameOf(limit), limit.speed_rad_per_s, limit.load_N, boundText(limit), unstableText(limit), limit.thick.h_min_m, limit.thin.h_min_m, limit.status]),
        ),
    },
    scroller(
      'Table of limits',
      el(
        'table',
        { class: 'results' },
        el('thead', {}, el('tr', {}, ...heads.map((text) => el('th', { scope: 'col' }, text)))),
        el('tbody', {}, ...limits.map((limit, i) => el('tr', {}, el('th', { scope: 'row' }, nameOf(limit)), ...(rows[i] ?? []).map((text) => el('td', {}, text))))),
      ),
    ),
  );
  return [panel.root];
}
