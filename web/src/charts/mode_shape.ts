// The shape of one mode, swinging.

import type { Shape } from '../core/protocol';
import { fitCanvas } from '../drawing/dom';
import { motionIsReduced, type Theme } from '../drawing/theme';
import { follow } from '../scene/bodies';
import { edgeOf, meshOf, type Line, type Part } from '../scene/parts';

const AMPLITUDE = 0.16; // maximum displacement, in radii
const PERIOD = 1.2; // s
const PERIODS = 4; // then it is still: what moves for long must be stoppable

/** How far a shape is out at a time, s: it ends where it is farthest. */
export function swing(seconds: number): number {
  return seconds >= PERIOD * PERIODS ? 1 : Math.cos((2 * Math.PI * seconds) / PERIOD);
}

/** Shows a shape that swings; returns what ends that. `theme` is asked at every picture. */
export function swingShape(
  canvas: HTMLCanvasElement, size: number, part: Part, shape: Shape, theme: () => Theme,
): () => void {
  let turn = 0;
  const begin = performance.now();
  const tick = (now: number): void => {
    const seconds = (now - begin) / 1000;
    const still = motionIsReduced();
    drawShape(canvas, size, part, shape, still ? 1 : swing(Math.max(0, seconds)), theme());
    if (!still && seconds < PERIOD * PERIODS) turn = requestAnimationFrame(tick);
  };
  turn = requestAnimationFrame(tick);
  return () => cancelAnimationFrame(turn);
}

function drawShape(canvas: HTMLCanvasElement, size: number, part: Part, shape: Shape, out: number, theme: Theme): void {
  const rod = part.curvature === 0;
  const density = fitCanvas(canvas, size, rod ? 0.45 * size : size);
  const context = canvas.getContext('2d')!;
  const none = new Float32Array(0);
  const mesh = meshOf(part, { center: part.center, ...shape, vonMises: none, fringes: none }, AMPLITUDE * out);
  const scale = (rod ? 0.7 : 0.41) * size;
  const place = { scale, x: size / 2 - scale * part.center, y: canvas.height / density / 2 };
  context.setTransform(density, 0, 0, density, 0, 0);
  context.clearRect(0, 0, size, size);
  context.lineJoin = 'round';
  const stroke = (edge: Line): void => {
    for (const sign of [1, -1] as const) {
      context.beginPath();
      follow(context, place, edge, sign);
      context.stroke();
    }
  };
  const line = (count: number, first: number, step: number): void =>
    stroke(edgeOf({ ...part, edge: Array.from({ length: count }, (_, k) => first + k * step) }, mesh));
  context.strokeStyle = theme.muted;
  context.lineWidth = 0.8;
  const { rows, columns } = part;
  const [across, along] = rod ? [24, -1] : [6, 12];
  for (let k = 1; k < across; ++k) line(columns, Math.round((k * (rows - 1)) / across) * columns, 1);
  for (let k = 0; k <= along; ++k) line(rows, Math.round((k * (columns - 1)) / along), columns);
  context.strokeStyle = theme.accent;
  context.lineWidth = 2;
  stroke(edgeOf(part, mesh));
}
