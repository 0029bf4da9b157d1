import { toCsv } from '../data/csv';
import type { Ensemble, Factor } from '../data/ensemble';
import type { Quantity } from '../data/format';
import { at, capital } from '../data/run';
import { formatNumber } from '../data/units';
import { dropDown } from '../ui/dom';
import type { EnsembleSelection } from '../ui/ensemble_selection';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import { axis, tooltip, tooltipBox, type Option } from './chart';
import { ChartPanel } from './chart_panel';

/** How much a quantity depends on each of some factors: bars from -1 to 1. */
export class FactorPanel {
  readonly root: HTMLElement;
  private quantity: Quantity;

  /** @param along  what the bars are of, below them */
  constructor(
    title: string,
    private readonly factors: Factor[],
    private readonly along: string,
    private readonly ensemble: Ensemble,
    private readonly selection: EnsembleSelection,
  ) {
    const { quantities } = ensemble;
    this.quantity = quantities.find(({ name }) => name === ensemble.attribute('target_quantity')) ?? at(quantities, 0);
    const list = dropDown(
      `Quantity: ${title}`,
      quantities.map((value) => ({ value, text: capital(value.label) })),
      (quantity) => {
        this.quantity = quantity;
        panel.refresh();
      },
    );
    list.selectedIndex = quantities.indexOf(this.quantity);
    const panel = new ChartPanel({
      title,
      controls: [list],
      note: 'Partial rank correlations: 1 if the quantity always rises with the input, −1 if it always falls, 0 if it does not depend on it.',
      subject: () => `${capital(this.quantity.label)} · ${this.direction} · ${ensemble.label}${this.isKnown ? '' : ' · unknown: too few bearings for this many random inputs'}`,
      file: () => fileName('sensitivities', this.quantity.name, ensemble.label, this.direction),
      csv: () => this.csv(),
      description: () => this.description(),
      option: (current) => this.option(current),
    });
    this.root = panel.root;
    let direction = selection.direction;
    selection.onChange(() => {
      if (direction !== selection.direction) panel.refresh();
      direction = selection.direction;
    });
  }

  private get direction(): string {
    return at(this.ensemble.directions, this.selection.direction);
  }

  private get values(): number[] {
    return this.factors.map(({ correlation }) => correlation(this.quantity.name, this.selection.direction));
  }

  private get isKnown(): boolean {
    return this.values.some(Number.isFinite);
  }

  private description(): string {
    const ranked = this.factors
      .map(({ text }, i) => ({ text, value: at(this.values, i) }))
      .filter(({ value }) => Number.isFinite(value))
      .sort((a, b) => Math.abs(b.value) - Math.abs(a.value))
      .slice(0, 5);
    const most = ranked.map(({ text, value }) => `${text} ${formatNumber(value, 2)}`).join(', ');
    return `How ${this.quantity.label} depends on ${this.along.toLowerCase()}, ${this.direction}: ${most === '' ? 'not known' : `most on ${most}`}`;
  }

  private option(current: Look): Option {
    const { values } = this;
    return {
      grid: { left: 54, right: 12, top: 12, bottom: 44 },
      xAxis: axis(current, this.along, {
        type: 'category',
        data: this.factors.map(({ text }) => text),
        nameGap: 26,
        axisLabel: { color: current.muted, fontSize: 12, hideOverlap: true },
        axisLine: { onZero: false, lineStyle: { color: current.line } },
        splitLine: { show: false },
        axisTick: { show: false },
      }),
      yAxis: axis(current, 'Correlation', { nameGap: 38, min: -1, max: 1, interval: 0.5 }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        axisPointer: { type: 'shadow', shadowStyle: { color: current.grid, opacity: 0.5 } },
        formatter: (items: { dataIndex: number }[]) => this.tip(items[0]?.dataIndex ?? 0),
      }),
      series: [
        {
          type: 'bar',
          name: this.quantity.label,
          barMaxWidth: 46,
          // By its side of the axis, too, what falls is told from what grows.
          data: values.map((value) => ({ value: Number.isFinite(value) ? value : null, itemStyle: { color: value < 0 ? at(current.series, 1) : at(current.series, 0) } })),
        },
      ],
    };
  }

  private tip(index: number): HTMLElement | string {
    const factor = this.factors[index];
    if (!factor) return '';
    return tooltipBox(factor.title, [['Correlation', formatNumber(this.values[index], 3)]]);
  }

  private csv(): string {
    const { ensemble } = this;
    return toCsv(
      ['factor', ensemble.placeColumn.name, ...ensemble.quantities.map(({ name }) => name)],
      ensemble.placeColumn.cells.flatMap((place, direction) =>
        this.factors.map(({ text, correlation }) => [text, place, ...ensemble.quantities.map(({ name }) => correlation(name, direction))]),
      ),
    );
  }
}
