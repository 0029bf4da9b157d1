/** What the quantities are: beside each where it stands, and all of them at the end. */
import type { Quantity } from '../data/format';
import { capital, type Run } from '../data/run';
import { el } from '../ui/dom';

/** A quantity and what it is. */
export interface Entry {
  name: string;
  label: string;
  unit: string;
  text: string;
}

/** Variables that charts and drawings show under other words than their names. */
const drawn: Record<string, string> = {
  displacement: 'displacement',
  force_direct: 'direct force',
  force_cross: 'cross force',
  work: 'work',
  elastic_energy: 'elastic energy',
  dissipated_energy: 'dissipated energy',
  normal_force_journal_top: 'load on the top foil',
  normal_force_top_bump: 'bump load',
  normal_force_bump_sleeve: 'foot load',
  friction_force_top_bump: 'friction on the bump',
  friction_force_bump_sleeve: 'friction on the foot',
  stress_top_foil: 'stress, top foil over the crests',
  stress_top_foil_weld: 'stress, top foil at the weld',
  stress_bump_foil: 'stress, bump foil along the arcs',
  stress_bump_foil_weld: 'stress, bump foil at the weld',
  top_displacement: 'displacement of the top foil',
  crest_u: 'displacement of the crest, along',
  crest_v: 'displacement of the crest, outwards',
  foot_u: 'slip of the foot',
  foot_v: 'displacement of the foot, outwards',
};

/** A meaning of result.nc as a sentence. */
function sentence(meaning: string): string {
  const derivative = /\bdF_([xy])\/d(?:([xy])|\(d([xy])\/dt\))/g;
  const words = meaning.replace(derivative, (_, force: string, place?: string, velocity?: string) => `force along ${force.toUpperCase()} per ${place ? 'displacement' : 'velocity'} along ${(place ?? velocity ?? '').toUpperCase()}`);
  return `${capital(words.replaceAll('_', ' ')).replaceAll('`', '').replace(/\bpi\b/g, 'π').replaceAll('^2', '²')}.`;
}

/** Whether a meaning says more than the name. */
function tells(label: string, meaning: string): boolean {
  return meaning !== '' && sentence(meaning) !== `${capital(label)}.`;
}

function anchorOf(name: string): string {
  return `word-${name}`;
}

/** A name with its definition: under the pointer, and by a link to the glossary. */
export function term(name: string, label: string, meaning: string): HTMLElement {
  if (!tells(label, meaning)) return el('span', {}, capital(label));
  return el('a', { class: 'term', href: `#${anchorOf(name)}`, title: sentence(meaning) }, capital(label));
}

export function entryOf({ name, label, unit, meaning }: Quantity): Entry {
  return { name, label, unit, text: meaning };
}

/** Of the quantities of runs, and of what is drawn of them. */
export function entriesOf(runs: Run[]): Entry[] {
  return runs.flatMap(({ data, quantities }) => [
    ...quantities.map(entryOf),
    ...Object.entries(drawn).flatMap(([name, label]) => {
      const meaning = data.meanings[name];
      return meaning ? [{ name, label, unit: meaning.unit, text: meaning.text }] : [];
    }),
  ]);
}

/** With all variables that it is of. */
type Definition = Omit<Entry, 'name'> & { names: Set<string> };

/** Each once, in the order of their labels. */
function sorted(entries: Entry[]): Definition[] {
  const each = new Map<string, Definition>();
  for (const entry of entries) {
    // Several variables may be one quantity, as of the rotor and of its modes.
    const key = [entry.label, entry.unit, entry.text].join('\n');
    const names = each.get(key)?.names ?? new Set();
    if (tells(entry.label, entry.text)) each.set(key, { ...entry, names: names.add(entry.name) });
  }
  return [...each.values()].sort((a, b) => a.label.localeCompare(b.label));
}

/** Every quantity of the report with its definition, as the results carry it. */
export function glossary(entries: Entry[]): HTMLElement {
  const ids = new Set<string>();
  const list = sorted(entries).map(({ names, label, unit, text }) => {
    const [own, ...others] = [...names].map(anchorOf).filter((id) => !ids.has(id));
    for (const id of own === undefined ? [] : [own, ...others]) ids.add(id);
    return el(
      'div',
      own === undefined ? {} : { id: own },
      el('dt', {}, ...others.map((id) => el('span', { id })), capital(label), ...(unit === '' ? [] : [el('span', { class: 'unit' }, ` ${unit.replace('m3', 'm³').replace('degree', '°')}`)])),
      el('dd', {}, sentence(text)),
    );
  });
  return el('dl', { class: 'glossary' }, ...list);
}
