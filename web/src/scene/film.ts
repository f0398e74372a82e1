// The film of a collision: which frames are asked for first, those that are there, its time while it plays, and what it
// says at one time.
import { bisector, max, range } from 'd3-array';
import type { BodyFrame, Course, Frame } from '../core/protocol';
import { interpolate, unitInWords, withUnit, written } from '../drawing/numbers';
import { say } from '../drawing/words';

export type Phase = 'approach' | 'compression' | 'restitution' | 'apart';

/** Before contact; while the bodies still approach each other; while they part; after contact. */
export function phaseAt(collision: Course, time: number): Phase {
  if (time < collision.begin) return 'approach';
  if (time > collision.end) return 'apart';
  const first = collision.velocity[0] ?? 0;
  return interpolate(collision.time, collision.velocity, time) * first > 0 ? 'compression' : 'restitution';
}

/** A time with its unit, the same for all times of a collision. */
export function timeInWords(collision: Course, time: number): string {
  return withUnit(time, collision.units.time, 3, collision.end);
}

/** How much slower a film is that shows `span`, in units of time, within `seconds`. */
export function slowness(span: number, unit: string, seconds: number): string {
  const each = span / seconds;
  if (unit === 's') return say('film.slowed', { times: written(1 / each, 2) });
  return say('film.second', { time: `${written(each, 2)} ${unitInWords(unit)}` });
}

/** One sentence for those who do not see the picture. */
export function describe(collision: Course, time: number): string {
  const phase = say(`phase.${phaseAt(collision, time)}`);
  const touching = time >= collision.begin && time <= collision.end;
  const force = touching ? Math.max(0, interpolate(collision.time, collision.force, time)) : 0;
  const greatest = Math.max(0, max(collision.force) ?? 0);
  const share = greatest > 0 ? Math.round((100 * force) / greatest) : 0;
  const inWords = withUnit(force, collision.units.force, 3, greatest);
  return say('film.describe', { phase, time: timeInWords(collision, time), force: inWords, share });
}

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
