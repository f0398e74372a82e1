// Where rigid bodies are that collide at an angle, before, while and after they touch. x along the normal, y along the
// surface, in radii of the first; the second rests at first.

import { max } from 'd3-array';
import type { Encounter, ObliqueCollision } from '../core/protocol';
import { interpolate, roundDown } from '../drawing/numbers';
import { meetsBody, sizesOf } from '../inputs/document';

export interface Place {
  x: number;
  y: number;
  /** by which it has turned, counterclockwise, radians */
  angle: number;
}

/** A sampled function, which beyond its ends goes on as it does there. */
export function extended(times: Float64Array, values: Float64Array, time: number): number {
  const last = times.length - 1;
  const inside = Math.min(times[last]!, Math.max(times[0]!, time));
  const k = time < inside ? 1 : last;
  const slope = time === inside ? 0 : (values[k]! - values[k - 1]!) / (times[k]! - times[k - 1]!);
  return interpolate(times, values, inside) + slope * (time - inside);
}

/** Mass of what the first body meets, in that of the first. */
export function massOf({ kind, si, first, against, second }: Encounter): number {
  if (against === 'same') return 1;
  if (against !== 'body') return Infinity;
  const unit = si ? first : { density: 1, radius: 1 };
  return (second.density / unit.density) * (second.radius / unit.radius) ** (kind === 'sphere' ? 3 : 2);
}

/** How far bodies have moved and turned since they touched, times a magnification. While they touch their shapes take up
 *  what their centres move towards each other: they are drawn as if they only touched. */
export function movedSince(encounter: Encounter, collision: ObliqueCollision, magnification: number) {
  const { time: times, center, shift, angle, angle2, begin } = collision;
  const share = 1 / (1 + massOf(encounter)); // of the first in the whole mass
  const at = (values: Float64Array, time: number): number =>
    magnification * (extended(times, values, time) - extended(times, values, begin));
  const [speed, slide] = [center, shift].map((values) => (values[1]! - values[0]!) / (times[1]! - times[0]!));
  return (time: number): [Place, Place] => {
    const [x, y] = [Math.min(0, at(center, time)), at(shift, time)];
    const whole = magnification * share * (time - begin); // what the common centre has moved, over the velocity
    const own = { x: whole * speed!, y: whole * slide! };
    return [
      { x: own.x + (1 - share) * x, y: own.y + (1 - share) * y, angle: at(angle, time) },
      { x: own.x - share * x, y: own.y - share * y, angle: at(angle2, time) },
    ];
  };
}

const FAR = 2.2; // what the first body moves in a picture, in radii
const TURN = 4; // and what bodies turn in it at most, radians

/** A round magnification of the motion between two times, at least 1. */
export function motionMagnification(
  encounter: Encounter, collision: ObliqueCollision, from: number, to: number,
): number {
  const moved = movedSince(encounter, collision, 1);
  const both = [from, to].flatMap((time) => moved(time));
  const far = max(both, ({ x, y }) => Math.hypot(x, y))!;
  const turned = max(both, ({ angle }) => Math.abs(angle))!;
  return Math.max(1, roundDown(Math.min(FAR / far, TURN / Math.max(turned, 1e-12))));
}

/** Centres of bodies while they touch, and their radii; of a wall only of the first. */
export function bodiesOf(encounter: Encounter): { center: number; radius: number }[] {
  const [, second = 1] = sizesOf(encounter);
  return [{ center: -1, radius: 1 }, ...(meetsBody(encounter) ? [{ center: second, radius: second }] : [])];
}
