// From stress to pixels: viridis for the von Mises stress, light and dark bands for photoelastic fringes.
import { scaleLinear } from 'd3-scale';
import type { Mesh } from './parts';

const VIRIDIS = [
  '#440154', '#482475', '#414487', '#355f8d', '#2a788e', '#21918c', '#22a884', '#44bf70', '#7ad151', '#bddf26',
  '#fde725',
];
const DARK_FIELD = ['#071426', '#123a6b', '#2f7fb8', '#9fd0e8', '#fffbe8'];
const LIGHT_FIELD = ['#f3f8fb', '#a9cfe6', '#3f87bd', '#14497f', '#061a36'];

export const TABLE = 256;
const PHASES = 1024;

/** Light behind crossed polarisers against the fringe order, one order. */
const WAVE = Float32Array.from({ length: PHASES }, (_, k) => 0.5 - 0.5 * Math.cos((2 * Math.PI * (k + 0.5)) / PHASES));

/** Colours between evenly spaced ones, as opaque pixels of an ImageData. */
export function colorTable(stops: string[]): Uint32Array {
  const color = scaleLinear(stops.map((_, k) => k / (stops.length - 1)), stops);
  return Uint32Array.from({ length: TABLE }, (_, k) => {
    const [r, g, b] = color(k / (TABLE - 1)).match(/\d+/g)!.map(Number) as [number, number, number];
    return ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;
  });
}

export type Quantity = 'fringes' | 'vonMises';

/** How stress becomes colour in all frames of a film. */
export interface Shade {
  quantity: Quantity;
  /** stress of the last colour; of fringes: from one order to the next */
  unit: number;
  table: Uint32Array;
}

export function shadeOf(quantity: Quantity, unit: number, dark: boolean): Shade {
  const stops = quantity === 'vonMises' ? VIRIDIS : dark ? DARK_FIELD : LIGHT_FIELD;
  return { quantity, unit, table: colorTable(stops) };
}

/** How much of the contrast of fringes is left when a pixel spans `orders` of them: what its mean has. */
export function contrast(orders: number): number {
  if (orders < 1e-3) return 1;
  return orders >= 1 ? 0 : Math.sin(Math.PI * orders) / (Math.PI * orders);
}

/** The pixel for some stress; `left` is the contrast of fringes that is left. */
export function pixelOf(shade: Shade, stress: number, left = 1): number {
  const order = stress / shade.unit;
  if (shade.quantity === 'vonMises') {
    return shade.table[Math.max(0, Math.min(TABLE - 1, (order * TABLE) | 0))]!;
  }
  const wave = WAVE[((order - Math.floor(order)) * PHASES) | 0]!;
  return shade.table[((0.5 + (wave - 0.5) * left) * (TABLE - 1) + 0.5) | 0]!;
}

/** A pixel as a colour for a canvas. */
export function cssOf(pixel: number): string {
  return `rgb(${pixel & 255} ${(pixel >> 8) & 255} ${(pixel >> 16) & 255})`;
}

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
