/** The lines of bump foils, wider where the sheet is thicker. */
import { formatQuantity } from '../data/units';
import { svg } from '../ui/dom';
import type { Look } from '../ui/theme';
import { pathOf, type Place } from './drawing';
import type { BearingGeometry } from './geometry';
import { foilPieces, type ShapePoint } from './shape';
import type { Scene } from './unwrapped';

/** @param width  of the line of a foil that is as thick everywhere */
export function foilLines({ geometry, shape }: Scene, place: (point: ShapePoint) => Place, width: number, current: Look): SVGElement[] {
  const paths = new Map<number, string>();
  for (const { weight, points } of foilPieces(geometry, shape)) paths.set(weight, `${paths.get(weight) ?? ''}${pathOf(points.map(place))}`);
  return [...paths].map(([weight, d]) =>
    svg('path', { d, class: 'foil bump-foil', fill: 'none', stroke: current.bumpFoil, 'stroke-width': Number((width * weight).toFixed(2)), 'stroke-linejoin': 'round' }),
  );
}

/** What the widths mean; nothing where they are all the same. */
export function gradingOf(geometry: BearingGeometry): string {
  if (!geometry.isGraded) return '';
  const [least, most] = [Math.min(...geometry.thicknesses), Math.max(...geometry.thicknesses)].map((thickness) => formatQuantity(thickness, 'm', 3));
  return `bump foil ${least ?? ''} to ${most ?? ''} thick, line width scales with the cube`;
}
