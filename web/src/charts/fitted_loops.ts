import { toCsv } from '../data/csv';
import type { Fit, FittedPoint } from '../data/fit';
import { largest } from '../data/run';
import { axisTitle, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { svg } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option } from './chart';
import { ChartPanel } from './chart_panel';

const branches = ['push', 'pull'] as const;
const symbols = ['circle', 'triangle'] as const;

function colourOf(current: Look, branch: number): string {
  return current.series[branch] ?? current.text;
}

function marker(current: Look, branch: number): SVGElement {
  const fill = colourOf(current, branch);
  return branch === 0 ? svg('circle', { cx: 13, cy: 6, r: 3, fill }) : svg('path', { d: 'M13 2 L17 9 L9 9 Z', fill });
}

function legend(lines: boolean): LegendEntry[] {
  return branches.flatMap((name, branch): LegendEntry[] => [
    { width: 26, draw: (current) => [marker(current, branch)], text: `${lines ? 'measured, ' : ''}${name}` },
    ...(lines ? [{ width: 26, draw: (current: Look) => [svg('line', { x1: 1, y1: 6, x2: 25, y2: 6, stroke: colourOf(current, branch), 'stroke-width': 2 })], text: `fitted, ${name}` }] : []),
  ]);
}

/** A chart over the displacement of a loop; `value` is drawn as marks, `line` through them. */
function overDisplacement(
  fit: Fit,
  data: number,
  words: { title: string; name: string; unit: string; text: string; csv: [string, (point: FittedPoint) => number][]; value: (point: FittedPoint) => number; line?: (point: FittedPoint) => number; zones?: number[] },
): HTMLElement {
  const points = fit.points(data);
  const of = (branch: number): FittedPoint[] => points.filter(({ pull }) => pull === (branch === 1));
  const along = scaleFor(largest(points.map(({ displacement }) => displacement)), 'm');
  const up = words.unit === '' ? { factor: 1, unit: '' } : scaleFor(largest(points.map(words.value)), words.unit);
  const pair = (point: FittedPoint, y: number): [number, number] => [point.displacement * along.factor, y * up.factor];
  const option = (current: Look): Option => ({
    grid: { left: 62, right: 18, top: 14, bottom: 48 },
    xAxis: axis(current, axisTitle('Displacement', along), { scale: true }),
    yAxis: axis(current, axisTitle(words.name, up), { nameGap: 44, scale: true }),
    tooltip: tooltip(current, {
      trigger: 'item',
      formatter: ({ seriesIndex, dataIndex }: { seriesIndex: number; dataIndex: number }) => {
        const branch = seriesIndex % 2;
        const point = of(branch)[dataIndex];
        if (!point) return '';
        return tooltipBox(`${branches[branch] ?? ''}, ${formatQuantity(point.displacement, 'm')}`, [
          ['Measured', formatQuantity(point.measured, 'N')],
          ['Fitted', formatQuantity(point.fitted, 'N')],
          ['Residual', `${formatNumber(point.residual / point.deviation, 3)} standard deviations`],
          ['Readings', String(point.readings)],
        ]);
      },
    }),
    series: [
      ...branches.map((name, branch) => ({
        type: 'line',
        name,
        data: of(branch).map((point) => pair(point, words.value(point))),
        symbol: symbols[branch],
        symbolSize: 6,
        showAllSymbol: true,
        lineStyle: { width: 0 },
        itemStyle: { color: colourOf(current, branch) },
      })),
      ...(words.line
        ? branches.map((name, branch) => ({
            type: 'line',
            name: `fitted, ${name}`,
            data: of(branch).map((point) => pair(point, words.line?.(point) ?? NaN)),
            showSymbol: false,
            lineStyle: { width: 2, color: colourOf(current, branch) },
            itemStyle: { color: colourOf(current, branch) },
          }))
        : []),
      ...(words.zones ?? []).map((y) => ({
        type: 'line',
        silent: true,
        data: [Math.min, Math.max].map((end) => [end(...points.map(({ displacement }) => displacement * along.factor)), y]),
        showSymbol: false,
        lineStyle: { width: 1, type: 'dashed', color: current.muted },
      })),
    ],
  });
  return new ChartPanel({
    title: fit.loops > 1 ? `${words.title} ${data + 1}` : words.title,
    subject: () => `${words.text} · ${fit.label}`,
    legend: () => legend(words.line !== undefined),
    file: () => fileName(words.title, String(data + 1), fit.label),
    description: () => `${words.name} over displacement: ${words.text}`,
    csv: () => toCsv(['branch', 'displacement_m', ...words.csv.map(([name]) => name)], points.map((point) => [branches[point.pull ? 1 : 0] ?? '', point.displacement, ...words.csv.map(([, value]) => value(point))])),
    option,
  }).root;
}

/** Measured and fitted forces of a loop, and what they differ by. */
export function fittedLoop(fit: Fit, data: number): HTMLElement[] {
  return [
    overDisplacement(fit, data, {
      title: 'Measured and fitted loop',
      name: 'Force',
      unit: 'N',
      text: 'means of the readings in parts of equal arc length',
      csv: [
        ['measured_force_N', ({ measured }) => measured],
        ['fitted_force_N', ({ fitted }) => fitted],
      ],
      value: ({ measured }) => measured,
      line: ({ fitted }) => fitted,
    }),
    overDisplacement(fit, data, {
      title: 'Residuals of the loop',
      name: 'Residual (std. deviations)',
      unit: '',
      text: 'measured less fitted force over its standard deviation; of noise alone, 95 % lie between the dashed lines',
      csv: [
        ['force_residual_N', ({ residual }) => residual],
        ['force_deviation_N', ({ deviation }) => deviation],
      ],
      value: ({ residual, deviation }) => residual / deviation,
      zones: [-1.96, 1.96],
    }),
  ];
}
