// How much displacements are magnified: enough to see them, not so much that a body turns inside out.

import type { BodyFrame, Frame, Grid, Inside } from '../core/protocol';
import { roundDown } from '../drawing/numbers';

const VISIBLE = 0.18; // maximum displacement in the picture, in radii of the body
const LEAST_AREA = 0.12; // of a magnified cell, of what it is at rest

/** The maximum magnification at which every piece of a round body keeps its orientation and some of its area. */
export function unfoldedUpTo(body: BodyFrame, grid: Grid): number {
  const columns = grid.angle.length;
  let greatest = Infinity;
  for (let i = 1; i < grid.radius.length - 1; ++i) {
    const r = 0.5 * (grid.radius[i]! + grid.radius[i + 1]!);
    const dr = grid.radius[i + 1]! - grid.radius[i]!;
    for (let j = 0; j + 1 < columns; ++j) {
      const k = i * columns + j;
      const [a, b, c, d] = [k, k + 1, k + columns, k + columns + 1];
      const angle = grid.angle[j + 1]! - grid.angle[j]!;
      const u = body.radial;
      const w = body.tangential;
      const stretchR = (u[c]! + u[d]! - u[a]! - u[b]!) / (2 * dr);
      const shearR = (w[c]! + w[d]! - w[a]! - w[b]!) / (2 * dr);
      const turn = (u[b]! + u[d]! - u[a]! - u[c]!) / (2 * angle);
      const spread = (w[b]! + w[d]! - w[a]! - w[c]!) / (2 * angle);
      const stretchA = ((u[a]! + u[b]! + u[c]! + u[d]!) / 4 + spread) / r;
      const shearA = (turn - (w[a]! + w[b]! + w[c]! + w[d]!) / 4) / r;
      greatest = Math.min(greatest, firstBelow(stretchR + stretchA, stretchR * stretchA - shearR * shearA));
    }
  }
  return greatest;
}

/** The least m > 0 with 1 + trace m + determinant m² = LEAST_AREA. */
function firstBelow(trace: number, determinant: number): number {
  const left = 1 - LEAST_AREA;
  if (Math.abs(determinant) < 1e-14) return trace < 0 ? -left / trace : Infinity;
  const discriminant = trace * trace - 4 * determinant * left;
  if (discriminant < 0) return Infinity;
  const root = Math.sqrt(discriminant);
  const both = [(-trace - root) / (2 * determinant), (-trace + root) / (2 * determinant)];
  return Math.min(...both.map((each) => (each > 0 ? each : Infinity)));
}

/** The same for a half-space. */
export function blockUnfoldedUpTo(block: Inside, { depth, distance }: NonNullable<Grid['below']>): number {
  const columns = distance.length;
  let greatest = Infinity;
  for (let i = 0; i + 1 < depth.length; ++i) {
    for (let j = 0; j + 1 < columns; ++j) {
      const k = i * columns + j;
      const [dz, dr] = [depth[i + 1]! - depth[i]!, distance[j + 1]! - distance[j]!];
      const along = (of: Float32Array, step: number, other: number): number =>
        (of[k + step]! + of[k + step + other]! - of[k]! - of[k + other]!) / 2;
      const [zz, zr] = [along(block.radial, columns, 1) / dz, along(block.radial, 1, columns) / dr];
      const [rz, rr] = [along(block.tangential, columns, 1) / dz, along(block.tangential, 1, columns) / dr];
      greatest = Math.min(greatest, firstBelow(zz + rr, zz * rr - zr * rz));
    }
  }
  return greatest;
}

/** The same for a rod: no two of its points change places. */
export function rodUnfoldedUpTo(body: BodyFrame, grid: Grid): number {
  let greatest = Infinity;
  for (let i = 0; i + 1 < grid.radius.length; ++i) {
    const strain = (body.radial[i]! - body.radial[i + 1]!) / (grid.radius[i + 1]! - grid.radius[i]!);
    if (strain < 0) greatest = Math.min(greatest, -(1 - LEAST_AREA) / strain);
  }
  return greatest;
}

/** The magnification of a film, 1, 2, 5, 10, …: the same for all its frames and bodies. */
export function magnificationOf(frames: Frame[], grid: Grid): number {
  let limit = Infinity;
  let displaced = 0;
  const rod = grid.angle.length === 1;
  const look = ({ radial, tangential }: Inside, unfolded: number): void => {
    for (const values of [radial, tangential]) {
      for (const each of values) displaced = Math.max(displaced, Math.abs(each));
    }
    limit = Math.min(limit, unfolded);
  };
  for (const { bodies, block } of frames) {
    for (const body of bodies) look(body, rod ? rodUnfoldedUpTo(body, grid) : unfoldedUpTo(body, grid));
    if (block && grid.below) look(block, blockUnfoldedUpTo(block, grid.below));
  }
  const wanted = Math.min(limit, VISIBLE / displaced);
  return wanted > 1 && Number.isFinite(wanted) ? roundDown(wanted) : 1;
}
