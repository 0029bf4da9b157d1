/** The case that is worked on: the text of its file, with what was done to it before. */
import { alternatives, commons, groups } from './ranges';
import { outlineOf, withCount, without, withValue, writtenValue, type Outline } from './toml';

/** Texts that can be gone back to. */
const mostSteps = 200;

export class Design {
  private steps: string[];
  private step = 0;
  /** Whether changes still belong to the step that is shown, as while a slider is dragged. */
  private open = false;
  private readonly listeners: (() => void)[] = [];

  constructor(text: string) {
    this.steps = [text];
  }

  get text(): string {
    return this.steps[this.step] ?? '';
  }

  private get outline(): Outline {
    return outlineOf(this.text);
  }

  /** As it is written; nothing where the case does not give it. */
  written(path: string): string | undefined {
    return writtenValue(this.text, this.outline, this.spelled(path));
  }

  /** One table alone of a list is written as other tables are, too. */
  spelled(path: string): string {
    const [, list, key = ''] = /^(.*)\[1\](.*)$/.exec(path) ?? [];
    return list !== undefined && this.outline.heads.has(list) ? list + key : path;
  }

  /** How many tables a list has. */
  count(path: string): number {
    let count = 0;
    while (this.hasTable(`${path}[${count + 1}]`)) count += 1;
    return count;
  }

  /** Whether all tables of a list stand in one value: they are changed, not added or taken out. */
  isInline(path: string): boolean {
    return this.outline.values.has(path);
  }

  hasTable(path: string): boolean {
    const table = this.spelled(path);
    return this.outline.tables.has(table) || this.outline.values.has(table) || [...this.outline.values.keys()].some((key) => key.startsWith(`${table}.`));
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** @param going  whether more of the same change is to come: it is undone as one */
  set(path: string, value: string, going = false): void {
    const others = alternatives.find((keys) => keys.includes(path)) ?? [];
    let text = others.filter((other) => other !== path && this.written(other) !== undefined).reduce(without, this.text);
    for (const { once, each } of commons) {
      const common = this.written(once);
      if (path === once) text = each.reduce(without, text);
      else if (each.includes(path) && common !== undefined) text = each.reduce((now, key) => withValue(now, key, common), without(text, once));
    }
    text = withValue(text, this.spelled(path), value);
    for (const { path: list, countedBy } of groups) {
      // One strip is a whole foil.
      if (countedBy === path && this.count(list) > 0 && !this.isInline(list) && Number(value) > 0) text = withCount(text, list, Number(value) > 1 ? Number(value) : 0);
    }
    this.change(text, going);
  }

  remove(path: string): void {
    this.change(without(this.text, this.spelled(path)), false);
  }

  change(text: string, going: boolean): void {
    if (text !== this.text) {
      if (this.open) this.steps = this.steps.slice(0, this.step);
      else this.steps = this.steps.slice(Math.max(0, this.step + 1 - mostSteps), this.step + 1);
      this.steps.push(text);
      this.step = this.steps.length - 1;
      this.open = going;
      this.tell();
    } else {
      this.open = this.open && going;
    }
  }

  get canUndo(): boolean {
    return this.step > 0;
  }

  get canRedo(): boolean {
    return this.step + 1 < this.steps.length;
  }

  undo(): void {
    this.go(-1);
  }

  redo(): void {
    this.go(1);
  }

  private go(by: number): void {
    const step = this.step + by;
    if (step < 0 || step >= this.steps.length) return;
    this.step = step;
    this.open = false;
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
