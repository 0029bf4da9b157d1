/** How sleeves and journals differ from circles, over the angle. */
import { toCsv } from '../data/csv';
import { decodeNumbers } from '../data/decode';
import type { Result } from '../data/result';
import { at, largest } from '../data/run';
import { axisTitle, formatQuantity, scaleFor } from '../data/units';
import { svg } from '../ui/dom';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option } from './chart';
import { ChartPanel } from './chart_panel';

/** Results whose bearings stand side by side. */
export interface ComparedBearings {
  /** Whose bearings are shown. */
  focus: Result[];
  names: string;
  onChange(listener: () => void): void;
}

interface Line {
  text: string;
  /** Of the column in files. */
  key: string;
  /** At equal angles from X on to X again, m; NaN where no foils lie. */
  values: number[];
  colour: (current: Look) => string;
  dash: 'solid' | number[];
}

const parts = [
  { name: 'sleeve', text: 'sleeve', dash: 'solid' },
  { name: 'journal', text: 'journal', dash: [7, 3] },
  { name: 'taper', text: 'taper of the sleeve alone', dash: [2, 3] },
] as const;

/** Runs of one bearing have its lines once. */
function linesOf(results: Result[]): Line[] {
  const bearings = new Map<string, Result[]>();
  for (const result of results) {
    const key = JSON.stringify(result.data.deviations ?? null);
    bearings.set(key, [...(bearings.get(key) ?? []), result]);
  }
  const alone = bearings.size === 1;
  return [...bearings.values()].flatMap((same, bearing) => {
    const label = same.map((result) => result.label).join(', ');
    return parts.flatMap(({ name, text, dash }, part): Line[] => {
      const given = at(same, 0).data.deviations?.[name];
      if (given === undefined) return [];
      return [
        {
          text: alone ? text : `${text}, ${label}`,
          key: alone ? name : `${name}_${label}`,
          values: [...decodeNumbers(given)],
          colour: (current) => at(current.series, (alone ? part : bearing) % current.series.length),
          dash: dash === 'solid' ? dash : [...dash],
        },
      ];
    });
  });
}

/** Deviations of the radii; hidden while all that is shown is round, and nothing where all is always. */
export function deviationChart(bearings: ComparedBearings, all: Result[]): HTMLElement[] {
  if (!all.some(({ data }) => data.deviations)) return [];
  let lines: Line[] = [];
  const known = (values: number[]): number[] => values.filter(Number.isFinite);
  const angle = (i: number): number => (360 * i) / (at(lines, 0).values.length - 1);
  const caption = ({ text, values }: Line): string => {
    const [least, most] = [Math.min(...known(values)), Math.max(...known(values))];
    return `${text} ${formatQuantity(least, 'm', 3)} to ${formatQuantity(most, 'm', 3)}`;
  };
  const option = (current: Look): Option => {
    const scale = scaleFor(largest(...lines.map(({ values }) => known(values))), 'm');
    return {
      grid: { left: 62, right: 24, top: 16, bottom: 48 },
      xAxis: axis(current, 'Angle from X towards Y (°)', { min: 0, max: 360, interval: 45, axisLine: { onZero: false, lineStyle: { color: current.line } } }),
      yAxis: axis(current, axisTitle('Deviation of the radius', scale), { nameGap: 42 }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        formatter: (items: { dataIndex: number }[]) => {
          const i = items[0]?.dataIndex ?? 0;
          return tooltipBox(`${angle(i)}° from X towards Y`, lines.map(({ text, values }) => [text, formatQuantity(values[i], 'm', 3)]));
        },
      }),
      series: lines.map(({ text, values, colour, dash }) => ({
        type: 'line',
        name: text,
        symbol: 'none',
        lineStyle: { color: colour(current), width: 1.8, type: dash },
        itemStyle: { color: colour(current) },
        data: values.map((value, i) => [angle(i), Number.isFinite(value) ? value * scale.factor : null]),
      })),
    };
  };
  const scattered = all.some(({ data }) => ['montecarlo', 'sweep'].includes(data.kind));
  const panel = new ChartPanel({
    title: 'Sleeve and journal, out of round',
    note: `Radial deviations from nominal${scattered ? ', as in the case: single bearings may have other waves' : ''}. Drawings of the bearing show round parts.`,
    subject: () => [...lines.map(caption), bearings.names].join(' · '),
    legend: () =>
      lines.map(({ text, colour, dash }) => ({
        width: 30,
        draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: colour(current), 'stroke-width': 2, 'stroke-dasharray': dash === 'solid' ? 'none' : dash.join(' ') })],
        text,
      })),
    file: () => fileName('deviations', bearings.names),
    csv: () => toCsv(['phi_deg', ...lines.map(({ key }) => `${key}_deviation_m`)], at(lines, 0).values.map((_, i) => [angle(i), ...lines.map(({ values }) => values[i])])),
    description: () => `Radial deviation against the angle: ${lines.map(caption).join('; ')}`,
    option,
  });
  const show = (): void => {
    lines = linesOf(bearings.focus);
    panel.root.hidden = lines.length === 0;
    if (lines.length > 0) panel.refresh();
  };
  bearings.onChange(show);
  show();
  return [panel.root];
}
