/** Charts of the film of one state of a running bearing. */
import { toCsv } from '../data/csv';
import { axisText, tickText } from '../data/counted';
import { numbersOf } from '../data/grid';
import { fractionIn, rangeOf, type Range } from '../data/range';
import { at, largest } from '../data/run';
import type { PadColumns, States } from '../data/states';
import { axisTitle, formatQuantity, scaleFor, type Scale } from '../data/units';
import { svg } from '../ui/dom';
import type { GridSelection } from '../ui/grid_selection';
import { fileName } from '../ui/save';
import { rampColour, type Look } from '../ui/theme';
import { axis, roundAbove, tooltip, tooltipBox, type Option, type RenderApi } from './chart';
import { ChartPanel, type ChartPanelContents } from './chart_panel';
import { colourBar, rangeText } from './colour_bar';

/** What a chart of a state has of its own. */
type Contents = Pick<ChartPanelContents, 'title' | 'note' | 'legend' | 'csv' | 'option' | 'height' | 'fills'> & { what: string; caption: () => string };

/** Follows the state that the reader looks at. */
function statePanel(states: States, selection: GridSelection, { what, caption, ...contents }: Contents): HTMLElement {
  const where = (): string => selection.textAt(selection.place);
  const panel = new ChartPanel({
    ...contents,
    subject: () => [caption(), where(), states.label].filter((text) => text !== '').join(' · '),
    file: () => fileName(what, states.label, where()),
    description: () => `${typeof contents.title === 'string' ? contents.title : contents.title()}: ${caption()}; ${where()}`,
  });
  selection.onChange(() => panel.refresh());
  return panel.root;
}

const degrees = 180 / Math.PI;
/** Between ticks of angles from a weld, degrees. */
const tick = 45;
const unknown = 'no state found';

/** From the weld of their pad. */
function columnsOf(states: States): number[] {
  return states.padColumns.flatMap(({ angles }) => angles);
}

/** Names of a pad as the first column of a table, where there are several. */
function padCells(states: States): (string | number)[][] {
  return states.padColumns.flatMap(({ name, angles }, pad) => angles.map(() => (name === '' ? [] : [pad + 1])));
}

/** All pads laid flat, one after the other, each from its weld; before the name of the next there is room for it. */
function flatAxis(current: Look, pads: PadColumns[]): object {
  const end = Math.max(...pads.map(({ begin, angles }) => begin + largest(angles)));
  if (pads.length === 1) return axis(current, 'Angle from the weld (°)', { min: 0, max: Math.ceil(end), interval: tick });
  const texts = new Map(pads.flatMap(({ name, begin, angles }) => Array.from({ length: Math.floor(largest(angles) / tick + 0.4) }, (_, i): [number, string] => [begin + i * tick, i === 0 ? name : String(i * tick)])));
  return axis(current, 'Angle from the weld of each pad (°)', {
    min: 0,
    max: Math.ceil(end),
    splitLine: { show: false },
    axisLabel: { color: current.muted, fontSize: 12, customValues: [...texts.keys()], formatter: (place: number) => texts.get(place) ?? '' },
    axisTick: { customValues: [...texts.keys()], lineStyle: { color: current.line } },
  });
}

/** "45.0° from the weld", of several pads "45.0° from the weld of pad 2" */
function whereText(angle: number, { name }: Pick<PadColumns, 'name'>): string {
  return `${angle.toFixed(1)}° from the weld${name === '' ? '' : ` of ${name}`}`;
}

/** What a map shows at every node. */
interface Field {
  name: string;
  unit: string;
  title: string;
  /** What its file is called. */
  what: string;
  caption: (range: Range) => string;
  /** A value that stands out on the scale of colours. */
  mark?: () => { value: number; text: string };
  tips: (value: number) => [string, string][];
}

/** Pressure at every node, over the unwrapped foil and its whole width. */
export function pressureMap(states: States, selection: GridSelection): HTMLElement {
  const ambient = (): number => states.variable('ambient_pressure')?.at({}) ?? NaN;
  return filmMap(states, selection, {
    name: 'pressure',
    unit: 'Pa',
    title: 'Pressure',
    what: 'pressure',
    caption: (range) => `${rangeText(range, 'Pa')}, ambient ${formatQuantity(ambient(), 'Pa')}`,
    mark: () => ({ value: ambient(), text: 'ambient' }),
    tips: (value) => [['Gauge pressure', formatQuantity(value - ambient(), 'Pa', 3)]],
  });
}

/** Film thickness at every node, where it is not the same over the width. */
export function thicknessMap(states: States, selection: GridSelection): HTMLElement[] {
  if (!states.variable('film_thickness')?.has('row')) return [];
  const caption = (range: Range): string => {
    const z = states.numberAt('h_min_z', selection.place);
    const place = Number.isFinite(z) ? `, thinnest ${formatQuantity(z, 'm', 3)} from the mid-plane` : '';
    return `${rangeText(range, 'm')}${place}`;
  };
  return [filmMap(states, selection, { name: 'film_thickness', unit: 'm', title: 'Film thickness', what: 'film-thickness-map', caption, tips: () => [] })];
}

/** What the peaks of rough surfaces press with at every node, where it is not the same over the width. */
export function asperityMap(states: States, selection: GridSelection): HTMLElement[] {
  if (!states.variable('asperity_pressure')?.has('row')) return [];
  const caption = (range: Range): string => rangeText(range, 'Pa');
  return [filmMap(states, selection, { name: 'asperity_pressure', unit: 'Pa', title: 'Pressure of asperities', what: 'asperity-pressure-map', caption, tips: () => [] })];
}

/** A field over the unwrapped foil and its whole width. */
function filmMap(states: States, selection: GridSelection, field: Field): HTMLElement {
  const across = (): number[] => numbersOf(states, 'z');
  // On half the width the film is symmetric about its mid-plane.
  const isHalf = (): boolean => across().every((z) => z >= 0);
  const read = (): number[][] => {
    const state = states.stateAt(selection.place);
    const variable = states.variable(field.name);
    const columns = [...Array(states.size('column')).keys()];
    return across().map((_, row) => columns.map((column) => (state < 0 ? NaN : (variable?.at({ state, row, column }) ?? NaN))));
  };
  const range = (): Range => rangeOf(read().flat());
  const half = (values: number[], i: number): [number, number] => {
    const value = at(values, i);
    return [i === 0 ? value : 0.5 * (value + at(values, i - 1)), i === values.length - 1 ? value : 0.5 * (value + at(values, i + 1))];
  };
  const cells = (pads: PadColumns[], z: number[], scale: Scale): number[][] => {
    const all = range();
    return read().flatMap((row, j) =>
      pads.flatMap(({ first, begin, angles }, pad) =>
        angles.flatMap((_, i) => {
          const value = at(row, first + i);
          if (!Number.isFinite(value)) return [];
          const [left, right] = half(angles, i).map((side) => begin + side) as [number, number];
          const [lower, upper] = half(z, j).map((side) => side * scale.factor) as [number, number];
          const cell = [left, right, lower, upper, fractionIn(all, value), value, pad];
          return isHalf() ? [cell, [left, right, -upper, -lower, fractionIn(all, value), value, pad]] : [cell];
        }),
      ),
    );
  };
  const option = (current: Look): Option => {
    const pads = states.padColumns;
    const z = across();
    const scale = scaleFor(largest(z), 'm');
    const drawn = cells(pads, z, scale);
    const side = largest(z) * scale.factor;
    return {
      grid: { left: 62, right: 18, top: 12, bottom: 48 },
      xAxis: { ...flatAxis(current, pads), splitLine: { show: false } },
      yAxis: axis(current, axisTitle('Across the width', scale), { nameGap: 42, min: -side, max: side, splitLine: { show: false }, axisLabel: { color: current.muted, fontSize: 12, formatter: (x: number) => String(Number(x.toPrecision(3))).replace('-', '−') } }),
      tooltip: tooltip(current, {
        trigger: 'item',
        formatter: ({ dataIndex }: { dataIndex: number }) => {
          const [left = 0, right = 0, lower = 0, upper = 0, , value, number = 0] = drawn[dataIndex] ?? [];
          const pad = at(pads, number);
          return tooltipBox(formatQuantity(value, field.unit), [
            ['Along the foil', whereText(0.5 * (left + right) - pad.begin, pad)],
            ['Across the width', formatQuantity((0.5 * (lower + upper)) / scale.factor, 'm', 3)],
            ...field.tips(value ?? NaN),
          ]);
        },
      }),
      series: [
        {
          type: 'custom',
          name: field.name,
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
    title: `${field.title} over the unwrapped ${states.pads === 1 ? 'foil' : 'pads'}`,
    what: field.what,
    caption: () => (states.isFound(selection.place) ? field.caption(range()) : unknown),
    legend: () => [
      ...(states.isFound(selection.place) ? [colourBar(range(), field.unit, field.mark?.())] : []),
    ],
    csv: () => {
      const [theta, z, pads] = [columnsOf(states), across(), padCells(states)];
      return toCsv([...(states.pads > 1 ? ['pad'] : []), 'theta_deg', 'z_m', `${field.name}_${field.unit}`], read().flatMap((row, j) => row.map((value, i) => [...at(pads, i), theta[i], z[j], value])));
    },
    option,
  });
}

/**
 * Film thickness at every column, with the sag of the top foil between the crests.
 * @param before  a state of another bearing to compare with, if there is one
 */
export function thicknessChart(states: States, selection: GridSelection, before: () => States | undefined = () => undefined): HTMLElement {
  const crests = (): number[] => numbersOf(states, 'theta').map((angle, bump) => angle * degrees + at(states.padColumns, (states.countedBump(bump).pad ?? 1) - 1).begin);
  // Over walls that yield it is not the same over the width: that of the mid-plane is drawn.
  const film = (): number[] => states.along('film_thickness', 'column', selection.place);
  const foil = (): number[] => states.along('film_top_displacement', 'column', selection.place);
  const lines = [
    { text: states.variable('film_thickness')?.has('row') ? 'film thickness in the mid-plane' : 'film thickness', values: film, colour: (current: Look) => at(current.series, 0), dash: 'solid' as const },
    { text: 'top foil, outward', values: foil, colour: (current: Look) => at(current.series, 1), dash: [6, 3] },
  ].filter(({ text }) => text !== 'top foil, outward' || states.variable('film_top_displacement') !== undefined);
  const filmBefore = (): number[] => before()?.along('film_thickness', 'column', {}) ?? [];
  const scale = (): Scale => scaleFor(largest(filmBefore(), ...lines.map(({ values }) => values())), 'm');
  /** Of each pad. */
  const pointsOf = (one: States, values: number[]): number[][][] => {
    const { factor } = scale();
    return one.padColumns.map(({ first, begin, angles }) => (values.length === 0 ? [] : angles.map((angle, i) => [begin + angle, at(values, first + i) * factor])));
  };
  /** What a point of one of the drawn lines, pad after pad of each quantity, stands for. */
  const columnAt = (series: number, index: number): [number, PadColumns] => {
    const pads = states.padColumns;
    const pad = at(pads, series % pads.length);
    return [pad.first + index, pad];
  };
  return statePanel(states, selection, {
    title: lines.length > 1 ? 'Film thickness and sag of the top foil' : 'Film thickness',
    what: 'film-thickness',
    caption: () =>
      states.isFound(selection.place)
        ? `minimum ${formatQuantity(states.numberAt('h_min', selection.place), 'm')} at ${whereText(states.numberAt('h_min_theta', selection.place), at(states.padColumns, (states.pads > 1 ? states.numberAt('h_min_pad', selection.place) : 1) - 1))}`
        : unknown,
    legend: () => [
      ...lines.map(({ text, colour, dash }) => ({
        width: 30,
        draw: (current: Look) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: colour(current), 'stroke-width': 2, 'stroke-dasharray': dash === 'solid' ? 'none' : dash.join(' ') })],
        text,
      })),
      ...(filmBefore().length > 0 ? [{ width: 30, draw: (current: Look) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: current.muted, 'stroke-width': 1.4 })], text: 'baseline film thickness' }] : []),
      ...(crests().length > 0 ? [{ width: 12, draw: (current: Look) => [svg('line', { x1: 6, y1: 1, x2: 6, y2: 11, stroke: current.muted, 'stroke-width': 1.4 })], text: 'crests' }] : []),
    ],
    csv: () => {
      const [thickness, displacement] = [film(), foil()];
      const pads = padCells(states);
      return toCsv([...(states.pads > 1 ? ['pad'] : []), 'theta_deg', 'film_thickness_m', 'film_top_displacement_m'], columnsOf(states).map((angle, i) => [...at(pads, i), angle, thickness[i], displacement[i]]));
    },
    option: (current) => ({
      grid: { left: 62, right: 18, top: 12, bottom: 48 },
      xAxis: flatAxis(current, states.padColumns),
      yAxis: axis(current, axisTitle('Film and sag', scale()), { nameGap: 42 }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        formatter: (items: { dataIndex: number; seriesIndex: number }[]) => {
          const [i, pad] = columnAt(items[0]?.seriesIndex ?? 0, items[0]?.dataIndex ?? 0);
          return tooltipBox(whereText(columnsOf(states)[i] ?? NaN, pad), lines.map(({ text, values }) => [text, formatQuantity(values()[i], 'm')]));
        },
      }),
      series: [
        ...lines.flatMap(({ text, values, colour, dash }) =>
          pointsOf(states, values()).map((data) => ({
            type: 'line',
            name: text,
            symbol: 'none',
            lineStyle: { color: colour(current), width: 1.8, type: dash },
            itemStyle: { color: colour(current) },
            data,
          })),
        ),
        ...[before()].flatMap((one) => (one ? pointsOf(one, filmBefore()).map((data) => ({ type: 'line', name: 'baseline film thickness', symbol: 'none', silent: true, z: 1, lineStyle: { color: current.muted, width: 1.4 }, itemStyle: { color: current.muted }, data })) : [])),
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

/** Loads on the bumps; detached ones have none. */
export function runningLoads(states: States, selection: GridSelection): HTMLElement {
  const loads = (): number[] => states.along('normal_force_top_bump', 'bump', selection.place);
  const scale = (): Scale => scaleFor(largest(loads()), 'N');
  const lifted = (): number => loads().filter((load) => load <= 0).length;
  const atInlet = (): string => {
    const count = states.numberAt('lifted_bumps_at_entry', selection.place);
    return count > 0 ? `, the first ${count} at the inlet` : '';
  };
  return statePanel(states, selection, {
    title: 'Bump loads',
    what: 'bump-loads',
    fills: true,
    caption: () =>
      states.isFound(selection.place)
        ? `maximum ${formatQuantity(largest(loads()), 'N')} on bump ${states.bumpText(loads().indexOf(largest(loads())))}; detached from ${lifted()} of ${loads().length} bumps${atInlet()}`
        : unknown,
    legend: () => [
      { width: 12, draw: (current) => [svg('rect', { x: 2, y: 1, width: 8, height: 11, fill: current.accent })], text: 'pressed' },
      { width: 12, draw: (current) => [svg('circle', { cx: 6, cy: 6, r: 3.2, fill: current.background, stroke: current.muted, 'stroke-width': 1.4 })], text: 'detached' },
    ],
    csv: () => toCsv(['bump', 'load_N'], loads().map((load, i) => [i + 1, load])),
    option: (current) => ({
      grid: { left: 54, right: 12, top: 12, bottom: 44 },
      xAxis: axis(current, axisText('bump', states.pads > 1), {
        type: 'category',
        data: loads().map((_, i) => tickText(states.countedBump(i))),
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
          return tooltipBox(`Bump ${states.bumpText(bump)}`, [['Load', formatQuantity(loads()[bump], 'N')]]);
        },
      }),
      series: [
        { type: 'bar', name: 'load', itemStyle: { color: current.accent }, data: loads().map((load) => load * scale().factor) },
        {
          type: 'line',
          name: 'detached',
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
