/** Drawings as files of their own: with title, what they are of, and the meaning of their colours. */
import { svg } from './dom';
import { sampleOf, type LegendEntry } from './legend';
import { wrapped } from './lines';
import { fontFamily, type Look } from './theme';

export interface PictureContents {
  title: string;
  /** Run, direction, interface and the like. */
  subject: string;
  drawing: SVGSVGElement;
  legend: LegendEntry[];
}

const margin = 14;
const leading = 17;

function widthOf(text: string, size: number): number {
  const context = document.createElement('canvas').getContext('2d');
  if (!context) return 0.55 * size * text.length;
  context.font = `${size}px ${fontFamily}`;
  return context.measureText(text).width;
}

function sizeOf(drawing: SVGSVGElement): { width: number; height: number } {
  const box = drawing.viewBox.baseVal;
  return { width: box?.width || drawing.clientWidth, height: box?.height || drawing.clientHeight };
}

function legendRows(entries: LegendEntry[], top: number, room: number, current: Look): { rows: SVGElement[]; bottom: number } {
  const rows: SVGElement[] = [];
  let x = 0;
  let y = top;
  let row = leading;
  for (const entry of entries) {
    const width = entry.width + 7 + widthOf(entry.text, 12);
    if (x > 0 && x + width > room) [x, y, row] = [0, y + row, leading];
    row = Math.max(row, (entry.height ?? 12) + leading - 12);
    const sample = sampleOf(entry, current);
    sample.setAttribute('x', String(margin + x));
    sample.setAttribute('y', String(y));
    const words = { x: margin + x + entry.width + 7, y: y + 10, fill: current.text, 'font-size': 12, 'font-family': fontFamily };
    rows.push(sample, svg('text', words, entry.text));
    x += width + 20;
  }
  return { rows, bottom: entries.length > 0 ? y + row : top };
}

export function pictureOf({ title, subject, drawing, legend }: PictureContents, current: Look): string {
  const size = sizeOf(drawing);
  const width = Math.max(size.width, 360) + 2 * margin;
  const room = width - 2 * margin;
  const texts: SVGElement[] = [];
  let y = margin + 14;
  const write = (text: string, font: number, more: Record<string, string | number>): void => {
    for (const line of wrapped(text, room, (words) => widthOf(words, font))) {
      texts.push(svg('text', { x: margin, y, 'font-size': font, 'font-family': fontFamily, ...more }, line));
      y += leading;
    }
  };
  write(title, 15, { fill: current.text, 'font-weight': 'bold' });
  if (subject !== '') write(subject, 12, { fill: current.muted });
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const top = y - 8;
  for (const [name, value] of Object.entries({ x: margin + (room - size.width) / 2, y: top, ...size })) copy.setAttribute(name, String(value));
  copy.removeAttribute('style');
  copy.removeAttribute('tabindex');
  const { rows, bottom } = legendRows(legend, top + size.height + 8, room, current);
  const height = bottom + margin - 4;
  const frame = svg(
    'svg',
    { width, height, viewBox: `0 0 ${width} ${height}` },
    svg('title', {}, `${title}. ${subject}`),
    svg('rect', { width, height, fill: current.background }),
    ...texts,
    copy,
    ...rows,
  );
  frame.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return new XMLSerializer().serializeToString(frame);
}
