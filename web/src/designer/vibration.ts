/** Vibrations about a static load: stiffness and loss factor over the amplitude. */
import { ChartPanel } from '../charts/chart_panel';
import { axis, tooltip, tooltipBox, type Option } from '../charts/chart';
import { lineEntry, plainLook } from '../charts/grid_lines';
import { toCsv } from '../data/csv';
import { at, largest } from '../data/run';
import { axisTitle, formatNumber, formatQuantity, scaleFor } from '../data/units';
import { el, svg } from '../ui/dom';
import type { LegendEntry } from '../ui/legend';
import { fileName } from '../ui/save';
import type { Look } from '../ui/theme';
import type { VibrationAnswer } from './format';
import { isRefused, type Solver } from './solver';
import { isSeen } from './tabs';
import { withPoint } from './typed';

type Quantity = 'stiffness' | 'loss_factor';

const points = 8;
/** The least amplitude is this part of the largest. */
const least = 1 / 50;
/** Increments from the middle of a vibration to its end. */
const steps = 25;
const axes = ['X', 'Y'];

interface Line {
  text: string;
  axis: number;
  before: boolean;
  values: number[];
}

function input(label: string, unit: string, value: string): { root: HTMLElement; box: HTMLInputElement } {
  const box = el('input', { type: 'text', inputmode: 'decimal', class: 'number', value, 'aria-label': `${label}, ${unit}` });
  return { root: el('label', { class: 'control' }, label, box, unit), box };
}

export class VibrationView {
  readonly root: HTMLElement;
  private readonly caption = el('p', { class: 'note', role: 'status' });
  private readonly load = [input('Load along X', 'N', '0'), input('along Y', 'N', '-50')];
  private readonly reach = input('Amplitudes up to', 'µm', '20');
  private readonly panels: ChartPanel[];
  private designs: { now: string; before: string } | undefined;
  /** What the answers are to. */
  private begun = '';
  private amplitudes: number[] = [];
  private lines: Record<Quantity, Line[]> = { stiffness: [], loss_factor: [] };

  constructor(private readonly solver: Solver) {
    this.panels = [this.panel('stiffness', 'Stiffness', 'N/m'), this.panel('loss_factor', 'Loss factor', '')];
    const controls = [...this.load, this.reach];
    for (const { box } of controls) {
      box.addEventListener('change', () => {
        box.value = withPoint(box.value);
        this.refresh();
      });
    }
    this.root = el(
      'div',
      { class: 'vibration' },
      el('div', { class: 'tools', role: 'group', 'aria-label': 'Vibrations' }, ...controls.map(({ root }) => root)),
      this.caption,
      el('div', { class: 'multiples' }, ...this.panels.map(({ root }) => root)),
    );
  }

  /** @param now  text of the case, and that of the one before */
  show(now: string, before: string): void {
    this.designs = { now, before };
    this.refresh();
  }

  /** Computes what is in sight, unless it has begun. */
  refresh(): void {
    if (!isSeen(this.root) || !this.designs) return;
    const [x, y] = this.load.map(({ box }) => Number(box.value));
    const most = 1e-6 * Number(this.reach.box.value);
    if (![x, y, most].every(Number.isFinite) || !(most > 0)) {
      this.caption.textContent = 'Enter loads and amplitudes as numbers without separators; amplitudes must be positive.';
      return;
    }
    const amplitudes = Array.from({ length: points }, (_, i) => Number((most * least ** (1 - i / (points - 1))).toPrecision(4)));
    const about = { what: 'vibration', load: [x, y], amplitudes, steps };
    const wanted = JSON.stringify([this.designs, about]);
    if (wanted === this.begun) return;
    this.begun = wanted;
    void this.compute(wanted, about, this.designs);
  }

  private async compute(wanted: string, about: { what: string; amplitudes: number[] }, { now, before }: { now: string; before: string }): Promise<void> {
    const answers: VibrationAnswer[] = [];
    for (const text of now === before ? [now] : [now, before]) {
      const answer = await this.solver.ask<VibrationAnswer>({ ...about, text });
      if (this.begun !== wanted) return;
      // Another request for vibrations came first.
      if (!answer) return this.compute(wanted, about, { now, before });
      if (isRefused(answer)) {
        this.caption.textContent = answer.errors.map(({ message }) => message).join(' · ');
        return;
      }
      answers.push(answer);
    }
    this.amplitudes = about.amplitudes;
    for (const quantity of ['stiffness', 'loss_factor'] as const) {
      this.lines[quantity] = answers.flatMap(({ directions }, design) =>
        directions.map((direction, i) => ({
          text: `${at(axes, i)}${design > 0 ? ', baseline' : ''}`,
          axis: i,
          before: design > 0,
          values: direction[quantity].map((value) => value ?? NaN),
        })),
      );
    }
    const { position_m: place, status } = at(answers, 0);
    const [x, y] = place.map((one) => formatQuantity(one, 'm', 3));
    this.caption.textContent = status === 'converged' ? `Under the load the journal is at x = ${x ?? ''}, y = ${y ?? ''}.` : `The load was not reached: ${status.replaceAll('_', ' ')}.`;
    for (const panel of this.panels) panel.refresh();
    this.root.dataset['answered'] = String(Number(this.root.dataset['answered'] ?? 0) + 1);
  }

  private panel(quantity: Quantity, title: string, unit: string): ChartPanel {
    const about = (): string => `about ${this.load.map(({ box }) => box.value).join(' N, ')} N`.replaceAll('-', '−');
    return new ChartPanel({
      title,
      subject: () => `${title} over amplitude · ${about()}`,
      legend: () => this.lines[quantity].map((line) => this.entry(line)),
      file: () => fileName('vibration', quantity),
      csv: () => toCsv(['amplitude_m', ...this.lines[quantity].map(({ text }) => `${quantity}_${text.replace(', ', '_')}${unit === '' ? '' : '_N_per_m'}`)], this.amplitudes.map((amplitude, i) => [amplitude, ...this.lines[quantity].map(({ values }) => values[i])])),
      description: () => `${title} over amplitude, ${about()}: ${this.lines[quantity].map(({ text, values }) => `${text} from ${formatNumber(values[0])} to ${formatNumber(values[values.length - 1])} ${unit}`).join('; ')}`,
      option: (current) => this.option(current, quantity, title, unit),
    });
  }

  private entry({ text, axis: i, before }: Line): LegendEntry {
    if (!before) return lineEntry(plainLook(i), text);
    return { width: 30, draw: (current) => [svg('line', { x1: 0, y1: 6, x2: 30, y2: 6, stroke: current.muted, 'stroke-width': 1.4, 'stroke-dasharray': i === 0 ? 'none' : '5 3' })], text };
  }

  private option(current: Look, quantity: Quantity, title: string, unit: string): Option {
    const lines = this.lines[quantity];
    const scale = scaleFor(largest(...lines.map(({ values }) => values)), unit);
    const across = scaleFor(largest(this.amplitudes), 'm');
    const shown = (value: number): number | null => (Number.isFinite(value) ? value * scale.factor : null);
    return {
      grid: { left: 62, right: 24, top: 16, bottom: 48 },
      xAxis: axis(current, axisTitle('Amplitude', across), { type: 'log', min: 'dataMin', max: 'dataMax' }),
      yAxis: axis(current, axisTitle(title, scale), { nameGap: 44, min: 0 }),
      tooltip: tooltip(current, {
        trigger: 'axis',
        formatter: (items: { dataIndex: number }[]) => {
          const i = items[0]?.dataIndex ?? 0;
          return tooltipBox(`Amplitude ${formatQuantity(this.amplitudes[i], 'm', 3)}`, lines.map(({ text, values }) => [text, unit === '' ? formatNumber(values[i]) : formatQuantity(values[i], unit)]));
        },
      }),
      series: lines.map(({ text, axis: i, before, values }) => ({
        type: 'line',
        name: text,
        symbol: before ? 'none' : plainLook(i).marker,
        symbolSize: 7,
        z: before ? 3 : 4,
        lineStyle: before ? { color: current.muted, width: 1.4, type: i === 0 ? 'solid' : [5, 3] } : { color: plainLook(i).colour(current), width: 1.8 },
        itemStyle: { color: plainLook(i).colour(current) },
        data: values.map((value, k) => [at(this.amplitudes, k) * across.factor, shown(value)]),
      })),
    };
  }
}
