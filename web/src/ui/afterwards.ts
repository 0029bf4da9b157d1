/** Drawing in two steps, for a page that answers while a slider is dragged: what is in sight first, the rest once that is painted. */

type Work = () => void;

/** Of the change under way; none where all is drawn at once. */
let postponed: Set<Work> | undefined;

/** Makes a change. @return what draws that which the change postpones, each once */
export function inTwoSteps(change: Work): Work {
  const works = new Set<Work>();
  postponed = works;
  try {
    change();
  } finally {
    postponed = undefined;
  }
  return () => works.forEach((work) => work());
}

/** Does it at once, or in the second step of the change under way. */
export function afterwards(work: Work): void {
  if (postponed) postponed.add(work);
  else work();
}
