import { el } from '../ui/dom';
import { withPoint } from './typed';

/** A number with a slider. */
export class NumberControl {
  readonly root: HTMLElement;
  private readonly name: Text;
  private readonly unit: Text;
  private readonly box = el('input', { type: 'text', inputmode: 'decimal', class: 'number' });
  private readonly slider = el('input', { type: 'range' });

  constructor(change: () => void) {
    this.slider.addEventListener('input', () => {
      this.box.value = this.slider.value;
      change();
    });
    this.box.addEventListener('change', () => {
      this.box.value = withPoint(this.box.value);
      this.slider.value = this.box.value;
      change();
    });
    this.name = document.createTextNode('');
    this.unit = document.createTextNode('');
    this.root = el('label', { class: 'control' }, this.name, this.slider, this.box, this.unit);
  }

  /** @param range  ends of the slider, and its step */
  call(name: string, unit: string, [least, most, step]: [number, number, number]): void {
    this.name.data = name;
    this.unit.data = unit;
    this.box.setAttribute('aria-label', `${name}, ${unit}`);
    this.slider.setAttribute('aria-label', `${name}, slider`);
    Object.assign(this.slider, { min: String(least), max: String(most), step: String(step) });
  }

  /** NaN where no number is typed. */
  get value(): number {
    return this.box.value.trim() === '' ? NaN : Number(this.box.value);
  }

  set value(value: number) {
    this.box.value = String(Number(value.toPrecision(6)));
    this.slider.value = this.box.value;
  }
}
