// The film of a collision: which frames are asked for first, those that are there, and its time while it plays.
import { bisectRight, range } from 'd3-array';
import type { BodyFrame, Frame } from '../core/protocol';

/** Times from `from` to `to`, coarse to fine: each level halves the distance of all before it. */
export function coarseToFine(from: number, to: number, first: number, levels: number): number[][] {
  return range(levels).map((level) => {
    const pieces = (first - 1) * 2 ** level;
    const places = level === 0 ? range(pieces + 1) : range(1, pieces, 2);
    return places.map((k) => from + ((to - from) * k) / pieces);
  });
}

const BEFORE = 0.3; // of the time of contact
const AFTER = 0.7;

/** From when to when a film shows a contact that lasts from `begin` to `end`. */
export function filmSpan(begin: number, end: number): { from: number; to: number } {
  const contact = Math.max(end - begin, 1e-12);
  return { from: begin - BEFORE * contact, to: end + AFTER * contact };
}

/** The frames that are there already, in the order of their times. */
export interface Film {
  times: number[];
  frames: Frame[];
}

/** Adds a frame at its place; one with the same time takes the place of the old. */
export function insertFrame(film: Film, frame: Frame): void {
  const k = bisectRight(film.times, frame.time);
  const same = film.times[k - 1] === frame.time ? 1 : 0;
  film.times.splice(k - same, same, frame.time);
  film.frames.splice(k - same, same, frame);
}

function mixed(a: BodyFrame, b: BodyFrame, share: number): BodyFrame {
  const between = (name: 'radial' | 'tangential' | 'vonMises' | 'fringes'): Float32Array =>
    a[name].map((from, k) => from + share * (b[name][k]! - from));
  return {
    center: a.center + share * (b.center - a.center), radial: between('radial'), tangential: between('tangential'),
    vonMises: between('vonMises'), fringes: between('fringes'),
  };
}

/** The frame of a film at any time: between two of its frames both, mixed by their distance. */
export function frameAt({ times, frames }: Film, time: number): Frame | undefined {
  const k = bisectRight(times, time);
  const [a, b] = [frames[k - 1], frames[k]];
  if (!a || !b) return a ?? b;
  const share = (time - a.time) / (b.time - a.time);
  return { time, bodies: a.bodies.map((each, n) => mixed(each, b.bodies[n]!, share)) };
}

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
