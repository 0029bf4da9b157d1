import { at } from '../data/run';
import type { Coordinate, Place } from '../data/grid';

/** What the reader looks at of a grid: a point, along which coordinate charts go, and what tells their lines apart. */
export class GridSelection {
  place: Place;
  along: Coordinate;
  by: Coordinate | undefined;
  private readonly listeners: (() => void)[] = [];

  /**
   * @param coordinates  all, in their order
   * @param axes         those that charts may go along, at least one; several of one name are one in other units
   */
  constructor(
    readonly coordinates: Coordinate[],
    readonly axes: Coordinate[],
  ) {
    this.along = axes.find(({ texts }) => texts.length > 1) ?? at(axes, 0);
    this.by = this.bys[0];
    // The first direction, the greatest value along the axis; of other keys one that is no extreme.
    const first = (one: Coordinate): number => (one === this.along ? one.texts.length - 1 : axes.includes(one) ? one.texts.length >> 1 : 0);
    this.place = Object.fromEntries(coordinates.map((one) => [one.name, first(one)]));
  }

  /** What can tell lines apart: keys before directions. */
  get bys(): Coordinate[] {
    const others = this.coordinates.filter((one) => one.name !== this.along.name && one.texts.length > 1);
    return [...others.filter((one) => this.axes.includes(one)), ...others.filter((one) => !this.axes.includes(one))];
  }

  index(coordinate: Coordinate): number {
    return this.place[coordinate.name] ?? 0;
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  show(change: { place?: Place; along?: Coordinate; by?: Coordinate }): void {
    Object.assign(this, change, { place: { ...this.place, ...change.place } });
    // A chart goes along one coordinate, and its lines differ in another.
    if (!this.by || this.by === this.along) this.by = this.bys[0];
    for (const listener of this.listeners) listener();
  }

  /** Of the coordinates that have a choice, but for those named: "+X, friction 0.1". */
  textAt(place: Place, ...without: (Coordinate | undefined)[]): string {
    return this.coordinates
      .filter((one) => one.texts.length > 1 && !without.some((other) => other?.name === one.name))
      .map((one) => named(one, place[one.name] ?? 0))
      .join(', ');
  }
}

/** "Coefficient 0.1"; of directions and the like the value says enough. */
export function named({ title, texts, numbers }: Coordinate, index: number): string {
  const text = texts[index] ?? '';
  return numbers ? `${shortTitle(title)} ${text}` : text;
}

/** "Coefficient" of "Top foil on bumps: Coefficient". */
export function shortTitle(title: string): string {
  return title.slice(title.lastIndexOf(':') + 1).trim();
}
