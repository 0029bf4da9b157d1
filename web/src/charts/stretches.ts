import { contactStates, type ContactState, type Cycle } from '../data/run';

/** Successive increments of a contact with the same state; `first` to `last` are indices. */
export interface Stretch {
  node: number;
  state: ContactState;
  first: number;
  last: number;
}

/** States of an interface along the path, without the open ones. */
export function stretchesOf(cycle: Cycle, interfaceName: string): Stretch[] {
  const states = cycle.states(interfaceName);
  const stretches: Stretch[] = [];
  for (let node = 0; node < states.width; node += 1) {
    let current: Stretch | undefined;
    for (let index = 0; index < cycle.size; index += 1) {
      const state = contactStates[states.at(index, node)];
      if (current && current.state === state) {
        current.last = index;
        continue;
      }
      current = state && state !== 'open' ? { node, state, first: index, last: index } : undefined;
      if (current) stretches.push(current);
    }
  }
  return stretches;
}
