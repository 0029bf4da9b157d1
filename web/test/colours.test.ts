import { beforeEach, describe, expect, it, vi } from 'vitest';

// Drawings are kept as they are asked for, since there is no browser.
const shown = vi.hoisted(() => {
  vi.stubGlobal('window', { matchMedia: () => ({ matches: false, addEventListener: () => undefined }), addEventListener: () => undefined });
  return { panels: [] as unknown[] };
});
vi.mock('../src/ui/dom', () => ({
  svg: (tag: string, attributes: Record<string, number | string>, ...children: string[]) => ({ tag, attributes, children }),
}));
vi.mock('../src/charts/chart', () => ({ axis: () => ({}), tooltip: () => ({}) }));
vi.mock('../src/charts/chart_panel', () => ({
  ChartPanel: class {
    constructor(contents: unknown) {
      shown.panels.push(contents);
    }
  },
}));

import { pressureMap, thicknessMap } from '../src/charts/film';
import type { GridData } from '../src/data/format';
import { fractionIn, rangeOf } from '../src/data/range';
import { States } from '../src/data/states';
import type { GridSelection } from '../src/ui/grid_selection';
import type { LegendEntry } from '../src/ui/legend';
import { look, rampColour } from '../src/ui/theme';

interface Drawn {
  tag: string;
  attributes: Record<string, number | string>;
  children: string[];
}
interface Shown {
  legend: () => LegendEntry[];
  option: (current: ReturnType<typeof look>, width: number) => { series: { data: number[][]; renderItem: (_: unknown, api: unknown) => { style: { fill: string } } }[] };
}

const base64 = (numbers: number[]): string => btoa(String.fromCharCode(...new Uint8Array(new Float32Array(numbers).buffer)));
const variable = (dims: string[], values: number[], words = ''): GridData['variables'][string] => ({ key: '', dims, unit: '', text: '', words, values: base64(values) });
const nodes = ['state', 'row', 'column'];
const pressures = [90e3, 120e3, 190e3, 100e3, 140e3, 240e3];
const thicknesses = [10e-6, 12e-6, 30e-6, 10e-6, 15e-6, 50e-6];

/** One state of a film over the whole width: two rows of three columns. */
const states = new States({
  name: 'running',
  kind: 'equilibrium',
  attributes: {},
  summary: { case: {}, version: '', commit: '', solver: 'newton', status: 'complete', states: [] } as unknown as GridData['summary'],
  quantities: [],
  left_out: [],
  dimensions: { state: 1, row: 2, column: 3 },
  variables: {
    speed: variable(['state'], [3000]),
    load_x: variable(['state'], [50]),
    load_y: variable(['state'], [0]),
    path: variable(['state'], [0], 'load_ramp'),
    h_min: variable(['state'], [10e-6]),
    z: variable(['row'], [-1e-2, 1e-2]),
    column_theta: variable(['column'], [0, 0.5, 1]),
    ambient_pressure: variable([], [101325]),
    pressure: variable(nodes, pressures),
    film_thickness: variable(nodes, thicknesses),
  },
});
const selection = { place: {}, textAt: () => '', onChange: () => undefined } as unknown as GridSelection;

/** Colours of the nodes as they are drawn, and of the bar: the shade over the place of a value. */
function coloursOf({ option, legend }: Shown): { drawn: string[]; bar: Drawn[] } {
  const [series] = option(look(), 600).series;
  const drawn = (series?.data ?? []).map((cell) => series?.renderItem(0, { value: (i: number) => cell[i], coord: (point: number[]) => point }).style.fill ?? '');
  return { drawn, bar: (legend()[0]?.draw(look()) ?? []) as unknown as Drawn[] };
}

/** In the bar, the colour over a place along it. */
function shadeAt(bar: Drawn[], x: number): string {
  return String(bar.filter(({ tag, attributes }) => tag === 'rect' && Number(attributes['x']) <= x + 1e-9).pop()?.attributes['fill']);
}

/** The largest difference of a channel. */
function apart(one: string, other: string): number {
  const channels = (colour: string): number[] => [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16));
  return Math.max(...channels(one).map((value, i) => Math.abs(value - (channels(other)[i] ?? NaN))));
}

const { ramp } = look();
/** Of one of the 48 shades of a bar: half of it to either side. */
const shade = 1 / 48;
const closest = Math.max(...Array.from({ length: 48 }, (_, i) => apart(rampColour(look(), i * shade), rampColour(look(), (i + 1) * shade))));

describe('colours', () => {
  beforeEach(() => {
    shown.panels.length = 0;
  });

  it('go from the first of the ramp at the least value to its last at the greatest', () => {
    const range = rangeOf([5, NaN, -3, 1]);
    expect(range).toEqual([-3, 5]);
    expect([-3, 1, 5].map((value) => fractionIn(range, value))).toEqual([0, 0.5, 1]);
    expect(fractionIn([2, 2], 2)).toBe(0);
    expect([0, 0.5, 1, -1, 2].map((fraction) => rampColour(look(), fraction))).toEqual([ramp[0], ramp[2], ramp[4], ramp[0], ramp[4]]);
    expect(rampColour(look(), 0.125)).toBe('#4d36a4');
  });

  it.each([
    ['pressure', () => pressureMap(states, selection), pressures, 1e-3],
    ['film thickness', () => thicknessMap(states, selection), thicknesses, 1e6],
  ])('of the %s are those that the bar shows beside them', (_, draw, values, factor) => {
    draw();
    const { drawn, bar } = coloursOf(shown.panels[0] as Shown);
    const [least, most] = [Math.min(...values), Math.max(...values)];
    expect(drawn).toHaveLength(values.length);
    values.forEach((value, i) => expect(apart(drawn[i] ?? '', rampColour(look(), (value - least) / (most - least)))).toBeLessThanOrEqual(1));
    expect([drawn[values.indexOf(least)], drawn[values.indexOf(most)]]).toEqual([ramp[0], ramp[4]]);
    // What a tick says is that of the nodes of the colour above it.
    const ticks = bar.filter(({ tag }) => tag === 'text').map(({ attributes, children }): [number, number] => [Number(attributes['x']), Number(String(children[0]).replace('−', '-')) / factor]);
    expect(ticks.length).toBeGreaterThan(2);
    for (const [x, value] of ticks) expect(apart(shadeAt(bar, x), rampColour(look(), (value - least) / (most - least)))).toBeLessThanOrEqual(closest);
  });

  it('leave a mark where the ambient pressure is', () => {
    pressureMap(states, selection);
    const { bar } = coloursOf(shown.panels[0] as Shown);
    const marks = bar.filter(({ tag }) => tag === 'path');
    expect(marks).toHaveLength(2);
    const x = Number(/^M([\d.]+)/.exec(String(marks[0]?.attributes['d']))?.[1]);
    expect(apart(shadeAt(bar, x), rampColour(look(), (101325 - 90e3) / 150e3))).toBeLessThanOrEqual(closest);
  });
});
