// The scale of colours of a film, from the stress in some of its frames.

import type { Frame, Grid } from '../core/protocol';
import { roundUp } from '../drawing/numbers';
import type { Quantity } from './colors';

const COVERED = 0.99; // of a body's area is within the scale, in every frame
const ORDERS = 6; // fringes, at most, in that share

/** The stress that is not exceeded in a share of the area of a body. */
export function coveringStress(values: Float32Array, grid: Grid, covered = COVERED): number {
  const columns = grid.angle.length;
  const width = (places: Float32Array, k: number): number =>
    places.length === 1 ? 1 : (places[Math.min(k + 1, places.length - 1)]! - places[Math.max(k - 1, 0)]!) / 2;
  const turns = Array.from(grid.angle, (_, j) => width(grid.angle, j));
  const weight = Float64Array.from(values, (_, k) => {
    const i = Math.floor(k / columns);
    return (columns === 1 ? 1 : grid.radius[i]!) * width(grid.radius, i) * turns[k % columns]!;
  });
  const order = Array.from(values.keys()).sort((a, b) => values[a]! - values[b]!);
  const whole = weight.reduce((sum, each) => sum + each, 0);
  let sum = 0;
  for (const k of order) {
    sum += weight[k]!;
    if (sum >= covered * whole) return values[k]!;
  }
  return values[order[order.length - 1]!] ?? 0;
}

/** Stress of the last colour, or from fringe to fringe: a round number, in the modulus of the first body. */
export function stressUnit(quantity: Quantity, frames: Frame[], grid: Grid): number {
  let greatest = 0;
  for (const frame of frames) {
    for (const body of frame.bodies) greatest = Math.max(greatest, coveringStress(body[quantity], grid));
  }
  if (!(greatest > 0)) return 1;
  return roundUp(quantity === 'fringes' ? greatest / ORDERS : greatest);
}
