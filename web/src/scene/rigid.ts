// Where rigid bodies are that collide at an angle, before, while and after they touch, in radii of the first.

import { max } from 'd3-array';
import type { ObliqueCollision } from '../core/protocol';
import { interpolate, roundDown } from '../drawing/numbers';

export interface Place {
  x: number;
  y: number;
  /** by which it has turned since first contact, counterclockwise, radians */
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

/** Where bodies of some radii are at a time, when all motion from where they touch is magnified. While they touch their
 *  shapes take up what their centres move towards each other: they are drawn as if they only touched. */
export function placesIn({ time: times, begin, bodies }: ObliqueCollision, radii: number[], magnification: number) {
  return (time: number): Place[] => bodies.map(({ x, y, angle }, n) => {
    const since = (values: Float64Array): number =>
      magnification * (extended(times, values, time) - extended(times, values, begin));
    const [side, radius] = [n === 0 ? -1 : 1, radii[n]!];
    const apart = Math.max(0, side * extended(times, x, time) - radius);
    return { x: side * (radius + magnification * apart), y: since(y), angle: since(angle) };
  });
}

const FAR = 2.2; // what the first body moves in a picture, in radii
const TURN = 4; // and what bodies turn in it at most, radians

/** A round magnification of the motion between two times, at least 1. */
export function motionMagnification(collision: ObliqueCollision, radii: number[], from: number, to: number): number {
  const places = [from, to].flatMap(placesIn(collision, radii, 1));
  const far = max(places, ({ x, y }, n) => Math.hypot(Math.abs(x) - radii[n % collision.bodies.length]!, y))!;
  const turned = max(places, ({ angle }) => Math.abs(angle))!;
  return Math.max(1, roundDown(Math.min(FAR / far, TURN / Math.max(turned, 1e-12))));
}
