// A deformed body as a mesh in the plane of the picture: the half above the line of impact, the other mirrors it.

import type { BodyFrame, Grid, Inside } from '../core/protocol';
import type { BodyKind } from '../inputs/kinds';

/** Points in rows and columns, row-major. Places are in radii of the first body, y ≥ 0. */
export interface Mesh {
  rows: number;
  columns: number;
  x: Float32Array;
  y: Float32Array;
}

/** What a body is in the picture. */
export interface Placed {
  kind: BodyKind;
  /** in radii of the first; of a rod its length in lengths of the first */
  radius: number;
  /** 1: what it meets is to the right; −1: to the left */
  facing: 1 | -1;
  /** of a rod: half its thickness */
  halfHeight: number;
}

/** Place of the centre with all movement from where bodies at rest would touch magnified. */
export function magnifiedCenter(body: Placed, center: number, magnification: number): number {
  const reach = body.kind === 'rod' ? 0.5 * body.radius : body.radius;
  const touching = -body.facing * reach;
  return touching + magnification * (center - touching);
}

/** Where the points of a body are when displacements are magnified. `into` is written over. */
export function meshOf(body: Placed, frame: BodyFrame, grid: Grid, magnification: number, into?: Mesh): Mesh {
  const center = magnifiedCenter(body, frame.center, magnification);
  return body.kind === 'rod'
    ? rodMesh(body, frame, grid, magnification, center, into)
    : roundMesh(body, frame, grid, magnification, center, into);
}

function fresh(rows: number, columns: number, into?: Mesh): Mesh {
  if (into && into.rows === rows && into.columns === columns) return into;
  return { rows, columns, x: new Float32Array(rows * columns), y: new Float32Array(rows * columns) };
}

function roundMesh(
  body: Placed, frame: BodyFrame, grid: Grid, magnification: number, center: number, into?: Mesh,
): Mesh {
  const columns = grid.angle.length;
  const mesh = fresh(grid.radius.length, columns, into);
  const cosine = Float32Array.from(grid.angle, Math.cos);
  const sine = Float32Array.from(grid.angle, Math.sin);
  for (let i = 0, k = 0; i < mesh.rows; ++i) {
    for (let j = 0; j < columns; ++j, ++k) {
      const out = grid.radius[i]! + magnification * frame.radial[k]!;
      const along = magnification * frame.tangential[k]!;
      mesh.x[k] = center + body.facing * body.radius * (out * cosine[j]! - along * sine[j]!);
      mesh.y[k] = body.radius * (out * sine[j]! + along * cosine[j]!);
    }
  }
  return mesh;
}

function rodMesh(
  body: Placed, frame: BodyFrame, grid: Grid, magnification: number, center: number, into?: Mesh,
): Mesh {
  const mesh = fresh(grid.radius.length, 2, into);
  for (let i = 0; i < mesh.rows; ++i) {
    const x = center + body.facing * body.radius * (0.5 - grid.radius[i]! + magnification * frame.radial[i]!);
    mesh.x[2 * i] = mesh.x[2 * i + 1] = x;
    mesh.y[2 * i] = 0;
    mesh.y[2 * i + 1] = body.halfHeight;
  }
  return mesh;
}

/** Where the points of a half-space are: depths × distances. */
export function blockMesh(block: Inside, below: NonNullable<Grid['below']>, magnification: number, into?: Mesh): Mesh {
  const { depth, distance } = below;
  const mesh = fresh(depth.length, distance.length, into);
  for (let i = 0, k = 0; i < mesh.rows; ++i) {
    for (let j = 0; j < mesh.columns; ++j, ++k) {
      mesh.x[k] = depth[i]! + magnification * block.radial[k]!;
      mesh.y[k] = distance[j]! + magnification * block.tangential[k]!;
    }
  }
  return mesh;
}

/** The surface of a half-space, from the line of impact on. */
export function surfaceOf(mesh: Mesh): { x: Float32Array; y: Float32Array } {
  return { x: mesh.x.subarray(0, mesh.columns), y: mesh.y.subarray(0, mesh.columns) };
}

/** The edge of a body's upper half: from the line of impact where it is struck, to that line on its far side. */
export function edgeOf(body: Placed, mesh: Mesh): { x: Float32Array; y: Float32Array } {
  if (body.kind === 'rod') {
    const last = 2 * mesh.rows - 1;
    return {
      x: Float32Array.of(mesh.x[0]!, mesh.x[1]!, mesh.x[last]!, mesh.x[last - 1]!),
      y: Float32Array.of(0, body.halfHeight, body.halfHeight, 0),
    };
  }
  const start = (mesh.rows - 1) * mesh.columns;
  return { x: mesh.x.subarray(start, start + mesh.columns), y: mesh.y.subarray(start, start + mesh.columns) };
}
