// A mesh with stress at its points becomes pixels.

import { contrast, pixelOf, type Shade } from './colors';
import type { Mesh } from './parts';

/** Pixels of the upper half of a picture: row 0 lies on the line of impact, rows go up. */
export interface Pixels {
  width: number;
  height: number;
  data: Uint32Array;
}

/** From radii of the first body to pixels: x pixels = origin + scale x, rows = scale y. */
export interface Transform {
  origin: number;
  scale: number;
}

/** Paints every cell of a mesh, in the colours of the stress at its points. */
export function paintMesh(pixels: Pixels, mesh: Mesh, stress: Float32Array, to: Transform, shade: Shade): void {
  const { rows, columns, x, y } = mesh;
  const triangle = (a: number, b: number, c: number): void => paintTriangle(pixels,
    to.origin + to.scale * x[a]!, to.scale * y[a]!, stress[a]!, to.origin + to.scale * x[b]!, to.scale * y[b]!,
    stress[b]!, to.origin + to.scale * x[c]!, to.scale * y[c]!, stress[c]!, shade);
  for (let i = 0; i + 1 < rows; ++i) {
    for (let j = 0, k = i * columns; j + 1 < columns; ++j, ++k) {
      triangle(k, k + 1, k + columns + 1);
      triangle(k, k + columns, k + columns + 1);
    }
  }
}

/** Paints the pixels whose centres are in a triangle; stress is linear in it. */
export function paintTriangle(
  pixels: Pixels, x0: number, y0: number, s0: number, x1: number, y1: number, s1: number,
  x2: number, y2: number, s2: number, shade: Shade,
): void {
  let swap: number;
  if (y1 < y0) {
    swap = x0; x0 = x1; x1 = swap; swap = y0; y0 = y1; y1 = swap; swap = s0; s0 = s1; s1 = swap;
  }
  if (y2 < y1) {
    swap = x1; x1 = x2; x2 = swap; swap = y1; y1 = y2; y2 = swap; swap = s1; s1 = s2; s2 = swap;
    if (y1 < y0) {
      swap = x0; x0 = x1; x1 = swap; swap = y0; y0 = y1; y1 = swap; swap = s0; s0 = s1; s1 = swap;
    }
  }
  const from = Math.max(0, Math.ceil(y0 - 0.5));
  const to = Math.min(pixels.height - 1, Math.ceil(y2 - 0.5) - 1);
  if (to < from) return;
  const area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
  if (area === 0) return;
  const alongX = ((s1 - s0) * (y2 - y0) - (s2 - s0) * (y1 - y0)) / area;
  const alongY = ((s2 - s0) * (x1 - x0) - (s1 - s0) * (x2 - x0)) / area;
  const left = shade.quantity === 'fringes' ? contrast(Math.hypot(alongX, alongY) / shade.unit) : 1;
  for (let row = from; row <= to; ++row) {
    const y = row + 0.5;
    const long = x0 + ((x2 - x0) * (y - y0)) / (y2 - y0);
    const short = y < y1 ? x0 + ((x1 - x0) * (y - y0)) / (y1 - y0) : x1 + ((x2 - x1) * (y - y1)) / (y2 - y1);
    const begin = Math.max(0, Math.ceil(Math.min(long, short) - 0.5));
    const end = Math.min(pixels.width, Math.ceil(Math.max(long, short) - 0.5));
    let stress = s0 + alongX * (begin + 0.5 - x0) + alongY * (y - y0);
    for (let k = row * pixels.width + begin, last = row * pixels.width + end; k < last; ++k) {
      pixels.data[k] = pixelOf(shade, stress, left);
      stress += alongX;
    }
  }
}
