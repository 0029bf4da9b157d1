/** Charts of the film of one state of a running bearing. */
import { toCsv } from '../data/csv';
import { numbersOf } from '../data/grid';
import { at, largest } from '../data/run';
import type { States } from '../data/states';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import { svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import { fileName } from '../ui/save';
import { rampColour, type Look } from '../ui/theme';
import { axis, roundAbove, tooltip, tooltipBox, type Option, type RenderApi } from './chart';
import { ChartPanel, type ChartPanelContents } from './chart_panel';

/** What a chart of a state has of its own. */
type Contents = Pick<ChartPanelContents, 'title' | 'note' | 'legend' | 'csv' | 'option' | 'height'> & { what: string; told: () => string };

/** Follows the state that the reader looks at. */
function statePanel(states: States, selection: GridSelection, { what, told, ...contents }: Contents): HTMLElement {
  const where = (): string => selection.textAt(selection.place);
  const panel = new ChartPanel({
    ...contents,
    subject: () => [told(), where(), states.label].filter((text) => text !== '').join(' · '),
    file: () => fileName(what, states.label, where()),
    description: () => `${typeof contents.title === 'string' ? contents.title : contents.title()}: ${told()}; ${where()}`,
  });
  selection.onChange(() => panel.refresh());
  return panel.root;
}

const degrees = 180 / Math.PI;
const unknown = 'not known: no state was found';

function columnsOf(states: States): number[] {
  return numbersOf(states, 'column_theta').map((theta) => theta * degrees);
}

/** Of the pressure, in which the map has parts of as many colours. */
const shades = 24;

/** Pressure at every node, over the unwrapped foil and its whole width. */
export function pressureMap(states: States, selection: GridSelection): HTMLElement {
  const across = (): number[] => numbersOf(states, 'z');
  const ambient = (): number => states.variable('ambient_pressure')?.at({}) ?? NaN;
  const read = (): number[][] => {
    const state = states.stateAt(selection.place);
    const pressure = states.variable('pressure');
    const columns = [...Array(states.size('column')).keys()];
    return across().map((_, row) => columns.map((column) => (state < 0 ? NaN : (pressure?.at({ state, row, column }) ?? NaN))));
  };
  const range = (): [number, number] => {
    const all = read().flat().filter(Number.isFinite);
    return [Math.min(...all), Math.max(...all)];
  };
  const half = (values: number[], i: number): [number, number] => {
    const value = at(values, i);
    return [i === 0 ? value : 0.5 * (value + at(values, i - 1)), i === values.length - 1 ? value : 0.5 * (value + at(values, i + 1))];
  };
  const cells = (theta: number[], z: number[], scale: Scale): number[][] => {
    const [least, most] = range();
    return read().flatMap((row, j) =>
      row.flatMap((value, i) => {
        if (!Number.isFinite(value)) return [];
        const fraction = most > least ? (value - least) / (most - least) : 0;
        const [left, right] = half(theta, i);
        const [lower, upper] = half(z, j).map((side) => side * scale.factor) as [number, number];
        // The film is symmetric about its mid-plane.
        return [[left, right, lower, upper, fraction, value], [left, right, -upper, -lower, fraction, value]];
      }),
    );
  };
  const option = (current: Look): Option => {
    const theta = columnsOf(states);
    const z = across();
    const scale = scaleFor(largest(z), 'm');
    const drawn = cells(theta, z, scale);
    const side = largest(z) * scale.factor;
    return {
      grid: { left: 62, right: 18, top: 12, bottom: 48 },
      xAxis: axis(current, 'Angle from the weld (°)', { min: 0, max: Math.ceil(largest(theta)), interval: 45, splitLine: { show: false } }),
      yAxis: axis(current, axisTitle('Across the width', scale), { nameGap: 42, min: -side, max: side, splitLine: { show: false }, axisLabel: { color: current.muted, fontSize: 12, formatter: (x: number) => String(Number(x.toPrecision(3))).replace('-', '−') } }),
      tooltip: tooltip(current, {
        trigger: 'item',
        formatter: ({ dataIndex }: { dataIndex: number }) => {
          const [left = 0, right = 0, lower = 0, upper = 0, , value] = drawn[dataIndex] ?? [];
          return tooltipBox(formatQuantity(value, 'Pa'), [
            ['Angle from the weld', `${(0.5 * (left + right)).toFixed(1)}°`],
            ['Across the width', formatQuantity((0.5 * (lower + upper)) / scale.factor, 'm', 3)],
            ['Beyond ambient', formatQuantity((value ?? NaN) - ambient(), 'Pa', 3)],
          ]);
        },
      }),
      series: [
        {
          type: 'custom',
          name: 'pressure',
          clip: true,
          // All at once: prints and pictures do not wait for the rest.
          progressive: 0,
          encode: { x: [0, 1], y: [2, 3] },
          data: drawn,
          renderItem: (_: unknown, api: RenderApi) => {
            const [x, y] = api.coord([api.value(0), api.value(3)]);
            const [right, foot] = api.coord([api.value(1), api.value(2)]);
            return { type: 'rect', shape: { x, y, width: right - x + 0.5, height: foot - y + 0.5 }, style: { fill: rampColour(current, api.value(4)) } };
          },
        },
      ],
    };
  };
  return statePanel(states, selection, {
    title: 'Pressure over the unwrapped foil',
    what: 'pressure',
    told: () => (states.isFound(selection.place) ? `${range().map((value) => formatQuantity(value, 'Pa')).join(' to ')}, ambient ${formatQuantity(ambient(), 'Pa')}` : unknown),
    legend: () => [
      {
        width: 5 * shades,
        draw: (current) => Array.from({ length: shades }, (_, i) => svg('rect', { x: 5 * i, y: 1, width: 5.5, height: 10, fill: rampColour(current, i / (shades - 1)) })),
        text: states.isFound(selection.place) ? range().map((value) => formatQuantity(value, 'Pa')).join(' to ') : 'pressure',
      },
    ],
    csv: () => {
      const [theta, z] = [columnsOf(states), across()];
      return toCsv(['theta_deg', 'z_m', 'pressure_Pa'], read().flatMap((row, j) => row.map((value, i) => [theta[i], z[j], value])));
    },
    option,
  });
}

/**
 * Film thickness at every column, with the sag of the top foil between the crests.
 * @param before  a state of another bearing to compare with, if there is one
 */
export function thicknessChart(states: States, selection: GridSelection, before: () => States | undefined = () => undefined): HTMLElement {
  const crests = (): number[] => numbersOf(states, 'theta').map((angle) => angle * degrees);
  // Over walls that yield it is not the same over the width: that of the mid-plane is drawn.
  const film = (): number[] => states.along('film_thickness', 'column', selection.place);
  const foil = (): number[] => states.along('film_top_displacement', 'column', selection.place);
  const lines = [
    { text: states.variable('film_thickness')?.has('row') ? 'film thickness in the mid-plane' : 'film thickness', values: film, colour: (current: Look) => at(current.series, 0), dash: 'solid' as const },
    { text: 'top foil, outward', values: foil, colour: (current: Look) => at(current.series, 1), dash: [6, 3] },
  ].filter(({ text }) => text !== 'top foil, outward' || states.variable('film_top_displacement') !== undefined);
  const filmBefore = (): number[] => before()?.along('film_thickness', 'column', {}) ?? [];
  const scale = (): Scale => scaleFor(largest(filmBefore(), ...lines.map(({ values }) => values())), 'm');
  const pointsOf = (one: States, values: number[]): number[][] => {
    const [theta, { factor }] = [columnsOf(one), scale()];
    return values.map((value, i) => [at(theta, i), value * factor]);
  };
  return statePanel(states, selection, {
    title: lines.length > 1 ? 'Film thickness and sag of the top foil' : 'Film thickness',
    what: 'film-thickness',
    told: () =>
      states.isFound(selection.place)
        ? `least ${formatQuantity(states.numberAt('h_min', selection.place), 'm')} at ${states.numberAt('h_min_theta', selection.place).toFixed(1)}° from the weld`
        : unknown,
    legend: () => [
      ...lines.map(({ text, colour, dash }) => ({
        width: 30,
        draw: (current: Look) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: colour(current), 'stroke-width': 2, 'stroke-dasharray': dash === 'solid' ? 'none' : dash.join(' ') })],
        text,
      })),
      ...(filmBefore().length > 0 ? [{ width: 30, draw: (current: Look) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: current.muted, 'stroke-width': 1.4 })], text: 'film thickness before' }] : []),
      ...(crests().length > 0 ? [{ width: 12, draw: (current: Look) => [svg('line', { x1: 6, y1: 1, x2: 6, y2: 11, stroke: current.muted, 'stroke-width': 1.4 })], text: 'crests' }] : []),
    ],
    csv: () => {
      const [thickness, displacement] = [film(), foil()];
      return toCsv(['theta_deg', 'film_thickness_m', 'film_top_displacement_m'], columnsOf(states).map((angle, i) => [angle, thickness[i], displacement[i]]));
    },
    option: (current) => ({
      grid: { left: 62, right: 18, top: 12, bottom: 48 },
      xAxis: axis(current, 'Angle from the weld (°)', { min: 0, max: Math.ceil(largest(columnsOf(states))), interval: 45 }),
      yAxis: axis(current, axisTitle('Thickness, displacement', scale()), { nameGap: 42 }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        formatter: (items: { dataIndex: number }[]) => {
          const i = items[0]?.dataIndex ?? 0;
          return tooltipBox(`${(columnsOf(states)[i] ?? NaN).toFixed(1)}° from the weld`, lines.map(({ text, values }) => [text, formatQuantity(values()[i], 'm')]));
        },
      }),
      series: [
        ...lines.map(({ text, values, colour, dash }) => ({
          type: 'line',
          name: text,
          symbol: 'none',
          lineStyle: { color: colour(current), width: 1.8, type: dash },
          itemStyle: { color: colour(current) },
          data: pointsOf(states, values()),
        })),
        ...[before()].flatMap((one) => (one ? [{ type: 'line', name: 'film thickness before', symbol: 'none', silent: true, z: 1, lineStyle: { color: current.muted, width: 1.4 }, itemStyle: { color: current.muted }, data: pointsOf(one, filmBefore()) }] : [])),
        {
          type: 'custom',
          name: 'crests',
          silent: true,
          tooltip: { show: false },
          data: crests().map((angle) => [angle, 0]),
          renderItem: ({ coordSys: { y, height } }: { coordSys: { y: number; height: number } }, api: RenderApi) => {
            const [x] = api.coord([api.value(0), 0]);
            return { type: 'line', shape: { x1: x, y1: y + height - 7, x2: x, y2: y + height }, style: { stroke: current.muted, lineWidth: 1.4 } };
          },
        },
      ],
    }),
  });
}

/** Loads on the bumps; those that the foil is lifted off have none. */
export function runningLoads(states: States, selection: GridSelection): HTMLElement {
  const loads = (): number[] => states.along('normal_force_top_bump', 'bump', selection.place);
  const scale = (): Scale => scaleFor(largest(loads()), 'N');
  const lifted = (): number => loads().filter((load) => load <= 0).length;
  return statePanel(states, selection, {
    title: 'Bump loads',
    what: 'bump-loads',
    told: () =>
      states.isFound(selection.place)
        ? `at most ${formatQuantity(largest(loads()), 'N')} on bump ${loads().indexOf(largest(loads())) + 1}; the foil is lifted off ${lifted()} of ${loads().length}, off ${states.numberAt('lifted_bumps_at_entry', selection.place)} in a row where gas enters`
        : unknown,
    legend: () => [
      { width: 12, draw: (current) => [svg('rect', { x: 2, y: 1, width: 8, height: 11, fill: current.accent })], text: 'pressed' },
      { width: 12, draw: (current) => [svg('circle', { cx: 6, cy: 6, r: 3.2, fill: current.background, stroke: current.muted, 'stroke-width': 1.4 })], text: 'lifted off' },
    ],
    csv: () => toCsv(['bump', 'load_N'], loads().map((load, i) => [i + 1, load])),
    option: (current) => ({
      grid: { left: 54, right: 12, top: 12, bottom: 44 },
      xAxis: axis(current, 'Bump, counted from the weld', {
        type: 'category',
        data: loads().map((_, i) => String(i + 1)),
        nameGap: 26,
        axisLabel: { color: current.muted, fontSize: 12 },
        splitLine: { show: false },
        axisTick: { show: false },
      }),
      yAxis: axis(current, axisTitle('Load', scale()), { nameGap: 38, min: 0, max: roundAbove(largest(loads()) * scale().factor) }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        axisPointer: { type: 'shadow', shadowStyle: { color: current.grid, opacity: 0.5 } },
        formatter: (items: { dataIndex: number }[]) => {
          const bump = items[0]?.dataIndex ?? 0;
          return tooltipBox(`Bump ${bump + 1}`, [['Load', formatQuantity(loads()[bump], 'N')]]);
        },
      }),
      series: [
        { type: 'bar', name: 'load', itemStyle: { color: current.accent }, data: loads().map((load) => load * scale().factor) },
        {
          type: 'line',
          name: 'lifted off',
          silent: true,
          symbol: 'circle',
          symbolSize: 7,
          showAllSymbol: true,
          lineStyle: { width: 0, opacity: 0 },
          itemStyle: { color: current.background, borderColor: current.muted, borderWidth: 1.4 },
          data: loads().map((load) => (load <= 0 ? 0 : null)),
        },
      ],
    }),
  });
}
