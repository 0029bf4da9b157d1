import type { EChartsType } from 'echarts/core';
import { Panel, type PanelContents } from '../ui/panel';
import { isPrinting, type Look } from '../ui/theme';
import { Chart, type Option } from './chart';

export interface ChartPanelContents extends Omit<PanelContents, 'drawing'> {
  /** What the chart shows, for those who cannot see it. */
  description: () => string;
  /** Of the width; of the usual shape without it. */
  height?: (width: number) => number;
  /** Taller where the panels beside it are, so that none of its room is empty. */
  fills?: true;
  option: (current: Look, width: number) => Option;
  ready?: (chart: Chart, instance: EChartsType) => void;
}

function usualHeight(width: number): number {
  return isPrinting() ? 230 : Math.max(210, Math.min(0.55 * width, 320));
}

/** A panel with one chart in it. */
export class ChartPanel {
  readonly root: HTMLElement;
  readonly chart: Chart;
  private readonly panel: Panel;

  constructor(contents: ChartPanelContents) {
    const { description, height = usualHeight, fills, option, ready } = contents;
    const filling = (width: number): number => {
      const { root } = this.chart;
      root.style.minHeight = `${height(width)}px`;
      return root.clientHeight;
    };
    this.chart = new Chart(description, fills ? filling : height, option, (instance) => ready?.(this.chart, instance));
    this.panel = new Panel({ ...contents, drawing: () => this.chart.drawing }, this.chart.root);
    this.root = this.panel.root;
    this.root.classList.toggle('fills', fills === true);
  }

  /** To be called when what is shown has changed. */
  refresh(): void {
    this.panel.refresh();
    this.chart.fit();
  }
}
