/** The case that is worked on: the text of its file, with what was done to it before. */
import { alternatives } from './ranges';
import { outlineOf, without, withValue, writtenValue, type Outline } from './toml';

/** Texts that can be gone back to. */
const mostSteps = 200;

export class Design {
  private steps: string[];
  private step = 0;
  /** Whether changes still belong to the step that is shown, as while a slider is dragged. */
  private open = false;
  private cached: { text: string; outline: Outline } | undefined;
  private readonly listeners: (() => void)[] = [];

  constructor(text: string) {
    this.steps = [text];
  }

  get text(): string {
    return this.steps[this.step] ?? '';
  }

  private get outline(): Outline {
    if (this.cached?.text !== this.text) this.cached = { text: this.text, outline: outlineOf(this.text) };
    return this.cached.outline;
  }

  /** As it is written; nothing where the case does not give it. */
  written(path: string): string | undefined {
    return writtenValue(this.text, this.outline, path);
  }

  hasTable(path: string): boolean {
    return this.outline.tables.has(path) || this.outline.values.has(path) || [...this.outline.values.keys()].some((key) => key.startsWith(`${path}.`));
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** @param going  whether more of the same change is to come: it is undone as one */
  set(path: string, value: string, going = false): void {
    const others = alternatives.find((keys) => keys.includes(path)) ?? [];
    const text = others.filter((other) => other !== path && this.written(other) !== undefined).reduce(without, this.text);
    this.change(withValue(text, path, value), going);
  }

  remove(path: string): void {
    this.change(without(this.text, path), false);
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
