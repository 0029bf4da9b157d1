import { at } from '../data/run';

/** Room that a label at the end of a cycle takes, px. */
const labelHeight = 15;

/** By how much labels at these heights must move so that none covers another; in their order. */
export function labelOffsets(heights: number[]): number[] {
  const order = [...heights.keys()].sort((a, b) => at(heights, a) - at(heights, b));
  const placed = [...heights];
  order.forEach((label, i) => {
    const above = order[i - 1];
    if (above !== undefined) placed[label] = Math.max(at(placed, label), at(placed, above) + labelHeight);
  });
  // Centred on where they want to be, as a whole.
  const drift = placed.reduce((sum, height, i) => sum + height - at(heights, i), 0) / Math.max(1, placed.length);
  return placed.map((height, i) => height - at(heights, i) - drift);
}
