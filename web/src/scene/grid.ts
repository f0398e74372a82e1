// The points of a body at which frames are asked for: dense where it is struck.

import { range } from 'd3-array';
import type { Grid } from '../core/protocol';
import type { BodyKind } from '../inputs/kinds';

const RADII = 44;
const ANGLES = 112;
const ALONG = 120; // of a rod
const STEEPEST = 5.5;
const PER_HALF_WIDTH = 5; // points in the half width of the contact

/** Places from 0 to 1 that are about `first` apart at 0 and grow apart evenly, `count` + 1 of them. */
export function gradedPlaces(count: number, first: number): number[] {
  let steep = 0;
  if (first < 1 / count) {
    let [low, high] = [1e-3, STEEPEST];
    for (let k = 0; k < 40; ++k) {
      steep = 0.5 * (low + high);
      if (Math.sinh(steep / count) / Math.sinh(steep) > first) low = steep;
      else high = steep;
    }
  }
  const place = (k: number): number => (steep > 0 ? Math.sinh((steep * k) / count) / Math.sinh(steep) : k / count);
  return [...range(count).map(place), 1]; // rounding must not carry the last beyond its end
}

/** The grid of a body whose contact has some maximum half width, in its own radius: one half, the other mirrors it. Of
 *  a rod `angle` goes from its middle to its side, which move alike. */
export function gridFor(kind: BodyKind, halfWidth: number): Grid {
  if (kind === 'rod') {
    return { radius: Float32Array.from({ length: ALONG + 1 }, (_, k) => k / ALONG), angle: Float32Array.of(0, 1) };
  }
  const first = Math.max(1e-4, halfWidth / PER_HALF_WIDTH);
  const depths = gradedPlaces(RADII, first);
  return {
    radius: Float32Array.from(depths, (_, k) => 1 - depths[depths.length - 1 - k]!),
    angle: Float32Array.from(gradedPlaces(ANGLES, first / Math.PI), (each) => Math.PI * each),
  };
}

const DEPTHS = 30;
const DISTANCES = 44;

/** How deep a half-space is shown, and how far from the line of impact, in radii of the body that it meets. */
export const DEEP = 0.9;
const WIDE = 1.7;

/** The same of a plate, on which waves run away that bend it; a thicker one is shown as a half-space. */
const PLATE_DEEP = 2.5;
export const PLATE_WIDE = 4;
const BEYOND = 0.3; // the picture, so that no end is seen
const PLATE_DISTANCES = 72;

/** Whether both faces of a plate are shown. */
export function isShownThrough(thickness: number): boolean {
  return thickness <= PLATE_DEEP;
}

/** The points of a half-space, or of a plate of some thickness, for a contact of some maximum half width, both in radii
 *  of the body that it meets. */
export function gridBelow(halfWidth: number, thickness = Infinity): NonNullable<Grid['below']> {
  const first = halfWidth / PER_HALF_WIDTH;
  const places = (count: number, last: number): Float32Array =>
    Float32Array.from(gradedPlaces(count, first / last), (each) => last * each);
  return isShownThrough(thickness)
    ? { depth: places(DEPTHS, thickness), distance: places(PLATE_DISTANCES, PLATE_WIDE + BEYOND) }
    : { depth: places(DEPTHS, DEEP), distance: places(DISTANCES, WIDE) };
}

/** An even grid for mode shapes, which have no contact. */
export function evenGrid(kind: BodyKind, radii = 12, angles = 96): Grid {
  if (kind === 'rod') return gridFor(kind, 1);
  return {
    radius: Float32Array.from({ length: radii + 1 }, (_, k) => k / radii),
    angle: Float32Array.from({ length: angles + 1 }, (_, k) => (Math.PI * k) / angles),
  };
}
