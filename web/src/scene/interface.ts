// Where two bodies meet in the picture. Magnified displacements alone would let them enter each other by as much as
// the gap between their faces at rest is not magnified; both are cut at the line between.

import { interpolate } from '../drawing/samples';
import type { Line } from './parts';

/** The part of an edge, from the line of impact on, where y grows: the face. */
export function faceOf(edge: Line): Line {
  let count = 1;
  while (count < edge.y.length && edge.y[count]! > edge.y[count - 1]!) ++count;
  return { x: Array.from(edge.x).slice(0, count), y: Array.from(edge.y).slice(0, count) };
}

/** The line between two faces at the given heights, at most as far up as both go: where they overlap, each gives way
 *  as its curvature at rest asks; elsewhere it is in the middle of the gap. `curvatures`: 1/R of both, 0 of a plane. */
export function between(first: Line, second: Line, curvatures: [number, number], heights: number[]): Line {
  const [a, b] = [faceOf(first), faceOf(second)];
  const whole = curvatures[0] + curvatures[1];
  const share = whole > 0 ? curvatures[0] / whole : 0.5;
  const top = Math.min(a.y[a.y.length - 1]!, b.y[b.y.length - 1]!);
  const y = heights.filter((each) => each <= top);
  const x = y.map((each) => {
    const [left, right] = [interpolate(a.y, a.x, each), interpolate(b.y, b.x, each)];
    return left > right ? left - share * (left - right) : 0.5 * (left + right);
  });
  return { x, y };
}
