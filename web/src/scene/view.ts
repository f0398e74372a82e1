// What part of the plane a film shows, and how large.

import type { Encounter, Frame } from '../core/protocol';
import { DEEP } from './grid';
import { edgeOf, meshOf, type Part } from './parts';

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
  frames: Frame[], parts: Part[], magnification: number, against: Encounter['against'],
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
  if (against === 'half-space') view.right = Math.max(view.right, DEEP);
  return view;
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
