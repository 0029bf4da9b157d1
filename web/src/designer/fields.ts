/** A field for every key of the case that the page answers to, made from the solver's own description of the keys. */
import type { CaseValue } from '../data/format';
import { el } from '../ui/dom';
import { bumpTable } from './bump_table';
import type { Design } from './design';
import type { CaseKey, InputError, Units } from './format';
import { converted, readQuantity, sizeOf, writeQuantity, type Quantity } from './quantity';
import { groups, pairs, ranges, without, type Group } from './ranges';
import { inList, withCount, withValue } from './toml';
import { listOf, valueOf, withPoint } from './typed';

/** What a field needs to know of the page. */
export interface Place {
  design: Design;
  units: Units;
  /** The value as understood, in SI, of the last valid case. */
  understood: (path: string) => CaseValue | undefined;
}

interface Field {
  path: string;
  root: HTMLElement;
  /** By which it is found: key, title, unit. */
  words: string;
  refresh: (errors: InputError[]) => void;
}

/** Steps of a slider between its ends. */
const fineSteps = 400;

/** The path that the key of a table of a list has in the first one: all have the same. */
function ofFirst(path: string): string {
  return path.replace(/\[\d+\]/g, '[1]');
}

/** Whether an error is of a key, or of what it holds. */
export function concerns({ key }: InputError, path: string): boolean {
  return key === path || key.startsWith(`${path}[`) || key.startsWith(`${path}.`);
}

function idOf(path: string): string {
  return `field-${path.replaceAll(/[^a-z0-9_]/g, '-')}`;
}

function wordsOf({ path, title, unit = '', example = '' }: CaseKey): string {
  return `${path} ${title} ${unit} ${readQuantity(example)?.unit ?? ''}`.toLowerCase();
}

/** Label, controls, and the solver's messages under them. */
function frame(key: CaseKey, controls: HTMLElement[], labelled: HTMLElement): { root: HTMLElement; tell: (errors: InputError[], given: boolean) => void } {
  const id = idOf(key.path);
  const message = el('p', { class: 'error', id: `${id}-error`, role: 'status' });
  labelled.id = id;
  labelled.setAttribute('aria-describedby', `${id}-error`);
  if (key.text !== '') labelled.title = key.text;
  const label = el('label', { for: id, title: key.text }, key.title);
  const root = el('div', { class: 'field', 'data-key': key.path }, label, el('div', { class: 'controls' }, ...controls), message);
  const tell = (errors: InputError[], given: boolean): void => {
    const own = errors.filter((error) => concerns(error, key.path));
    message.textContent = own.map(({ what, advice }) => (advice === '' ? what : `${what}; ${advice}`)).join(' · ');
    root.classList.toggle('wrong', own.length > 0);
    root.classList.toggle('default', !given);
    labelled.setAttribute('aria-invalid', String(own.length > 0));
  };
  return { root, tell };
}

/**
 * A number with a slider where there is a range for it, and with a unit where it has one.
 * @param give  writes it into the case
 * @param take  takes it out
 */
function numberField(
  key: CaseKey,
  { design, units, understood }: Place,
  give = (value: string, going?: boolean): void => design.set(key.path, value, going),
  take = (): void => design.remove(key.path),
): Field {
  const { path, unit: si = '' } = key;
  const whole = key.kind === 'whole number';
  const range = ranges[ofFirst(path)];
  const text = el('input', { type: 'text', inputmode: 'decimal', autocomplete: 'off', spellcheck: 'false', class: 'number' });
  const slider = el('input', { type: 'range', 'aria-label': `${key.title}, slider` });
  const list = el('select', { 'aria-label': `Unit of ${key.title}` });
  const usual = readQuantity(key.example ?? '')?.unit ?? si;
  const offered = Object.keys(units[si] ?? {});
  let unit = usual;
  let plain = si === '';

  /** As it stands in the case; else what it is by default. */
  const current = (): Quantity | undefined => {
    const written = design.written(path);
    const read = written === undefined ? undefined : readQuantity(written);
    if (written !== undefined) return read;
    const value = understood(path) ?? (key.presence === 'defaulted' ? key.value : undefined);
    return typeof value === 'number' ? converted({ number: value, unit: si }, usual, si, units) : undefined;
  };
  const show = (): void => {
    const now = current();
    text.value = now ? String(now.number) : (design.written(path) ?? '').replace(/^"|"$/g, '');
  };
  const set = (number: number, going: boolean): void => give(writeQuantity({ number, unit: plain ? '' : unit }), going);

  slider.addEventListener('input', () => {
    const value = Number(slider.value);
    set(whole ? Math.round(value) : Number(value.toPrecision(4)), true);
  });
  slider.addEventListener('change', () => design.change(design.text, false));
  text.addEventListener('change', () => {
    const typed = text.value.trim();
    if (typed === '') {
      if (design.written(path) !== undefined) take();
      return;
    }
    const read = readQuantity(withPoint(typed));
    // A unit may be typed, too, or a list.
    if (!read) give(valueOf(typed));
    else if (read.unit !== '') give(writeQuantity(read));
    else set(read.number, false);
    // Where it means what the case says already, nothing else tells how it was understood.
    show();
  });
  list.addEventListener('change', () => {
    const now = current();
    unit = list.value;
    plain = false;
    const same = now && converted({ ...now, unit: now.unit === '' ? si : now.unit }, unit, si, units);
    if (same) give(writeQuantity(same));
  });

  const controls = [...(range ? [slider] : []), text, ...(si === '' ? [] : [list])];
  const { root, tell } = frame(key, controls, text);
  root.classList.toggle('wide', !range);
  const refresh = (errors: InputError[]): void => {
    const now = current();
    const written = design.written(path);
    if (now) {
      plain = si === '' || (written !== undefined && now.unit === '');
      unit = now.unit === '' ? si : now.unit;
    }
    if (key.presence === 'inherited') text.placeholder = 'as the case';
    if (text !== document.activeElement || now?.number !== Number(text.value)) show();
    if (si !== '') {
      const names = offered.includes(unit) ? offered : [...offered, unit];
      if (list.childElementCount !== names.length) list.replaceChildren(...names.map((name) => el('option', { value: name }, name)));
      if (list.value !== unit) list.value = unit;
    }
    if (range) {
      const size = si === '' ? 1 : (sizeOf(unit, si, units) ?? 1);
      const [least, most, step] = range;
      slider.min = String(Number((least / size).toPrecision(6)));
      slider.max = String(Number((most / size).toPrecision(6)));
      slider.step = String(Number(((step ?? (most - least) / fineSteps) / size).toPrecision(step === undefined ? 3 : 6)));
      slider.disabled = !now && written !== undefined;
      if (now) slider.value = String(now.number);
      slider.setAttribute('aria-valuetext', now ? `${now.number} ${unit}` : 'not given');
    }
    tell(errors, written !== undefined);
  };
  return { path, root, words: wordsOf(key), refresh };
}

/** A list of two numbers, along X and Y: each has a field. */
function pairFields(key: CaseKey, place: Place): Field[] {
  const { path: list, unit: si = '' } = key;
  const { design, understood, units } = place;
  const examples = (key.example ?? '').replace(/[[\]]/g, '').split(',');
  const byDefault = (i: number): number => (Array.isArray(key.value) ? Number(key.value[i]) : 0);
  return ['X', 'Y'].map((axis, i) => {
    const path = `${list}[${i + 1}]`;
    const { unit = si } = readQuantity(examples[i] ?? '') ?? {};
    const give = (value: string, going?: boolean): void => {
      if (design.written(path) !== undefined) return design.set(path, value, going);
      const other = converted({ number: byDefault(1 - i), unit: si }, unit, si, units);
      const both = [value, other ? writeQuantity(other) : '0'];
      design.set(list, `[${(i === 0 ? both : both.reverse()).join(', ')}]`, going);
    };
    const component = (): CaseValue | undefined => {
      const value = understood(list);
      return Array.isArray(value) ? value[i] : undefined;
    };
    return numberField({ ...key, path, title: `${key.title}, ${axis}`, example: (examples[i] ?? '').trim(), value: byDefault(i) }, { ...place, understood: component }, give, () => design.remove(list));
  });
}

/** One of a few words, or true and false. */
function choiceField(key: CaseKey, words: string[], { design, understood }: Place): Field {
  const { path } = key;
  const list = el('select', {}, ...words.map((word) => el('option', { value: word }, word.replaceAll('_', ' '))));
  const truth = key.kind === 'true or false';
  list.addEventListener('change', () => design.set(path, truth ? list.value : `"${list.value}"`));
  const { root, tell } = frame(key, [list], list);
  root.classList.add('wide');
  const refresh = (errors: InputError[]): void => {
    const written = design.written(path);
    const value = written?.replace(/^["']|["']$/g, '') ?? String(understood(path) ?? key.value ?? '');
    if (list.value !== value) list.value = value;
    tell(errors, written !== undefined);
  };
  return { path, root, words: wordsOf(key), refresh };
}

/** Lists and texts, as they are written in the file. */
function textField(key: CaseKey, { design }: Place): Field {
  const { path } = key;
  const input = el('input', { type: 'text', class: 'text', autocomplete: 'off', spellcheck: 'false', placeholder: key.kind === 'text' ? '' : (key.example ?? '') });
  const isText = key.kind === 'text';
  input.addEventListener('change', () => {
    const typed = input.value.trim();
    if (typed === '' && !isText) design.remove(path);
    else design.set(path, isText ? JSON.stringify(typed) : listOf(typed));
  });
  const { root, tell } = frame(key, [input], input);
  root.classList.add('wide');
  const refresh = (errors: InputError[]): void => {
    const written = design.written(path);
    if (input !== document.activeElement) input.value = (isText ? written?.replace(/^["']|["']$/g, '') : written) ?? '';
    tell(errors, written !== undefined);
  };
  return { path, root, words: wordsOf(key), refresh };
}

function fieldOf(key: CaseKey, place: Place): Field | undefined {
  if (key.kind === '' || key.kind === 'name of a file') return undefined;
  if (key.kind === 'true or false') return choiceField(key, ['false', 'true'], place);
  if (key.kind.startsWith('"')) return choiceField(key, key.kind.split(', ').map((word) => word.replaceAll('"', '')), place);
  if (key.kind === 'text' || /^list|^two |or force/.test(key.kind)) return textField(key, place);
  return numberField(key, place);
}

export interface Section {
  root: HTMLDetailsElement;
  /** Of the table itself. */
  words: string;
  fields: () => Field[];
  /** Whether an error is shown beside one of its fields. */
  tells: (error: InputError) => boolean;
  refresh: (errors: InputError[]) => void;
}

/** A table of the case: its fields, and of an optional one what adds it and takes it out. */
function section(group: Group, keys: CaseKey[], place: Place): Section {
  const { design } = place;
  const head = keys.find(({ path }) => path === group.path);
  const inner = keys.filter(({ path }) => path.startsWith(`${group.path}.`) && !path.slice(group.path.length).includes('[') && !groups.some((other) => other !== group && other.path.startsWith(group.path) && (path === other.path || path.startsWith(`${other.path}.`))));
  const fields = inner.filter(({ path }) => !without.includes(path)).flatMap((key) => (pairs.includes(key.path) ? pairFields(key, place) : (fieldOf(key, place) ?? [])));
  const body = el('div', { class: 'fields' }, ...fields.map(({ root }) => root));
  const title = el('summary', {}, head?.title ?? group.path);
  const root = el('details', { class: 'group', 'data-table': group.path, open: group.open }, title);
  const toggle = el('button', { type: 'button', class: 'quiet' });
  if (group.optional) {
    toggle.addEventListener('click', () => {
      if (design.hasTable(group.path)) design.remove(group.path);
      else design.change(withTable(design.text, group.path, keys), false);
    });
    root.append(el('div', { class: 'group-tools' }, el('p', { class: 'note' }, head?.text ?? ''), toggle));
  }
  root.append(body);
  const refresh = (errors: InputError[]): void => {
    const there = !group.optional || design.hasTable(group.path);
    body.hidden = !there;
    toggle.textContent = there ? 'Remove' : 'Add';
    toggle.setAttribute('aria-label', `${there ? 'Remove' : 'Add'}: ${head?.title ?? group.path}`);
    if (there) for (const field of fields) field.refresh(errors);
    const wrong = errors.some(({ key }) => inner.some(({ path }) => key === path));
    root.classList.toggle('wrong', wrong);
    if (wrong) root.open = true;
  };
  return { root, words: `${group.path} ${head?.title ?? ''}`.toLowerCase(), fields: () => (body.hidden ? [] : fields), tells: (error) => fields.some(({ path }) => concerns(error, path)), refresh };
}

/** Keys of [bump_foil] and [top_foil] that a pad may have of its own. */
function ownFoilKeys(pad: string, keys: CaseKey[]): CaseKey[] {
  return keys.flatMap((key) => (/^(bump_foil|top_foil)\.\w+$/.test(key.path) ? [{ ...key, path: `${pad}.${key.path}`, presence: 'inherited' as const }] : []));
}

/** The tables of a list, each with its fields, and what adds one more. */
function listSection({ path, open, countedBy }: Group, keys: CaseKey[], place: Place): Section {
  const { design } = place;
  const head = keys.find((key) => key.path === `${path}[1]`);
  const title = head?.title ?? path;
  const own = keys.filter((key) => key.path.startsWith(`${path}[1].`) && !key.path.slice(`${path}[1].`.length).includes('.'));
  const heading = el('summary', {}, title);
  const add = el('button', { type: 'button', class: 'quiet', 'aria-label': `Add: ${title}` }, 'Add');
  const body = el('div');
  const root = el('details', { class: 'group', 'data-table': path, open }, heading, el('div', { class: 'group-tools' }, el('p', { class: 'note' }, head?.text ?? ''), add), body);
  /** One for each of what is counted, or none; at first of two. */
  const countedText = (by: string): string => {
    if (design.count(path) > 0) return withCount(design.text, path, 0);
    const count = Math.max(2, Number(place.understood(by) ?? 0));
    return withCount(withValue(design.text, by, String(count)), path, count);
  };
  add.addEventListener('click', () => design.change(countedBy === undefined ? withTable(inList(design.text, path), `${path}[${design.count(path) + 1}]`, keys) : countedText(countedBy), false));
  let entries: { fields: Field[]; takeOut: HTMLElement; root: HTMLElement }[] = [];
  const entry = (number: number): (typeof entries)[number] => {
    const table = `${path}[${number}]`;
    const fields = own.flatMap((key) => fieldOf({ ...key, path: key.path.replace('[1]', `[${number}]`) }, place) ?? []);
    const foils = path === 'pad' ? ownFoilKeys(table, keys).flatMap((key) => fieldOf(key, place) ?? []) : [];
    const takeOut = el('button', { type: 'button', class: 'quiet', 'aria-label': `Remove: ${title} ${number}` }, 'Remove');
    takeOut.addEventListener('click', () => design.remove(table));
    const inner = foils.length > 0 ? [el('details', { class: 'own-foils' }, el('summary', {}, 'Foils of its own'), el('p', { class: 'note' }, 'Keys that are not given are those of the bump foil and the top foil of the case.'), ...foils.map((field) => field.root))] : [];
    return {
      fields: [...fields, ...foils],
      takeOut,
      root: el('div', { role: 'group', 'aria-label': `${title} ${number}`, 'data-table': table }, el('div', { class: 'group-tools' }, el('p', { class: 'note' }, `No. ${number}`), takeOut), el('div', { class: 'fields' }, ...fields.map((field) => field.root), ...inner)),
    };
  };
  const refresh = (errors: InputError[]): void => {
    const count = design.count(path);
    if (count !== entries.length) {
      entries = Array.from({ length: count }, (_, i) => entries[i] ?? entry(i + 1));
      body.replaceChildren(...entries.map((one) => one.root));
    }
    heading.textContent = count === 0 ? title : `${title} (${count})`;
    const inline = design.isInline(path);
    add.hidden = inline;
    for (const { takeOut } of entries) takeOut.hidden = inline || countedBy !== undefined;
    if (countedBy !== undefined) {
      add.textContent = count > 0 ? 'Remove' : 'Add';
      add.setAttribute('aria-label', `${add.textContent}: ${title}`);
    }
    for (const { fields } of entries) for (const field of fields) field.refresh(errors);
    const wrong = errors.some((error) => error.key.startsWith(`${path}[`));
    root.classList.toggle('wrong', wrong);
    if (wrong) root.open = true;
  };
  return {
    root,
    words: [path, title, ...own.map(wordsOf)].join(' ').toLowerCase(),
    fields: () => entries.flatMap(({ fields }) => fields),
    tells: (error) => entries.some(({ fields }) => fields.some((field) => concerns(error, field.path))),
    refresh,
  };
}

/** With a table that has what it needs. */
export function withTable(text: string, path: string, keys: CaseKey[]): string {
  const first = `${ofFirst(path)}.`;
  const own = keys.filter((key) => key.path.startsWith(first) && key.kind !== '' && !key.path.slice(first.length).includes('.'));
  const needed = own.filter(({ presence }) => presence === 'required');
  // One of a list may be without keys: pads.
  const lines = (needed.length > 0 || path.endsWith(']') ? needed : own.slice(0, 1)).map((key) => `${key.path.slice(first.length)} = ${key.example ?? ''}`);
  const scatter = path === 'montecarlo' ? ['bump_height = { distribution = "normal", std = "5 um" }'] : [];
  const head = path.endsWith(']') ? `[[${path.replace(/\[\d+\]$/, '')}]]` : `[${path}]`;
  return `${text.replace(/\s*$/, '')}\n\n${head}\n${[...lines, ...scatter].join('\n')}\n`;
}

export interface Form {
  root: HTMLElement;
  /** @param errors  of the case, for the fields that they are about */
  refresh: (errors: InputError[]) => void;
  /** Whether an error is shown beside a field. */
  tells: (error: InputError) => boolean;
  /** Shows those alone that have all of the words. @return how many */
  search: (typed: string) => number;
  /** Opens all groups, or folds them. */
  fold: (open: boolean) => void;
}

export function form(keys: CaseKey[], place: Place): Form {
  const sections = groups.flatMap((group): Section[] => [(group.list ? listSection : section)(group, keys, place), ...(group.path === 'bump_foil' ? [bumpTable(keys, place)] : [])]);
  /** Groups that were open before something was searched. */
  let open: Set<Section> | undefined;
  const search = (typed: string): number => {
    const words = typed.toLowerCase().split(/\s+/).filter((word) => word !== '');
    const has = (text: string): boolean => words.every((word) => text.includes(word));
    const searching = words.length > 0;
    if (searching) open ??= new Set(sections.filter(({ root }) => root.open));
    let count = 0;
    for (const one of sections) {
      const whole = has(one.words);
      const found = one.fields().filter((field) => whole || has(field.words));
      for (const field of one.fields()) field.root.hidden = searching && !found.includes(field);
      one.root.hidden = searching && !whole && found.length === 0;
      if (open) one.root.open = searching ? !one.root.hidden : open.has(one);
      for (const inner of one.root.querySelectorAll('details')) inner.open = searching && found.some(({ root }) => inner.contains(root));
      count += found.length;
    }
    if (!searching) open = undefined;
    return count;
  };
  return {
    root: el('form', { class: 'form', 'aria-label': 'The case', autocomplete: 'off' }, ...sections.map(({ root }) => root)),
    refresh: (errors) => sections.forEach(({ refresh }) => refresh(errors)),
    tells: (error) => sections.some(({ tells }) => tells(error)),
    search,
    fold: (all) => sections.forEach(({ root }) => (root.open = all)),
  };
}
