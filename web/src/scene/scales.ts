// Scales that all frames of a film share: how much displacements are magnified, and what its colours stand for.

import { bisectLeft, cumsum, max, mean, min } from 'd3-array';
import type { BodyFrame, Frame } from '../core/protocol';
import { roundDown, roundUp } from '../drawing/numbers';
import type { Quantity } from './raster';
import { cross, displacementOf, sidesOf, type Part } from './parts';

const VISIBLE = 0.18; // maximum displacement in the picture, in radii of the body
const LEAST_AREA = 0.12; // of a magnified cell, of what it is at rest

/** The maximum magnification at which every piece of a part keeps its orientation and some of its area. */
export function unfoldedUpTo(part: Part, now: BodyFrame): number {
  const displacement = displacementOf(part, now);
  return part.cells.reduce((least, { corners, sides: [down, across], area }) => {
    const [moreDown, moreAcross] = sidesOf(displacement, corners);
    const linear = cross(moreDown, across) + cross(down, moreAcross);
    return Math.min(least, firstBelow(linear / area, cross(moreDown, moreAcross) / area));
  }, Infinity);
}

/** The least m > 0 with 1 + linear m + square m² = LEAST_AREA. */
function firstBelow(linear: number, square: number): number {
  const left = 1 - LEAST_AREA;
  if (Math.abs(square) < 1e-14) return linear < 0 ? -left / linear : Infinity;
  const discriminant = linear * linear - 4 * square * left;
  if (discriminant < 0) return Infinity;
  const root = Math.sqrt(discriminant);
  const both = [(-linear - root) / (2 * square), (-linear + root) / (2 * square)];
  return Math.min(...both.filter((each) => each > 0));
}

/** The magnification of a film, 1, 2, 5, 10, …: the same for all its frames and parts. */
export function magnificationOf(frames: Frame[], parts: Part[]): number {
  const bodies = frames.flatMap((frame) => frame.bodies.map((now, n) => ({ now, part: parts[n]! })));
  const limit = min(bodies, ({ now, part }) => unfoldedUpTo(part, now)) ?? Infinity;
  const displaced = max(bodies, ({ now }) => Math.max(max(now.radial, Math.abs)!, max(now.tangential, Math.abs)!)) ?? 0;
  const wanted = Math.min(limit, VISIBLE / displaced);
  return wanted > 1 && Number.isFinite(wanted) ? roundDown(wanted) : 1;
}

const COVERED = 0.99; // of a body's area is within the scale, in every frame
const ORDERS = 6; // fringes, at most, in that share

/** The stress that is not exceeded in a share of the area of a part. */
export function coveringStress(part: Part, values: Float32Array, covered = COVERED): number {
  const cells = part.cells.map(({ corners, area }) =>
    ({ area: Math.abs(area), stress: mean(corners, (k) => values[k]!)! })).sort((a, b) => a.stress - b.stress);
  const sums = cumsum(cells, ({ area }) => area);
  return cells[Math.min(bisectLeft(sums, covered * sums.at(-1)!), cells.length - 1)]!.stress;
}

/** Stress of the last colour, or from fringe to fringe, in the modulus of the first body: a round number that suits the
 *  bodies, for a half-space has no end. */
export function stressUnit(quantity: Quantity, frames: Frame[], parts: Part[]): number {
  const greatest = Math.max(0, ...frames.flatMap(({ bodies }) => bodies.flatMap((now, n) =>
    (parts[n]!.open ? [] : [coveringStress(parts[n]!, now[quantity])]))));
  if (!(greatest > 0)) return 1;
  return roundUp(quantity === 'fringes' ? greatest / ORDERS : greatest);
}
