import { BarChart, CustomChart, LineChart } from 'echarts/charts';
import { GridComponent, TitleComponent, TooltipComponent } from 'echarts/components';
import * as echarts from 'echarts/core';
import { SVGRenderer } from 'echarts/renderers';
import type { EChartsType } from 'echarts/core';
import { el } from '../ui/dom';
import { fontFamily, isPrinting, look, onLookChange, type Look } from '../ui/theme';
import { tickText } from './ticks';

echarts.use([BarChart, CustomChart, LineChart, GridComponent, TitleComponent, TooltipComponent, SVGRenderer]);

export type Option = Record<string, unknown>;
export type Point = [number, number];

/** What custom series are drawn with. */
export interface RenderApi {
  coord(point: [number, number]): [number, number];
  size(point: [number, number]): [number, number];
  value(dimension: number): number;
}

interface Series {
  renderItem?: (...given: unknown[]) => object | undefined;
}

/** What is under the pointer stays where it is: lifted above the rest, a picture would hide the lines on it, and a click whose
 * element moves between press and release is lost. */
function unlifted(series: Series): Series {
  const { renderItem } = series;
  if (!renderItem) return { emphasis: { disabled: true }, ...series } as Series;
  return {
    ...series,
    renderItem: (...given) => {
      const element = renderItem(...given);
      return element && { ...element, emphasisDisabled: true };
    },
  };
}

/** Charts that wait for their first drawing: one at a time, so that the page is there before the last of them. */
const waiting: Chart[] = [];

function drawNext(): void {
  waiting.shift()?.fit();
  if (waiting.length > 0) setTimeout(drawNext);
  else document.documentElement.dataset['drawn'] = 'true';
}

/**
 * A chart that follows the width of its place and the colours of the page, with a cursor that costs no redrawing. What has
 * changed is drawn once it is in sight, on paper or saved.
 */
export class Chart {
  readonly root: HTMLElement;
  private readonly place = el('div', { class: 'plot' });
  private readonly cursors: HTMLElement[] = [];
  private instance: EChartsType | undefined;
  private moveCursor: () => void = () => {};
  private seen = true;

  /**
   * @param label what the chart shows, for those who cannot see it
   * @param build its contents for the colours and the width at hand
   */
  constructor(
    private readonly label: () => string,
    private readonly height: (width: number) => number,
    private readonly build: (look: Look, width: number) => Option,
    private readonly ready: (instance: EChartsType) => void = () => {},
  ) {
    this.root = el('div', { class: 'chart', role: 'img', 'aria-label': label() }, this.place);
    new ResizeObserver(() => this.fitted()).observe(this.root);
    const sight = new IntersectionObserver((entries) => {
      this.seen = entries[entries.length - 1]?.isIntersecting ?? true;
      if (this.seen && this.old) this.draw();
    });
    sight.observe(this.root);
    onLookChange(() => this.fit());
  }

  /** Takes its room at once, and is drawn in its turn. */
  private fitted(): void {
    if (this.instance) {
      this.draw();
    } else if (!waiting.includes(this)) {
      this.place.style.height = `${this.height(this.root.clientWidth)}px`;
      waiting.push(this);
      if (waiting.length === 1) requestAnimationFrame(() => setTimeout(drawNext));
    }
  }

  /** Whether what is drawn is of before. */
  private get old(): boolean {
    return this.root.hasAttribute('aria-busy');
  }

  private set old(old: boolean) {
    if (old) this.root.setAttribute('aria-busy', 'true');
    else this.root.removeAttribute('aria-busy');
  }

  /** To be called when what is shown has changed. */
  fit(): void {
    this.root.setAttribute('aria-label', this.label());
    this.old = this.instance !== undefined && !this.seen && !isPrinting();
    if (!this.old) this.draw();
  }

  /** Draws anew, in the size and the colours of now. */
  private draw(): void {
    const width = this.root.clientWidth;
    if (width === 0) return;
    this.old = false;
    const height = this.height(width);
    this.place.style.height = `${height}px`;
    if (!this.instance) {
      this.instance = echarts.init(this.place, null, { renderer: 'svg', width, height });
      this.ready(this.instance);
    }
    // First: paper takes what the option draws at once, and would not wait for the frame in which a new size is drawn.
    if (this.instance.getWidth() !== width || this.instance.getHeight() !== height) this.instance.resize({ width, height });
    const current = look();
    const { series = [], ...rest } = this.build(current, width) as { series?: Series[] };
    this.instance.setOption(
      {
        animation: false,
        backgroundColor: current.background,
        textStyle: { fontFamily, color: current.text },
        ...rest,
        series: series.map(unlifted),
      },
      { notMerge: true },
    );
    this.moveCursor();
  }

  /** Changes parts of the option that is there; what is there out of sight may be of runs that are gone. */
  update(option: Option): void {
    if (this.seen && !this.old) this.instance?.setOption(option);
    else this.old = true;
  }

  /** Puts marks (elements of class `cursor`) where `position` says, now and whenever the chart changes its size. */
  setCursors(marks: { name: string; grid: number; x: number; y?: number }[]): void {
    this.moveCursor = () => {
      while (this.cursors.length < marks.length) {
        const cursor = el('div', { class: 'cursor', 'aria-hidden': 'true' });
        this.cursors.push(cursor);
        this.root.append(cursor);
      }
      this.cursors.forEach((cursor, i) => {
        const mark = marks[i];
        const pixel = mark && this.instance ? this.pixel(mark.grid, mark.x, mark.y ?? 0) : undefined;
        cursor.hidden = !mark || !pixel || !pixel.every(Number.isFinite);
        if (!mark || !pixel) return;
        cursor.className = `cursor ${mark.name}`;
        const area = this.area(mark.grid);
        cursor.style.left = `${pixel[0]}px`;
        cursor.style.top = `${mark.y === undefined ? area.top : pixel[1]}px`;
        cursor.style.height = mark.y === undefined ? `${area.height}px` : '';
      });
    };
    this.moveCursor();
  }

  /** Place of a point of the diagram on the chart, px. */
  pixel(grid: number, x: number, y: number): Point {
    return (this.instance?.convertToPixel({ gridIndex: grid }, [x, y]) ?? [NaN, NaN]) as Point;
  }

  get drawing(): SVGSVGElement | null {
    if (this.old) this.draw();
    return this.place.querySelector('svg');
  }

  private area(grid: number): { top: number; height: number } {
    type Internal = { getModel(): { getComponent(name: string, index: number): { coordinateSystem: Area } } };
    type Area = { getRect(): { y: number; height: number } };
    const rect = (this.instance as unknown as Internal).getModel().getComponent('grid', grid).coordinateSystem.getRect();
    return { top: rect.y, height: rect.height };
  }
}

/** An axis of numbers in the style of the report. */
export function axis(current: Look, name: string, more: object = {}): object {
  return {
    type: 'value',
    name,
    nameLocation: 'middle',
    nameGap: 30,
    nameTextStyle: { color: current.muted, fontSize: 12 },
    axisLine: { show: true, lineStyle: { color: current.line } },
    axisTick: { show: true, lineStyle: { color: current.line } },
    axisLabel: { color: current.muted, fontSize: 12, formatter: tickText, hideOverlap: true },
    splitLine: { lineStyle: { color: current.grid } },
    ...more,
  };
}

/** A round number just above, for the end of an axis. */
export function roundAbove(number: number): number {
  if (!(number > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(number));
  return ([1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((digit) => digit * power >= number) ?? 10) * power;
}

/** Box that shows values under the pointer; texts in it are text nodes. */
export function tooltip(current: Look, more: object): object {
  return {
    confine: true,
    backgroundColor: current.background,
    borderColor: current.line,
    padding: [8, 10],
    textStyle: { color: current.text, fontSize: 12, fontFamily },
    ...more,
  };
}

/** Contents of such a box: a heading and pairs of names and values. */
export function tooltipBox(heading: string, rows: [string, string][]): HTMLElement {
  return el(
    'div',
    { class: 'tip' },
    el('strong', {}, heading),
    el('dl', {}, ...rows.flatMap(([name, value]) => [el('dt', {}, name), el('dd', {}, value)])),
  );
}
