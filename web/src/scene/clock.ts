// The time of a film while it plays.

/** At the end a film rests this long, s, then it begins again. */
export const REST = 0.8;
/** A film lasts this long at the speed 1, s. */
export const LENGTH = 8;

export interface Clock {
  time: number;
  /** how long it has rested at the end, s */
  rested: number;
}

/** The clock after some seconds of play. `speed`: 1 plays all from `from` to `to` within LENGTH. */
export function advance(clock: Clock, seconds: number, speed: number, from: number, to: number): Clock {
  if (clock.time >= to) {
    const rested = clock.rested + seconds;
    return rested >= REST ? { time: from, rested: 0 } : { time: to, rested };
  }
  return { time: Math.min(to, clock.time + (seconds * speed * (to - from)) / LENGTH), rested: 0 };
}
