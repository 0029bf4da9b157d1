/** What the colours of a map stand for. */
import { fractionIn, type Range } from '../data/range';
import { formatNumber, scaleFor } from '../data/units';
import { svg } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { fontFamily, rampColour, type Look } from '../ui/theme';
import { roundTicks, tickText } from './ticks';

const [width, side, bar, height] = [264, 14, 10, 26];
const shades = 48;

/** @param mark  a value between the ends with a name of its own, SI: the ambient pressure */
export function colourBar(range: Range, unit: string, mark?: { value: number; text: string }): LegendEntry {
  const [least, most] = range;
  const { factor, unit: shown } = scaleFor(Math.max(Math.abs(least), Math.abs(most)), unit);
  const x = (value: number): number => side + (width - 2 * side) * fractionIn(range, value);
  const draw = (current: Look): SVGElement[] => {
    const part = (width - 2 * side) / shades;
    const words = { 'font-size': 10, 'font-family': fontFamily, fill: current.muted, 'text-anchor': 'middle' };
    const ticks = most > least ? roundTicks(least * factor, most * factor) : [least * factor];
    return [
      ...Array.from({ length: shades }, (_, i) => svg('rect', { x: side + i * part, y: 1, width: part + 0.6, height: bar, fill: rampColour(current, i / (shades - 1)) })),
      ...ticks.flatMap((tick) => [
        svg('line', { x1: x(tick / factor), y1: bar, x2: x(tick / factor), y2: bar + 4, stroke: current.muted }),
        svg('text', { x: x(tick / factor), y: height - 2, ...words }, tickText(tick)),
      ]),
      ...(mark && mark.value >= least && mark.value <= most ? [svg('path', { d: `M${x(mark.value)} 0V${bar + 4}`, stroke: current.background, 'stroke-width': 4 }), svg('path', { d: `M${x(mark.value)} 0V${bar + 4}`, stroke: current.text, 'stroke-width': 1.8 })] : []),
    ];
  };
  const named = mark ? `, ${mark.text} ${formatNumber(mark.value * factor)}` : '';
  return { width, height, draw, text: `${shown}${named}`.replace(/^, /, '') };
}

/** A range of one unit: "97.4 to 113.6 kPa" */
export function rangeText([least, most]: Range, unit: string): string {
  const { factor, unit: shown } = scaleFor(Math.max(Math.abs(least), Math.abs(most)), unit);
  return `${formatNumber(least * factor)} to ${formatNumber(most * factor)} ${shown}`.trimEnd();
}
