import { dropDown, el } from '../ui/dom';
import { shortTitle, type GridSelection } from '../ui/grid_selection';
import type { Coordinate } from '../data/grid';

/** One of some coordinates; hidden where there is no choice. */
function coordinateChooser(
  label: string,
  name: string,
  selection: GridSelection,
  options: () => Coordinate[],
  chosen: () => Coordinate | undefined,
  choose: (one: Coordinate) => void,
): HTMLElement {
  const list = el('select', { 'aria-label': name });
  list.addEventListener('change', () => {
    const one = options()[list.selectedIndex];
    if (one) choose(one);
  });
  const root = el('label', { class: 'control' }, label, list);
  const fill = (): void => {
    const all = options();
    root.hidden = all.length < 2;
    list.replaceChildren(...all.map(({ title }) => el('option', {}, title)));
    list.selectedIndex = all.findIndex((one) => one === chosen());
  };
  selection.onChange(fill);
  fill();
  return root;
}

/** The value of one coordinate at the point that is looked at. */
export function valueChooser(selection: GridSelection, coordinate: Coordinate, name: string): HTMLElement {
  const options = coordinate.texts.map((text, value) => ({ value, text }));
  const show = (value: number): void => selection.show({ place: { [coordinate.name]: value } });
  const list = dropDown(name, options, show);
  const follow = (): void => void (list.selectedIndex = selection.index(coordinate));
  selection.onChange(follow);
  follow();
  return el('label', { class: 'control' }, shortTitle(coordinate.title), list);
}

/** What the controls are called. */
export interface ControlNames {
  along: string;
  by: string;
  at: (title: string) => string;
}

const usual: ControlNames = { along: 'Over', by: 'Lines', at: (title) => `${title} shown` };

/** What charts go along, what tells their lines apart, and the point that is looked at. */
export function gridControls(selection: GridSelection, names: ControlNames = usual): HTMLElement {
  const several = selection.coordinates.filter(({ texts }) => texts.length > 1);
  return el(
    'div',
    { class: 'tools', role: 'group', 'aria-label': 'What is shown' },
    coordinateChooser('Over', names.along, selection, () => several.filter((one) => selection.axes.includes(one)), () => selection.along, (along) => selection.show({ along })),
    coordinateChooser('Lines', names.by, selection, () => selection.bys, () => selection.by, (by) => selection.show({ by })),
    ...(several.length > 0 ? [el('span', { class: 'control' }, 'Point:')] : []),
    ...several.map((coordinate) => valueChooser(selection, coordinate, names.at(coordinate.title))),
  );
}
