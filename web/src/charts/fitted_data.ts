import { toCsv } from '../data/csv';
import type { Fit, FittedPoint } from '../data/fit';
import { at, largest } from '../data/run';
import { axisTitle, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option } from './chart';
import { ChartPanel } from './chart_panel';
import { lineEntry, markEntry, plainLook } from './grid_lines';

interface Drawn {
  title: string;
  name: string;
  unit: string;
  text: string;
  csv: [string, (point: FittedPoint) => number][];
  /** Drawn as marks. */
  value: (point: FittedPoint) => number;
  /** Drawn as a line. */
  line?: (point: FittedPoint) => number;
  zones?: number[];
}

/** A chart of one quantity of some data over their axis, each series with its marks and its line. */
function overAxis(fit: Fit, data: number, quantity: number, { title, name, unit, text, csv, value, line, zones }: Drawn): HTMLElement {
  const { axis: axisName, axisUnit, series } = fit.measured(data);
  const { unit: quantityUnit } = at(fit.measured(data).quantities, quantity);
  const points = fit.points(data, quantity);
  // Speeds are read in revolutions.
  const along = scaleFor(largest(points.map(({ place }) => place)), axisName === 'Speed' ? 'rpm' : axisUnit);
  const up = unit === '' ? { factor: 1, unit: '' } : scaleFor(largest(points.map((point) => Math.abs(value(point)))), unit);
  const lists = series.map((_, i) => points.filter((point) => point.series === i));
  const pair = (point: FittedPoint, y: number): [number, number] => [point.place * along.factor, y * up.factor];
  const places = points.map(({ place }) => place * along.factor);
  const option = (current: Look): Option => ({
    grid: { left: 66, right: 18, top: 14, bottom: 48 },
    xAxis: axis(current, axisTitle(axisName, along), { scale: true }),
    yAxis: axis(current, axisTitle(name, up), { nameGap: 48, scale: true }),
    tooltip: tooltip(current, {
      trigger: 'item',
      formatter: ({ seriesIndex, dataIndex }: { seriesIndex: number; dataIndex: number }) => {
        const point = lists[seriesIndex % series.length]?.[dataIndex];
        if (!point) return '';
        return tooltipBox(`${at(series, point.series)}, ${formatNumber(point.place * along.factor)} ${along.unit}`, [
          ['Measured', formatQuantity(point.measured, quantityUnit)],
          ['Fitted', formatQuantity(point.model, quantityUnit)],
          ['Residual', `${formatNumber(point.residual / point.deviation, 3)} standard deviations`],
          ['Readings', String(point.readings)],
        ]);
      },
    }),
    series: [
      ...lists.map((list, i) => ({
        type: 'line',
        name: series[i],
        data: list.map((point) => pair(point, value(point))),
        symbol: plainLook(i).marker,
        symbolSize: 6,
        showAllSymbol: true,
        lineStyle: { width: 0 },
        itemStyle: { color: plainLook(i).colour(current) },
      })),
      ...(line
        ? lists.map((list, i) => ({
            type: 'line',
            name: `fitted, ${series[i] ?? ''}`,
            data: list.map((point) => pair(point, line(point))),
            showSymbol: false,
            lineStyle: { width: 2, color: plainLook(i).colour(current) },
            itemStyle: { color: plainLook(i).colour(current) },
          }))
        : []),
      ...(zones ?? []).map((y) => ({
        type: 'line',
        silent: true,
        data: [Math.min(...places), Math.max(...places)].map((end) => [end, y]),
        showSymbol: false,
        lineStyle: { width: 1, type: 'dashed', color: current.muted },
      })),
    ],
  });
  return new ChartPanel({
    title: fit.count > 1 ? `${title}, data ${data + 1}` : title,
    subject: () => `${text} · ${fit.label}`,
    legend: () => series.map((one, i) => (line ? lineEntry : markEntry)(plainLook(i), one)),
    file: () => fileName(title, String(data + 1), fit.label),
    description: () => `${name} over ${axisName.toLowerCase()}: ${text}`,
    csv: () => toCsv(['series', 'place', ...csv.map(([key]) => key)], points.map((point) => [at(series, point.series), point.place, ...csv.map(([, number]) => number(point))])),
    option,
  }).root;
}

/** Measured and fitted values of all that some data hold, and what they differ by. */
export function fittedData(fit: Fit, data: number): HTMLElement[] {
  return fit.measured(data).quantities.flatMap(({ title, unit }, quantity) => [
    overAxis(fit, data, quantity, {
      title: `Measured and fitted ${title.toLowerCase()}`,
      name: title,
      unit,
      text: 'marks: measured; lines: fitted',
      csv: [
        ['measured', ({ measured }) => measured],
        ['fitted', ({ model }) => model],
      ],
      value: ({ measured }) => measured,
      line: ({ model }) => model,
    }),
    overAxis(fit, data, quantity, {
      title: `Residuals of the ${title.toLowerCase()}`,
      name: 'Residual (std. deviations)',
      unit: '',
      text: 'measured minus fitted, over its standard deviation; of pure noise, 95 % lies between the dashed lines',
      csv: [
        ['residual', ({ residual }) => residual],
        ['deviation', ({ deviation }) => deviation],
      ],
      value: ({ residual, deviation }) => residual / deviation,
      zones: [-1.96, 1.96],
    }),
  ]);
}
