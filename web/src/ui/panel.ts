import { el, type Child } from './dom';
import { legend, type LegendEntry } from './legend';
import { pictureOf } from './picture';
import { roving } from './roving';
import { saveCanvas, saveCsv, savePng, saveSvg } from './save';
import { look, onLookChange } from './theme';

export interface PanelContents {
  title: string | (() => string);
  /** One sentence at the foot. */
  note?: string;
  /** Beside the title. */
  controls?: Child[];
  /** What of it is shown: run, direction, interface, ... */
  subject?: () => string;
  legend?: () => LegendEntry[];
  /** Name of saved files, without its end. */
  file: () => string;
  drawing?: () => SVGSVGElement | null;
  /** In place of a drawing: what is painted. */
  canvas?: () => HTMLCanvasElement;
  csv: () => string;
}

/** A framed part of the report with a title, what it is of, and buttons that save what it shows. */
export class Panel {
  readonly root: HTMLElement;
  private readonly heading = el('h3');
  private readonly subject = el('p', { class: 'note subject' });
  private readonly legend = el('div', { class: 'key-to-colours' });

  constructor(
    private readonly contents: PanelContents,
    ...body: Child[]
  ) {
    const { note, controls = [], drawing, canvas } = contents;
    const buttons = drawing
      ? [
          this.button('SVG', 'the drawing as SVG', () => this.save(saveSvg)),
          this.button('PNG', 'the drawing as PNG', () => this.save(savePng)),
        ]
      : [];
    if (canvas) buttons.push(this.button('PNG', 'the drawing as PNG', () => saveCanvas(contents.file(), canvas())));
    buttons.push(this.button('CSV', 'the data as CSV', () => saveCsv(contents.file(), contents.csv())));
    this.root = el(
      'section',
      { class: 'panel' },
      el(
        'header',
        {},
        this.heading,
        ...controls,
        roving(el('div', { class: 'save', role: 'group', 'aria-label': `Save: ${this.title}` }, ...buttons)),
        ...(contents.subject ? [this.subject] : []),
      ),
      ...body,
      ...(contents.legend ? [this.legend] : []),
      ...(note === undefined ? [] : [el('p', { class: 'note hint' }, note)]),
    );
    onLookChange(() => this.drawLegend());
    this.refresh();
  }

  /** To be called when what is shown has changed. */
  refresh(): void {
    this.heading.textContent = this.title;
    this.root.setAttribute('aria-label', this.title);
    this.subject.textContent = this.contents.subject?.() ?? '';
    this.drawLegend();
  }

  private get title(): string {
    const { title } = this.contents;
    return typeof title === 'string' ? title : title();
  }

  private drawLegend(): void {
    const entries = this.contents.legend?.() ?? [];
    this.legend.replaceChildren(...(entries.length > 0 ? [legend(entries, look())] : []));
  }

  private button(text: string, what: string, action: () => void): HTMLElement {
    const button = el('button', { type: 'button', title: `Save ${what}`, 'aria-label': `${this.title}: save ${what}` }, text);
    button.addEventListener('click', action);
    return button;
  }

  private save(write: (name: string, markup: string) => unknown): void {
    const drawing = this.contents.drawing?.();
    if (!drawing) return;
    const subject = this.contents.subject?.() ?? '';
    write(this.contents.file(), pictureOf({ title: this.title, subject, drawing, legend: this.contents.legend?.() ?? [] }, look()));
  }
}
