import { el, type Child } from './dom';
import { saveCsv, savePng, saveSvg } from './save';

export interface PanelContents {
  title: string;
  /** One sentence under the title. */
  note?: string;
  /** Beside the title. */
  controls?: Child[];
  /** Name of saved files, without its end. */
  file: () => string;
  svg?: () => string;
  csv: () => string;
}

/** A framed part of the report with a title and buttons that save what it shows. */
export function panel(contents: PanelContents, ...body: Child[]): HTMLElement {
  const save = (text: string, what: string, action: () => void): HTMLElement => {
    const button = el('button', { type: 'button', title: `Save ${what}`, 'aria-label': `${contents.title}: save ${what}` }, text);
    button.addEventListener('click', action);
    return button;
  };
  const { svg } = contents;
  const buttons = svg
    ? [
        save('SVG', 'the drawing as SVG', () => saveSvg(contents.file(), svg())),
        save('PNG', 'the drawing as PNG', () => void savePng(contents.file(), svg())),
      ]
    : [];
  buttons.push(save('CSV', 'the data as CSV', () => saveCsv(contents.file(), contents.csv())));
  return el(
    'section',
    { class: 'panel', 'aria-label': contents.title },
    el(
      'header',
      {},
      el('h3', {}, contents.title),
      ...(contents.controls ?? []),
      el('div', { class: 'save' }, ...buttons),
      ...(contents.note === undefined ? [] : [el('p', { class: 'note' }, contents.note)]),
    ),
    ...body,
  );
}

/** Named samples that say what colours, dashes and markers mean. */
export function legend(entries: { sample: Node; text: string }[]): HTMLElement {
  return el('ul', { class: 'legend' }, ...entries.map(({ sample, text }) => el('li', {}, sample, text)));
}
