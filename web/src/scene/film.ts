// The film of a collision: which frames are asked for first, those that are there, and its time while it plays.
import { bisector, range } from 'd3-array';
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

/** From when to when a film shows a contact that lasts from `begin` to `end`; `before` and `after` are shares of it. */
export function filmSpan(begin: number, end: number, before = BEFORE, after = AFTER): { from: number; to: number } {
  const contact = Math.max(end - begin, 1e-12);
  return { from: begin - before * contact, to: end + after * contact };
}

/** How many frames of a film, which stand in the order of their times, are not after a time. */
const passed = bisector(({ time }: Frame) => time).right;

/** Adds a frame to a film at its place; one with the same time takes the place of the old. */
export function insertFrame(film: Frame[], frame: Frame): void {
  const k = passed(film, frame.time);
  const same = film[k - 1]?.time === frame.time ? 1 : 0;
  film.splice(k - same, same, frame);
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
export function frameAt(film: Frame[], time: number): Frame | undefined {
  const k = passed(film, time);
  const [a, b] = [film[k - 1], film[k]];
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
