// The shape of one mode, swinging.

import type { Grid, Shape } from '../core/protocol';
import { fitCanvas } from '../drawing/sized';
import { motionIsReduced, type Theme } from '../drawing/theme';
import { meshOf, type Placed } from '../scene/mesh';

const AMPLITUDE = 0.16; // maximum displacement, in radii
const PERIOD = 1.2; // s
const PERIODS = 4; // then it is still: what moves for long must be stoppable

export interface ShapeView {
  canvas: HTMLCanvasElement;
  show(body: Placed, shape: Shape, grid: Grid): void;
  stop(): void;
}

/** How far a shape is out at a time, s: it ends where it is farthest. */
export function swing(seconds: number): number {
  return seconds >= PERIOD * PERIODS ? 1 : Math.cos((2 * Math.PI * seconds) / PERIOD);
}

/** A canvas for mode shapes of some size; `theme` is asked at every picture. */
export function createShapeView(size: number, theme: () => Theme): ShapeView {
  const canvas = document.createElement('canvas');
  canvas.setAttribute('aria-hidden', 'true');
  let turn = 0;
  const stop = (): void => cancelAnimationFrame(turn);
  return {
    canvas,
    stop,
    show(body, shape, grid) {
      stop();
      const begin = performance.now();
      const tick = (now: number): void => {
        if (!canvas.isConnected) return;
        const seconds = (now - begin) / 1000;
        const still = motionIsReduced();
        drawShape(canvas, size, body, shape, grid, still ? 1 : swing(Math.max(0, seconds)), theme());
        if (!still && seconds < PERIOD * PERIODS) turn = requestAnimationFrame(tick);
      };
      turn = requestAnimationFrame(tick);
    },
  };
}

function drawShape(
  canvas: HTMLCanvasElement, size: number, body: Placed, shape: Shape, grid: Grid, out: number, theme: Theme,
): void {
  const density = fitCanvas(canvas, size, body.kind === 'rod' ? 0.45 * size : size);
  const context = canvas.getContext('2d')!;
  const none = new Float32Array(0);
  const mesh = meshOf(body, { center: 0, ...shape, vonMises: none, fringes: none }, grid, AMPLITUDE * out);
  const offset = body.kind === 'rod' ? -0.5 * body.radius : -body.radius; // meshOf puts the struck end at x = 0
  const [middleX, middleY] = [size / 2, canvas.height / density / 2];
  const scale = body.kind === 'rod' ? (0.7 * size) / body.radius : (0.41 * size) / body.radius;
  context.setTransform(density, 0, 0, density, 0, 0);
  context.clearRect(0, 0, size, size);
  context.lineJoin = 'round';
  const magnifiedShift = body.facing * offset * (1 - AMPLITUDE * out);
  const trace = (indices: number[], closed: boolean): void => {
    context.beginPath();
    for (const sign of closed ? [1, -1] : [1]) {
      for (const k of sign > 0 ? indices : [...indices].reverse()) {
        context.lineTo(middleX + scale * (mesh.x[k]! - magnifiedShift), middleY - sign * scale * mesh.y[k]!);
      }
    }
    if (closed) context.closePath();
    context.stroke();
  };
  const mirror = (indices: number[]): void => {
    trace(indices, false);
    context.save();
    context.translate(0, 2 * middleY);
    context.scale(1, -1);
    trace(indices, false);
    context.restore();
  };
  const row = (i: number): number[] => Array.from({ length: mesh.columns }, (_, j) => i * mesh.columns + j);
  const column = (j: number): number[] => Array.from({ length: mesh.rows }, (_, i) => i * mesh.columns + j);
  context.strokeStyle = theme.muted;
  context.lineWidth = 0.8;
  const lines = body.kind === 'rod' ? 24 : 6;
  for (let k = 1; k < lines; ++k) mirror(row(Math.round((k * (mesh.rows - 1)) / lines)));
  if (body.kind !== 'rod') {
    for (let k = 0; k <= 12; ++k) mirror(column(Math.round((k * (mesh.columns - 1)) / 12)));
  }
  context.strokeStyle = theme.accent;
  context.lineWidth = 2;
  if (body.kind === 'rod') {
    const last = 2 * (mesh.rows - 1);
    trace([0, 1, last + 1, last], true);
  } else {
    trace(row(mesh.rows - 1), true);
  }
}
