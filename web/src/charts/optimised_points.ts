import { toCsv } from '../data/csv';
import type { Optimisation, OptimisedPoint } from '../data/optimisation';
import { capital, largest } from '../data/run';
import { axisTitle, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { svg } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option } from './chart';
import { ChartPanel } from './chart_panel';

/** A number of a point along an axis. */
interface PointAxis {
  name: string;
  /** What files call it. */
  column: string;
  unit: string;
  of: (point: OptimisedPoint) => number;
}

interface PointChart {
  title: string;
  subject: string;
  across: PointAxis;
  upwards: PointAxis;
  /** Points that a line joins. */
  line: OptimisedPoint[];
  lineText: string;
}

export function keyAxis(result: Optimisation, i: number): PointAxis {
  const key = result.summary.keys[i];
  return { name: key ? result.titleOf(key.key) : '', column: key?.key ?? '', unit: key ? result.unitOf(key) : '', of: (point) => point.values[i] ?? NaN };
}

export function aimAxis(result: Optimisation, i: number): PointAxis {
  const aim = result.summary.aims[i];
  return { name: aim ? capital(result.nameOf(aim.quantity)) : '', column: aim?.quantity ?? '', unit: aim ? result.unitOf(aim) : '', of: (point) => point.aims[i] ?? NaN };
}

const evaluation: PointAxis = { name: 'Evaluation', column: 'Evaluation', unit: '', of: (point) => point.number + 1 };

function circle(fill: (current: Look) => string, stroke: (current: Look) => string): (current: Look) => SVGElement[] {
  return (current) => [svg('circle', { cx: 13, cy: 6, r: 3.5, fill: fill(current), stroke: stroke(current), 'stroke-width': 1.5 })];
}

/** Points in a plane: filled where they meet all limits, hollow where they do not, and the best with a ring. */
export function pointChart(result: Optimisation, { title, subject, across, upwards, line, lineText }: PointChart): HTMLElement {
  const shown = result.points.filter((point) => Number.isFinite(across.of(point)) && Number.isFinite(upwards.of(point)));
  const scales = [across, upwards].map(({ unit, of }) => scaleFor(largest(shown.map((point) => Math.abs(of(point)))), unit));
  const [x = { factor: 1, unit: '' }, y = { factor: 1, unit: '' }] = scales;
  const place = (point: OptimisedPoint): [number, number] => [across.of(point) * x.factor, upwards.of(point) * y.factor];
  const marks = (name: string, points: OptimisedPoint[], style: Option): Option => ({
    type: 'line',
    name,
    data: points.map((point) => ({ value: place(point), point })),
    symbol: 'circle',
    lineStyle: { width: 0 },
    ...style,
  });
  const { best } = result;
  const option = (current: Look): Option => ({
    grid: { left: 70, right: 22, top: 16, bottom: 48 },
    xAxis: axis(current, axisTitle(across.name, x), { scale: true }),
    yAxis: axis(current, axisTitle(upwards.name, y), { nameGap: 52, scale: true }),
    tooltip: tooltip(current, {
      trigger: 'item',
      formatter: ({ data }: { data: { point?: OptimisedPoint } }) => {
        const { point } = data;
        if (!point) return '';
        const { keys, aims } = result.summary;
        return tooltipBox(`Point ${point.number}${point.feasible ? '' : ', misses a limit'}`, [
          ...aims.map((aim, i): [string, string] => [result.nameOf(aim.quantity), formatQuantity(point.aims[i], result.unitOf(aim), 5)]),
          ...keys.map((key, i): [string, string] => [result.titleOf(key.key), formatQuantity(point.values[i], result.unitOf(key), 5)]),
        ]);
      },
    }),
    series: [
      { type: 'line', name: lineText, silent: true, showSymbol: false, data: line.map(place), lineStyle: { width: 1.5, color: current.muted } },
      marks('missed', shown.filter((point) => !point.feasible), { symbolSize: 7, itemStyle: { color: current.background, borderColor: current.muted, borderWidth: 1.5 } }),
      marks('met', shown.filter((point) => point.feasible), { symbolSize: 7, itemStyle: { color: current.accent } }),
      marks('best', best ? [best] : [], { symbolSize: 14, itemStyle: { color: 'transparent', borderColor: current.text, borderWidth: 2 } }),
    ],
  });
  const legend: LegendEntry[] = [
    { width: 26, draw: circle((current) => current.accent, (current) => current.accent), text: 'meets all limits' },
    ...(shown.some((point) => !point.feasible) ? [{ width: 26, draw: circle((current) => current.background, (current) => current.muted), text: 'misses a limit' }] : []),
    ...(best ? [{ width: 26, draw: (current: Look) => [svg('circle', { cx: 13, cy: 6, r: 5, fill: 'none', stroke: current.text, 'stroke-width': 2 })], text: 'best' }] : []),
    ...(line.length > 1 ? [{ width: 26, draw: (current: Look) => [svg('line', { x1: 1, y1: 6, x2: 25, y2: 6, stroke: current.muted, 'stroke-width': 1.5 })], text: lineText }] : []),
  ];
  return new ChartPanel({
    title,
    subject: () => `${subject} · ${result.label}`,
    legend: () => legend,
    file: () => fileName(title, result.label),
    description: () => `${title}: ${shown.length} points${best ? `, the best at ${formatNumber(place(best)[0])} ${x.unit}, ${formatNumber(place(best)[1])} ${y.unit}` : ''}`,
    csv: () =>
      toCsv(
        ['point', across.column, upwards.column, 'feasible'],
        shown.map((point) => [point.number, across.of(point), upwards.of(point), point.feasible]),
      ),
    option,
  }).root;
}

/** An aim over the evaluations, and the best so far. */
export function aimHistory(result: Optimisation, aim: number): HTMLElement {
  const upwards = aimAxis(result, aim);
  const sign = result.summary.aims[aim]?.maximise === true ? 1 : -1;
  const steps: OptimisedPoint[] = [];
  for (const point of result.points) {
    const last = steps[steps.length - 1];
    const better = point.feasible && (!last || sign * upwards.of(point) > sign * upwards.of(last));
    const kept = better ? point : last;
    // The best so far at this evaluation.
    if (kept) steps.push({ ...kept, number: point.number });
  }
  return pointChart(result, {
    title: `${upwards.name} over evaluations`,
    subject: sign > 0 ? 'maximised' : 'minimised',
    across: evaluation,
    upwards,
    line: steps,
    lineText: 'best so far',
  });
}
