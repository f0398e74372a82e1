// What all frames of a film share: how much displacements are magnified, what its colours stand for, and what part of
// the plane it shows, how large.

import { bisectLeft, cumsum, max, mean, min } from 'd3-array';
import type { BodyFrame, Frame } from '../core/protocol';
import { roundDown, roundUp } from '../drawing/numbers';
import type { Choice } from '../inputs/document';
import { isBlock } from '../inputs/kinds';
import { DEEP, PLATE_WIDE } from './grid';
import { cross, displacementOf, edgeOf, meshOf, type Part, sidesOf } from './parts';
import type { Quantity } from './raster';

const VISIBLE = 0.18; // maximum displacement in the picture, in radii of the body
const BENT = 0.36; // the same where a plate bends, which does so far around
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
  const bends = parts.some(({ lower }) => lower.length > 0);
  const wanted = Math.min(limit, (bends ? BENT : VISIBLE) / displaced);
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
 *  bodies, for a half-space has no end; the half-space where bodies are drawn at rest. */
export function stressUnit(quantity: Quantity, frames: Frame[], parts: Part[]): number {
  const greatestOf = (open: boolean): number => Math.max(0, ...frames.flatMap(({ bodies }) => bodies.flatMap((now, n) =>
    (parts[n]!.open === open ? [coveringStress(parts[n]!, now[quantity])] : []))));
  const greatest = greatestOf(false) || greatestOf(true);
  if (!(greatest > 0)) return 1;
  return roundUp(quantity === 'fringes' ? greatest / ORDERS : greatest);
}

/** In radii of the first body; the line of impact is y = 0. */
export interface View {
  left: number;
  right: number;
  half: number;
}

const ZOOM = 4.6; // a body is shown as far as this many radii of the smaller one
const GROUND = 0.3; // a wall's thickness
const MARGIN = 0.08;

/** The view in which all frames fit, as far as the smaller body lets the larger one be seen. */
export function viewOf(
  frames: Frame[], parts: Part[], magnification: number, against: Choice['against'],
): View {
  const view: View = { left: 0, right: 0, half: 0 };
  const bounded = parts.filter(({ open }) => !open);
  for (const frame of frames) {
    bounded.forEach((part, n) => {
      const { x, y } = edgeOf(part, meshOf(part, frame.bodies[n]!, magnification));
      view.left = Math.min(view.left, ...x);
      view.right = Math.max(view.right, ...x);
      view.half = Math.max(view.half, ...y);
    });
  }
  const small = Math.min(...bounded.map(({ size }) => size));
  const reach = ZOOM * small;
  view.left = Math.max(view.left - MARGIN * small, -reach);
  view.right = Math.min(view.right + MARGIN * small, reach);
  view.half = Math.min(view.half + MARGIN * small, 0.5 * reach);
  if (against === 'wall') view.right = GROUND * (parts[0]!.curvature === 0 ? 0.3 : 1);
  if (isBlock(against)) view.right = Math.max(view.right, DEEP);
  const n = parts.findIndex(({ lower }) => lower.length > 0);
  if (n >= 0) {
    view.right = Math.max(...frames.flatMap(({ bodies }) => lowerFace(parts[n]!, bodies[n]!, magnification).x)) + MARGIN;
    view.half = PLATE_WIDE;
  }
  return view;
}

/** The lower face of a plate. */
function lowerFace(part: Part, now: BodyFrame, magnification: number): ReturnType<typeof edgeOf> {
  return edgeOf({ edge: part.lower }, meshOf(part, now, magnification));
}

export interface Layout {
  /** CSS pixels of a radius, and where x = y = 0 is */
  scale: number;
  x: number;
  y: number;
  /** where the view ends on the right */
  right: number;
  /** height of the picture without its legend */
  height: number;
}

/** Height of the line of words above a picture, CSS pixels. */
export const HEAD = 26;
const TALLEST = 400;
const LOWEST = 110;

/** Where a view is in a picture of some width; whole pixels of the device on the line of impact. */
export function layoutOf(view: View, width: number, density: number): Layout {
  const span = view.right - view.left;
  const scale = Math.min((width - 8) / span, TALLEST / (2 * view.half));
  const inner = Math.max(LOWEST, 2 * view.half * scale);
  const y = Math.round((HEAD + inner / 2) * density) / density;
  const x = (width - span * scale) / 2 - view.left * scale;
  return { scale, x, y, right: x + view.right * scale, height: HEAD + inner + 6 };
}
