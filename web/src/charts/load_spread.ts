import { axisText, numberText, tickText } from '../data/counted';
import { toCsv } from '../data/csv';
import type { Ensemble } from '../data/ensemble';
import { at, largest } from '../data/run';
import { axisTitle, formatNumber, scaleFor, type Scale } from '../data/units';
import { svg } from '../ui/dom';
import type { EnsembleSelection } from '../ui/ensemble_selection';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, roundAbove, tooltip, tooltipBox, type Option, type RenderApi } from './chart';
import { ChartPanel } from './chart_panel';

/** The load of every bump, of cycles at full displacement: its mean over the bearings of an ensemble, and how it scatters. */
export function loadSpread(ensemble: Ensemble, selection: EnsembleSelection): HTMLElement {
  const loads = (): { mean: number[]; deviation: number[] } => ensemble.bumpLoads(selection.direction);
  const most = largest(...ensemble.directions.map((_, i) => {
    const { mean, deviation } = ensemble.bumpLoads(i);
    return mean.map((load, bump) => load + (deviation[bump] ?? 0));
  }));
  const scale: Scale = scaleFor(most, 'N');
  const direction = (): string => at(ensemble.directions, selection.direction);
  const where = ensemble.hasStates ? '' : ' at full displacement';
  const words = (bump: number): string => {
    const { mean, deviation } = loads();
    return `${formatNumber((mean[bump] ?? NaN) * scale.factor)} ± ${formatNumber((deviation[bump] ?? NaN) * scale.factor)} ${scale.unit}`;
  };
  const heaviest = (): number => loads().mean.indexOf(Math.max(...loads().mean.filter(Number.isFinite)));
  const option = (current: Look): Option => {
    const { mean, deviation } = loads();
    const rows = mean.map((load, i) => [i, load * scale.factor, at(deviation, i) * scale.factor]);
    return {
      grid: { left: 54, right: 12, top: 12, bottom: 44 },
      xAxis: axis(current, axisText('bump', ensemble.hasPads), {
        type: 'category',
        data: mean.map((_, i) => tickText(ensemble.counted(i))),
        nameGap: 26,
        axisLabel: { color: current.muted, fontSize: 12 },
        splitLine: { show: false },
        axisTick: { show: false },
      }),
      yAxis: axis(current, axisTitle('Load', scale), { nameGap: 38, min: 0, max: roundAbove(most * scale.factor) }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        axisPointer: { type: 'shadow', shadowStyle: { color: current.grid, opacity: 0.5 } },
        formatter: (items: { dataIndex: number }[]) => {
          const bump = items[0]?.dataIndex ?? 0;
          return tooltipBox(`Bump ${numberText(ensemble.counted(bump))}`, [['Mean ± standard deviation', words(bump)]]);
        },
      }),
      series: [
        { type: 'bar', name: 'mean', itemStyle: { color: current.accent, opacity: 0.8 }, data: rows.map(([, load]) => load) },
        { type: 'custom', name: 'standard deviation', silent: true, clip: true, z: 5, data: rows, renderItem: (_: unknown, api: RenderApi) => whisker(api, current.text) },
      ],
    };
  };
  const panel = new ChartPanel({
    title: 'Bump loads',
    subject: () => `Mean and standard deviation${where} · ${direction()} · ${ensemble.label}`,
    legend: () => [
      { width: 12, draw: (current) => [svg('rect', { x: 2, y: 1, width: 8, height: 11, fill: current.accent, 'fill-opacity': 0.8 })], text: 'mean' },
      { width: 12, draw: (current) => [svg('path', { d: 'M2 1H10M6 1V11M2 11H10', stroke: current.text, 'stroke-width': 1.4, fill: 'none' })], text: 'one standard deviation up and down' },
    ],
    file: () => fileName('bump-loads', ensemble.label, direction()),
    csv: () =>
      toCsv(
        ['bump', ensemble.placeColumn.name, 'mean_N', 'std_N'],
        ensemble.placeColumn.cells.flatMap((place, i) => {
          const { mean, deviation } = ensemble.bumpLoads(i);
          return mean.map((load, bump) => [bump + 1, place, load, deviation[bump]]);
        }),
      ),
    description: () => {
      const bump = heaviest();
      return `Loads of the bumps${where}, ${direction()}: ${bump < 0 ? 'not known' : `on average most on bump ${numberText(ensemble.counted(bump))}, ${words(bump)}`}`;
    },
    option,
  });
  let shown = selection.direction;
  selection.onChange(() => {
    if (shown !== selection.direction) panel.refresh();
    shown = selection.direction;
  });
  return panel.root;
}

function whisker(api: RenderApi, stroke: string): object {
  const [load, deviation] = [api.value(1), api.value(2)];
  const [x, top] = api.coord([api.value(0), load + deviation]);
  const [, foot] = api.coord([api.value(0), Math.max(0, load - deviation)]);
  const half = Math.min(4, 0.25 * at(api.size([1, 0]), 0));
  const line = (x1: number, y1: number, x2: number, y2: number): object => ({ type: 'line', shape: { x1, y1, x2, y2 }, style: { stroke, lineWidth: 1.4 } });
  return { type: 'group', children: [line(x, top, x, foot), line(x - half, top, x + half, top), line(x - half, foot, x + half, foot)] };
}
