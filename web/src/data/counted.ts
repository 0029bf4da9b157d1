/** Numbers of bumps and feet: from the weld, of several pads from that of each. */

export interface Counted {
  /** Absent where there is one foil all around. */
  pad?: number;
  number: number;
}

/** @param pads  the pad of each bump or foot, from 1; empty where there is one foil all around. */
export function countedFromWeld(pads: number[], index: number): Counted {
  const pad = pads[index];
  return pad === undefined ? { number: index + 1 } : { pad, number: index - pads.indexOf(pad) + 1 };
}

/** "3", of several pads "3 of pad 2". */
export function numberText({ pad, number }: Counted): string {
  return pad === undefined ? String(number) : `${number} of pad ${pad}`;
}

/** The same on an axis: "3", of several pads "2.3". */
export function tickText({ pad, number }: Counted): string {
  return pad === undefined ? String(number) : `${pad}.${number}`;
}

/** What such an axis is called. */
export function axisText(what: string, ofPads: boolean): string {
  return ofPads ? `Pad.${what}, counted from its weld` : `${what.slice(0, 1).toUpperCase()}${what.slice(1)}, counted from the weld`;
}
