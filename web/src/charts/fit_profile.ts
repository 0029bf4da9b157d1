import { toCsv } from '../data/csv';
import type { Fit, FittedParameter } from '../data/fit';
import { largest } from '../data/run';
import { axisTitle, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { svg } from '../ui/dom';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option } from './chart';
import { ChartPanel } from './chart_panel';

/** What the sum of squares rises by where a parameter is held and all others are fitted again. */
export function profileChart(fit: Fit, parameter: FittedParameter): HTMLElement {
  const { key, title, unit, value, standardError, profile } = parameter;
  const scale = scaleFor(largest(profile.map((point) => point.value)), unit);
  // With the estimate of the standard error, where there is one.
  const parabola = (at: number): number => ((at - value) / (standardError ?? NaN)) ** 2;
  const option = (current: Look): Option => ({
    grid: { left: 62, right: 18, top: 14, bottom: 48 },
    xAxis: axis(current, axisTitle(title, scale), { scale: true }),
    yAxis: axis(current, 'Increase (1 at a standard error)', { nameGap: 44 }),
    tooltip: tooltip(current, {
      trigger: 'item',
      formatter: ({ dataIndex }: { dataIndex: number }) => {
        const point = profile[dataIndex];
        return point ? tooltipBox(formatQuantity(point.value, unit, 6), [['Increase of the sum of squares', formatNumber(point.cost)]]) : '';
      },
    }),
    series: [
      {
        type: 'line',
        name: 'profile',
        data: profile.map((point) => [point.value * scale.factor, point.cost]),
        symbol: 'circle',
        symbolSize: 6,
        lineStyle: { width: 2, color: current.accent },
        itemStyle: { color: current.accent },
      },
      {
        type: 'line',
        name: 'parabola',
        silent: true,
        showSymbol: false,
        data: standardError === null ? [] : profile.map((point) => [point.value * scale.factor, parabola(point.value)]),
        lineStyle: { width: 1.5, type: 'dashed', color: current.muted },
      },
    ],
  });
  return new ChartPanel({
    title: `Profile of ${title}`,
    subject: () => `The other parameters are fitted again at each value · ${fit.label}`,
    legend: () => [
      { width: 26, draw: (current) => [svg('line', { x1: 1, y1: 6, x2: 25, y2: 6, stroke: current.accent, 'stroke-width': 2 }), svg('circle', { cx: 13, cy: 6, r: 3, fill: current.accent })], text: 'profile' },
      ...(standardError === null ? [] : [{ width: 26, draw: (current: Look) => [svg('line', { x1: 1, y1: 6, x2: 25, y2: 6, stroke: current.muted, 'stroke-width': 1.5, 'stroke-dasharray': '4 3' })], text: 'parabola of the standard error' }]),
    ],
    file: () => fileName('profile', key, fit.label),
    description: () => `Increase of the sum of squares over ${title}`,
    csv: () => toCsv(['value', 'cost_increase'], profile.map((point) => [point.value, point.cost])),
    option,
  }).root;
}
