import { toCsv } from '../data/csv';
import { contactKinds, contactTexts, onsetText, type Whirls } from '../data/whirls';
import { el } from '../ui/dom';
import { Panel } from '../ui/panel';
import { fileName } from '../ui/save';
import { scroller } from '../ui/scroller';

/** Where whirl begins and ends, in the words of the terminal. */
export function onsetTable(whirls: Whirls): HTMLElement {
  const rows = [false, true].flatMap((byCoefficients) =>
    contactTexts.map((text, contacts) => {
      const texts = whirls.onsets(contacts).filter((onset) => onset.by_coefficients === byCoefficients).map(onsetText);
      return { name: `${byCoefficients ? 'By synchronous coefficients' : 'Onset of whirl'}, ${text}`, texts: texts.length > 0 ? texts : ['none between these speeds'] };
    }),
  );
  const panel = new Panel(
    {
      title: 'Onsets of whirl',
      subject: () => whirls.label,
      file: () => fileName('onsets', whirls.label),
      csv: () =>
        toCsv(
          ['speed_rad_per_s', 'whirl_ratio', 'contacts', 'by_coefficients', 'begins', 'of_foils', 'jumps'],
          contactKinds.flatMap((_, contacts) =>
            whirls.onsets(contacts).map((onset) => [onset.speed_rad_per_s, onset.whirl_ratio, onset.contacts, onset.by_coefficients, onset.begins, onset.of_foils, onset.jumps]),
          ),
        ),
    },
    scroller(
      'Table of onsets',
      el('table', {}, el('tbody', {}, ...rows.map(({ name, texts }) => el('tr', {}, el('th', { scope: 'row' }, name), el('td', {}, ...texts.map((text) => el('div', {}, text))))))),
    ),
  );
  return panel.root;
}
