// Which frames of a collision are asked for first, and how long the film is.

/** Times from `from` to `to`, coarse to fine: each level halves the distance of all before it. */
export function coarseToFine(from: number, to: number, first: number, levels: number): number[][] {
  const asked: number[][] = [];
  for (let level = 0; level < levels; ++level) {
    const pieces = (first - 1) * 2 ** level;
    const times: number[] = [];
    for (let k = 0; k <= pieces; ++k) {
      if (level === 0 || k % 2 === 1) times.push(from + ((to - from) * k) / pieces);
    }
    asked.push(times);
  }
  return asked;
}

const BEFORE = 0.3; // of the time of contact
const AFTER = 0.7;

/** From when to when a film shows a contact that lasts from `begin` to `end`. */
export function filmSpan(begin: number, end: number): { from: number; to: number } {
  const contact = Math.max(end - begin, 1e-12);
  return { from: begin - BEFORE * contact, to: end + AFTER * contact };
}
