/** Dimensions of bumps one by one: a foil whose bumps differ, as the case file says it. */
import type { CaseValue } from '../data/format';
import { el } from '../ui/dom';
import type { Section, Place } from './fields';
import type { CaseKey } from './format';
import { converted, readQuantity, sizeOf, writeQuantity } from './quantity';
import { withPoint } from './typed';
import { without, withValue } from './toml';

/** That sections may have of their own. */
const dimensions = ['pitch', 'length', 'height', 'thickness'];
/** How the dimensions of bumps are given. */
const ways = { one: 'same', linear: 'linear', geometric: 'geometric', each: 'each' } as const;
type Way = keyof typeof ways;

function tableOf(path: string): string {
  return path.slice(0, path.lastIndexOf('.'));
}

/** SI, from the weld on. */
export function alongFoil(value: CaseValue | undefined, bumps: number): number[] {
  if (Array.isArray(value)) return Array.from({ length: bumps }, (_, i) => Number(value[i] ?? 0));
  if (typeof value === 'number') return Array.from({ length: bumps }, () => value);
  const { start, end, law } = (value ?? {}) as { start?: number; end?: number; law?: string };
  if (start === undefined || end === undefined) return Array.from({ length: bumps }, () => 0);
  const part = (bump: number): number => (bumps > 1 ? bump / (bumps - 1) : 0);
  return Array.from({ length: bumps }, (_, bump) => (law === 'geometric' ? start * (end / start) ** part(bump) : start + (end - start) * part(bump)));
}

/** A dimension that bumps may have one by one. */
class Column {
  readonly head: HTMLElement;
  readonly inputs: HTMLInputElement[] = [];
  private readonly way: HTMLSelectElement | undefined;
  private readonly si: string;
  readonly unit: string;

  constructor(
    private readonly key: CaseKey,
    private readonly place: Place,
    /** Whether one value may stand for all bumps. */
    shared: boolean,
  ) {
    this.si = key.unit ?? 'm';
    this.unit = /"[-+\d.]+ (\w+)"/.exec(key.example ?? '')?.[1] ?? readQuantity(key.example ?? '')?.unit ?? this.si;
    if (shared) {
      this.way = el('select', { 'aria-label': `${key.title}: how it is given` }, ...Object.entries(ways).map(([value, text]) => el('option', { value }, text)));
      this.way.addEventListener('change', () => this.give(this.way?.value as Way));
    }
    this.head = el('th', { scope: 'col' }, el('span', {}, `${key.title.replace(/ of a bump$/, '')}, ${this.unit}`), ...(this.way ? [this.way] : []));
  }

  private get value(): CaseValue | undefined {
    return this.place.understood(this.key.path);
  }

  private get name(): string {
    return this.key.path.replace(/^.*\./, '');
  }

  private get factor(): number {
    return sizeOf(this.unit, this.si, this.place.units) ?? 1;
  }

  /** Sections that give it to some bumps, from 1. */
  private get sections(): { path: string; from: number; to: number; value: number }[] {
    const { understood } = this.place;
    return Array.from({ length: this.place.design.count('bump_foil.section') }, (_, i) => `bump_foil.section[${i + 1}]`).flatMap((path) => {
      const value = understood(`${path}.${this.name}`);
      return typeof value === 'number' ? [{ path: `${path}.${this.name}`, from: Number(understood(`${path}.from`)), to: Number(understood(`${path}.to`)), value }] : [];
    });
  }

  /** SI. */
  private values(bumps: number): number[] {
    const { sections } = this;
    return alongFoil(this.value, bumps).map((value, i) => sections.filter(({ from, to }) => from <= i + 1 && i + 1 <= to).pop()?.value ?? value);
  }

  private number(value: number): number {
    return converted({ number: value, unit: this.si }, this.unit, this.si, this.place.units)?.number ?? value;
  }

  /** All of one column are written, in place of what sections say of it. */
  private write(toml: string): void {
    const { design } = this.place;
    const given = (section: string): number => dimensions.filter((name) => design.written(`${section}.${name}`) !== undefined).length;
    // A section of nothing else goes with it.
    const gone = this.sections.map(({ path }) => (given(tableOf(path)) > 1 ? path : tableOf(path))).reverse();
    const text = gone.reduce((now, path) => without(now, design.spelled(path)), design.text);
    design.change(withValue(text, this.key.path, toml), false);
  }

  private list(values: number[]): string {
    return `[${values.map((value) => writeQuantity({ number: Number(this.number(value).toPrecision(9)), unit: this.unit })).join(', ')}]`;
  }

  private give(way: Way): void {
    const values = this.values(this.inputs.length);
    const quantity = (value: number | undefined): string => writeQuantity({ number: Number(this.number(value ?? 0).toPrecision(9)), unit: this.unit });
    if (way === 'one') this.write(quantity(values[0]));
    else if (way === 'each') this.write(this.list(values));
    else this.write(`{ start = ${quantity(values[0])}, end = ${quantity(values[values.length - 1])}, law = "${way}" }`);
  }

  cell(bump: number): HTMLElement {
    const input = el('input', { type: 'text', inputmode: 'decimal', class: 'number', autocomplete: 'off', 'aria-label': `${this.key.title}, bump ${bump + 1}, ${this.unit}` });
    this.inputs[bump] = input;
    input.addEventListener('change', () => {
      const read = readQuantity(withPoint(input.value.trim()));
      const values = this.values(this.inputs.length);
      if (!read) return this.refresh(this.inputs.length);
      const size = read.unit === '' ? this.factor : (sizeOf(read.unit, this.si, this.place.units) ?? this.factor);
      values[bump] = read.number * size;
      const { start, end, law } = (this.value ?? {}) as { start?: number; end?: number; law?: string };
      const last = bump === this.inputs.length - 1;
      // The ends of a law are its own.
      if (law !== undefined && start !== undefined && end !== undefined && (bump === 0 || last)) {
        const ends = [bump === 0 ? values[0] : start, last ? values[bump] : end].map((value) => writeQuantity({ number: Number(this.number(value ?? 0).toPrecision(9)), unit: this.unit }));
        this.write(`{ start = ${ends[0] ?? ''}, end = ${ends[1] ?? ''}, law = "${law}" }`);
      } else {
        this.write(this.list(values));
      }
    });
    return el('td', {}, input);
  }

  refresh(bumps: number): void {
    const values = this.values(bumps);
    this.inputs.forEach((input, i) => {
      const text = String(Number(this.number(values[i] ?? 0).toPrecision(6)));
      if (input.value !== text) input.value = text;
    });
    if (!this.way) return;
    const { value } = this;
    const law = (value as { law?: string } | undefined)?.law;
    this.way.value = Array.isArray(value) || this.sections.length > 0 ? 'each' : law === 'linear' || law === 'geometric' ? law : 'one';
  }
}

export function bumpTable(keys: CaseKey[], place: Place): Section {
  const columns = [...dimensions, 'height_errors'].flatMap((name) => {
    const key = keys.find(({ path }) => path === `bump_foil.${name}`);
    return key ? [new Column(key, place, name !== 'height_errors')] : [];
  });
  const body = el('tbody');
  const table = el('table', { class: 'bump-table' }, el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, 'Bump'), ...columns.map(({ head }) => head))), body);
  const title = 'Bumps one by one';
  const root = el('details', { class: 'group', 'data-table': 'bumps' }, el('summary', {}, title), el('div', { class: 'fields' }, el('p', { class: 'note' }, 'Counted from the weld. Changing a cell gives every bump its own value; a law keeps its ends.'), el('div', { class: 'scroller', tabindex: 0, role: 'group', 'aria-label': title }, table)));
  const refresh = (): void => {
    if (!root.open) return;
    const bumps = Number(place.understood('bump_foil.bumps') ?? 0);
    if (body.childElementCount !== bumps) {
      for (const column of columns) column.inputs.length = 0;
      body.replaceChildren(...Array.from({ length: bumps }, (_, bump) => el('tr', {}, el('th', { scope: 'row' }, String(bump + 1)), ...columns.map((column) => column.cell(bump)))));
    }
    for (const column of columns) column.refresh(bumps);
  };
  root.addEventListener('toggle', refresh);
  const words = `bumps one by one variable foil ${columns.map(({ unit }) => unit).join(' ')} pitch length height thickness height errors bump_foil`;
  return { root, words, fields: () => [], tells: () => false, refresh };
}
