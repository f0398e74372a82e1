// From stress to colour: viridis for the von Mises stress, light and dark bands for photoelastic fringes.
import { scaleLinear } from 'd3-scale';

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
