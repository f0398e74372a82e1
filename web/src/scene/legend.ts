// What the colours of a film mean.

import { scaleLinear } from 'd3-scale';
import { prefixFor, withUnit, written } from '../drawing/numbers';
import type { Theme } from '../drawing/theme';
import { cssOf, pixelOf, type Shade } from './colors';

/** Height of a legend, CSS pixels. */
export const LEGEND = 46;

const ORDERS = 5;

/** A stress in words: in SI with a prefix, else in the modulus of the first body. */
export function stressInWords(stress: number, modulus: number | undefined): string {
  return modulus === undefined ? withUnit(stress, 'E') : withUnit(stress * modulus, 'Pa');
}

/** Draws a legend at the foot of a picture. `modulus`: that of the first body in Pa, where units are SI. `name`: of a
 *  stress that is not shown as fringes. */
export function drawLegend(
  context: CanvasRenderingContext2D, left: number, top: number, width: number, theme: Theme, shade: Shade,
  modulus: number | undefined, name: string,
): void {
  const wide = Math.min(280, width);
  const start = left + (width - wide) / 2;
  const fringes = shade.quantity === 'fringes';
  const end = fringes ? ORDERS * shade.unit : shade.unit;
  for (let k = 0; k < wide; ++k) {
    context.fillStyle = cssOf(pixelOf(shade, (end * (k + 0.5)) / wide));
    context.fillRect(start + k, top, 1.5, 10);
  }
  context.strokeStyle = theme.muted;
  context.lineWidth = 1;
  context.strokeRect(start - 0.5, top - 0.5, wide + 1, 11);
  context.fillStyle = theme.muted;
  context.font = '11px system-ui, sans-serif';
  context.textAlign = 'center';
  const { size, unit } = prefixFor(end * (modulus ?? 1), modulus === undefined ? 'E' : 'Pa');
  const last = fringes ? ORDERS : (end * (modulus ?? 1)) / size;
  const scale = scaleLinear([0, last], [start, start + wide]);
  for (const tick of scale.ticks(5)) context.fillText(written(tick), scale(tick), top + 23);
  context.fillStyle = theme.text;
  const words = fringes
    ? `fringe order, one every σ₁ − σ₂ = ${stressInWords(shade.unit, modulus)}`
    : `${name} / ${unit}`;
  context.fillText(words, start + wide / 2, top + 39);
}
