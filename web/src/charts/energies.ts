import { at, largest, type Loop } from '../data/run';
import { toCsv } from '../data/csv';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import { el, svg } from '../ui/dom';
import { legend, panel } from '../ui/panel';
import { fileName } from '../ui/save';
import type { Selection } from '../ui/selection';
import { look, onLookChange, type Look } from '../ui/theme';
import { axis, Chart, roundAbove, tooltip, tooltipBox, type Option } from './chart';
import type { Curve } from './loops';
import { PathAxis } from './path_axis';

const energies = [
  { name: 'work', text: 'work done on the foils', style: 0, marker: 'circle' },
  { name: 'elastic_energy', text: 'elastic energy gained', style: 2, marker: 'rect' },
  { name: 'dissipated_energy', text: 'dissipated by friction', style: 1, marker: 'triangle' },
] as const;

/** Dashes tell the runs apart; one run alone is drawn solid. */
const dashes: ('solid' | number[])[] = ['solid', [7, 3], [2, 2], [9, 3, 2, 3]];

/** Since the centred journal, as work and dissipation are. */
function energy(loop: Loop, name: string, index: number): number {
  const value = loop.value(name, index);
  return name === 'elastic_energy' ? value - loop.value(name, 0) : value;
}

function energiesOf(loop: Loop, name: string): number[] {
  return loop.increments.map((_, index) => energy(loop, name, index));
}

/** Increments from one marker to the next. */
function spacing(loop: Loop): number {
  return Math.max(1, Math.round(loop.size / 9));
}

/** Where the work of one direction goes, along the path; one curve per run and kind of energy. */
function energyChart(curves: Curve[], most: number, scale: Scale, path: PathAxis, selection: Selection): HTMLElement {
  const { loop } = at(curves, 0);
  const several = curves.length > 1;
  const option = (current: Look, width: number): Option => ({
    grid: { left: 56, right: 16, top: 14, bottom: 46 },
    xAxis: path.option(current, width),
    yAxis: axis(current, axisTitle('Energy', scale), { nameGap: 40, max: roundAbove(most * scale.factor) }),
    tooltip: tooltip(current, {
      trigger: 'axis',
      formatter: (items: { seriesIndex: number; dataIndex: number }[]) => {
        const first = items[0];
        if (!first) return '';
        const rows = items.map(({ seriesIndex, dataIndex }): [string, string] => {
          const curve = at(curves, Math.floor(seriesIndex / energies.length));
          const kind = at(energies, seriesIndex % energies.length);
          const name = several ? `${curve.label}: ${kind.text}` : kind.text;
          return [name, formatQuantity(energy(curve.loop, kind.name, dataIndex), 'J')];
        });
        const curve = at(curves, Math.floor(first.seriesIndex / energies.length));
        const branch = curve.loop.isLoading(first.dataIndex) ? 'loading' : 'unloading';
        const displacement = formatQuantity(curve.loop.value('displacement', first.dataIndex), 'm');
        return tooltipBox(`${curve.loop.name}, ${branch}, ${displacement}`, rows);
      },
    }),
    series: curves.flatMap((curve, i) =>
      energies.map(({ name, text, style, marker }) => ({
        type: 'line',
        name: text,
        showAllSymbol: true,
        symbol: marker,
        symbolSize: (_: unknown, item: { dataIndex: number }) =>
          item.dataIndex % spacing(curve.loop) === spacing(curve.loop) >> 1 ? 7 : 0,
        lineStyle: { color: at(current.series, style), width: 1.8, type: at(dashes, i % dashes.length) },
        itemStyle: { color: at(current.series, style) },
        data: energiesOf(curve.loop, name).map((value, index) => [
          path.position(curve.loop, index),
          value * scale.factor,
        ]),
      })),
    ),
  });
  const peak = at(energiesOf(loop, 'work'), loop.turning);
  const chart = new Chart(
    `Energies along the path, ${loop.name}: work ${formatQuantity(peak, 'J')} at full displacement`,
    () => 240,
    option,
  );
  const follow = (): void => {
    const shown = curves.find((curve) => curve.loop === selection.loop);
    chart.setCursors(shown ? [{ name: 'line', grid: 0, x: path.position(shown.loop, selection.index) }] : []);
  };
  selection.onChange(follow);
  follow();
  return panel(
    {
      title: loop.name,
      file: () => fileName('energies', loop.name),
      svg: () => chart.toSvg(),
      csv: () =>
        toCsv(
          ['run', at(curves, 0).run.kind.loops.column, 'increment', 'displacement_m', 'work_J', 'elastic_energy_J', 'dissipated_energy_J'],
          curves.flatMap((curve) =>
            curve.loop.increments.map((increment, index) => [
              curve.run.label,
              curve.loop.key,
              increment,
              curve.loop.value('displacement', index),
              ...['work', 'elastic_energy', 'dissipated_energy'].map((name) => curve.loop.value(name, index)),
            ]),
          ),
        ),
    },
    chart.root,
  );
}

/** A line as the legend shows it; of no colour (style -1) where it stands for its dash alone. */
function lineSample(style: number, dash: 'solid' | number[], marker = ''): SVGElement {
  const line = svg('line', {
    x1: 0,
    y1: 6,
    x2: 30,
    y2: 6,
    'stroke-width': 2,
    'stroke-dasharray': dash === 'solid' ? 'none' : dash.join(' '),
  });
  const shapes: Record<string, string> = {
    circle: 'M11.5 6a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0Z',
    rect: 'M11.8 2.8H18.2V9.2H11.8Z',
    triangle: 'M15 2L19 9.5H11Z',
  };
  const mark = svg('path', { d: shapes[marker] ?? '' });
  const colour = (): void => {
    const value = style < 0 ? 'currentColor' : at(look().series, style);
    line.setAttribute('stroke', value);
    mark.setAttribute('fill', value);
  };
  colour();
  onLookChange(colour);
  return svg('svg', { width: 30, height: 12, 'aria-hidden': 'true' }, line, mark);
}

/** One chart per direction, all with the same scales. */
export function energySection(groups: Curve[][], selection: Selection): HTMLElement {
  const begun = groups.map((curves) => curves.filter((curve) => curve.loop.size > 0)).filter((c) => c.length > 0);
  const loops = begun.flatMap((curves) => curves.map((curve) => curve.loop));
  const most = largest(...loops.flatMap((loop) => energies.map(({ name }) => energiesOf(loop, name))));
  const scale = scaleFor(most, 'J');
  const path = new PathAxis(loops);
  const runs = begun[0]?.length ?? 0;
  return el(
    'div',
    {},
    legend([
      ...energies.map(({ text, style, marker }) => ({ sample: lineSample(style, 'solid', marker), text })),
      ...(runs > 1
        ? at(begun, 0).map((curve, i) => ({ sample: lineSample(-1, at(dashes, i % dashes.length)), text: curve.run.label }))
        : []),
    ]),
    el('div', { class: 'multiples' }, ...begun.map((curves) => energyChart(curves, most, scale, path, selection))),
  );
}
