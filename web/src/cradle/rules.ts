// What rules say of the velocities after, where the core computes them: the textbook, and collisions of two at a time.

/** What collides in turn on one line, from left to right. */
export interface Points {
  masses: readonly number[];
  speeds: readonly number[];
  /** of neighbours, and of the last one at a wall on its right, if there is one */
  restitution: number;
  wall?: number;
}

const slow = 1e-4; // of the greatest speed: approaches below it are none
const most = 10_000; // collisions, where many small ones take the speed

/** The velocities after collisions of two at a time with one ε, each over before the next begins. */
export function pairwise({ masses, speeds, restitution, wall }: Points): number[] {
  const velocities = [...speeds];
  const places = masses.map((_, k) => k);
  const ground = masses.length;
  const least = slow * Math.max(...speeds.map(Math.abs));
  for (let count = 0; count < most; ++count) {
    const met = masses.map((_, k) => {
      const last = k + 1 === masses.length;
      const approach = last ? (wall === undefined ? 0 : velocities[k]!) : velocities[k]! - velocities[k + 1]!;
      const distance = (last ? ground : places[k + 1]!) - places[k]!;
      return { k, last, approach, time: approach > least ? Math.max(0, distance) / approach : Infinity };
    }).reduce((first, each) => (each.time < first.time ? each : first));
    if (met.time === Infinity) break;
    places.forEach((place, k) => (places[k] = place + velocities[k]! * met.time));
    const { k } = met;
    if (met.last) {
      velocities[k] = -wall! * velocities[k]!;
      places[k] = ground;
      continue;
    }
    const [one, other] = [masses[k]!, masses[k + 1]!];
    const impulse = ((1 + restitution) * met.approach * one * other) / (one + other);
    velocities[k]! -= impulse / one;
    velocities[k + 1]! += impulse / other;
    places[k + 1] = places[k]!;
  }
  return velocities;
}

/** What the textbook says: the same without any loss. As many of equal balls fly off as came in. */
export function textbook({ masses, speeds, wall }: Points): number[] {
  return pairwise({ masses, speeds, restitution: 1, ...(wall === undefined ? {} : { wall: 1 }) });
}
