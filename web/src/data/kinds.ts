/** What kinds of results there are, and the words for their parts. */

export interface Kind {
  /** In the titles of sections, where there are results of other kinds, too. */
  name: string;
  title: string;
  /** What its cycles are: the title of a list of them, the column of files, the name of each. */
  cycles: { title: string; column: string; name: (key: number) => string };
  /** What is pushed into the foils, and what they rest on. */
  journal: string;
  ground: string;
  force: string;
  /** Not round: there is no axis to look along. */
  flat: boolean;
}

/** "+X", "−Y", or the angle itself. */
export function directionName(degrees: number): string {
  const axes: Record<number, string> = { 0: '+X', 90: '+Y', 180: '−X', 270: '−Y' };
  return axes[((degrees % 360) + 360) % 360] ?? `${Number(degrees.toPrecision(6))}°`;
}

/** By the names of the commands. */
export const kinds: Record<string, Kind> = {
  cycle: {
    name: 'bearing',
    title: 'Loops and bearing',
    cycles: { title: 'Direction', column: 'direction_deg', name: directionName },
    journal: 'journal',
    ground: 'sleeve',
    force: 'Direct force',
    flat: false,
  },
  strip: {
    name: 'strip',
    title: 'Loops and strip',
    cycles: { title: 'Cycle', column: 'cycle', name: (number) => `Cycle ${number}` },
    journal: 'plate',
    ground: 'base',
    force: 'Load',
    flat: true,
  },
  equilibrium: {
    name: 'running bearing',
    title: 'Running bearing',
    cycles: { title: 'State', column: 'state', name: () => 'in operation' },
    journal: 'journal',
    ground: 'sleeve',
    force: 'Force',
    flat: false,
  },
};
