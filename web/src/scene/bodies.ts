// Draws the bodies of one frame: their stress, their edges, and what a single one meets.

import { interpolate } from '../drawing/numbers';
import type { Frame } from '../core/protocol';
import type { Choice } from '../inputs/document';
import { trace } from '../drawing/canvas';
import type { Theme } from '../drawing/theme';
import { paintMesh, type Pixels, type Shade } from './raster';
import { edgeOf, meshOf, type Line, type Mesh, type Part } from './parts';
import type { Layout } from './view';

export interface Drawing {
  context: CanvasRenderingContext2D;
  layout: Layout;
  density: number;
  width: number;
  theme: Theme;
  shade: Shade;
}

/** Where x = y = 0 is, and how large 1 is. */
type Place = Pick<Layout, 'x' | 'y' | 'scale'>;

/** Draws one frame. */
export function drawBodies(
  to: Drawing, { bodies }: Frame, parts: Part[], magnification: number, against: Choice['against'],
): void {
  const meshes = parts.map((part, n) => meshOf(part, bodies[n]!, magnification));
  const edges = parts.map((part, n) => edgeOf(part, meshes[n]!));
  const [first, second] = edges;
  const seam = first && second && seamOf([first, second], [parts[0]!.curvature, parts[1]!.curvature]);
  parts.forEach((part, n) => {
    to.context.save();
    if (seam) clipBeside(to, seam, n === 0);
    if (part.open) clipDeep(to);
    else strokeEdge(to, edgeOf(part, part, magnification * (bodies[n]!.center - part.center)), true, true);
    paint(to, meshes[n]!, bodies[n]![to.shade.quantity]);
    strokeEdge(to, edges[n]!, !part.open);
    for (const edge of [part.lower, part.hole]) if (edge.length > 0) strokeEdge(to, edgeOf({ edge }, meshes[n]!), false);
    to.context.restore();
  });
  if (against === 'wall') drawWall(to);
}

/** The part of an edge, from the line of impact on, where y grows: the face. */
export function faceOf(edge: Line): Line {
  const [x, y] = [Array.from(edge.x), Array.from(edge.y)];
  const end = y.findIndex((each, k) => k > 0 && !(each > y[k - 1]!));
  return end < 0 ? { x, y } : { x: x.slice(0, end), y: y.slice(0, end) };
}

/** The line where two edges meet, as far up as both faces go. Magnified displacements alone would let bodies enter each
 *  other by as much as the gap between their faces at rest is not magnified: where they overlap, each gives way as its
 *  curvature at rest asks; elsewhere the line is in the middle of the gap. `curvatures`: 1/R of both, 0 of a plane. */
export function seamOf(edges: [Line, Line], curvatures: [number, number]): Line {
  const [a, b] = edges.map(faceOf) as [Line, Line];
  const whole = curvatures[0] + curvatures[1];
  const share = whole > 0 ? curvatures[0] / whole : 0.5;
  const lower = a.y[a.y.length - 1]! <= b.y[b.y.length - 1]! ? a : b;
  const y = Array.from(lower.y);
  const x = y.map((each) => {
    const [left, right] = [interpolate(a.y, a.x, each), interpolate(b.y, b.x, each)];
    return left > right ? left - share * (left - right) : 0.5 * (left + right);
  });
  return { x, y };
}

/** Goes on along a line below the line of impact, or back along its mirror image above it. */
export function follow(context: CanvasRenderingContext2D, to: Place, { x, y }: Line, sign: 1 | -1): void {
  for (let k = 0; k < x.length; ++k) {
    const n = sign > 0 ? k : x.length - 1 - k;
    context.lineTo(to.x + to.scale * x[n]!, to.y + sign * to.scale * y[n]!);
  }
}

/** Keeps what is shown of a half-space or a plate, which have no end. */
function clipDeep({ context, layout }: Drawing): void {
  context.beginPath();
  context.rect(0, 0, layout.right, 2 * layout.y + 8);
  context.clip();
}

/** Keeps what is left, or right, of the seam; above and below it everything. */
function clipBeside({ context, layout, width }: Drawing, seam: Line, left: boolean): void {
  const [far, near] = left ? [-8, width + 8] : [width + 8, -8];
  const end = layout.scale * seam.y[seam.y.length - 1]!;
  context.beginPath();
  for (const [x, y] of [[far, -8], [near, -8], [near, layout.y - end]] as const) context.lineTo(x, y);
  follow(context, layout, seam, -1);
  follow(context, layout, seam, 1);
  for (const [x, y] of [[near, layout.y + end], [near, 2 * layout.y + 8], [far, 2 * layout.y + 8]] as const) {
    context.lineTo(x, y);
  }
  context.closePath();
  context.clip();
}

/** Memory that pictures share. */
let memory: { canvas: HTMLCanvasElement; image: ImageData } | undefined;

function paint({ context, layout, density, shade }: Drawing, mesh: Mesh, stress: Float32Array): void {
  const { width } = context.canvas;
  const height = Math.ceil(layout.y * density);
  if (memory?.image.width !== width || memory.image.height !== height) {
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    memory = { canvas, image: new ImageData(width, height) };
  }
  const { canvas, image } = memory;
  const pixels: Pixels = { width, height, data: new Uint32Array(image.data.buffer) };
  pixels.data.fill(0);
  paintMesh(pixels, mesh, stress, { origin: layout.x * density, scale: layout.scale * density }, shade);
  canvas.getContext('2d')!.putImageData(image, 0, 0);
  const line = Math.round(layout.y * density);
  context.save();
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.drawImage(canvas, 0, line);
  context.setTransform(1, 0, 0, -1, 0, line);
  context.drawImage(canvas, 0, 0);
  context.restore();
}

/** An edge and its mirror image: around a body, or along an open surface. @param rest where it would be at rest */
function strokeEdge({ context, layout, theme }: Drawing, edge: Line, closed: boolean, rest = false): void {
  context.beginPath();
  for (const sign of closed ? [1, -1] as const : [-1, 1] as const) follow(context, layout, edge, sign);
  if (closed) context.closePath();
  context.lineWidth = rest ? 1 : 1.6;
  context.lineJoin = 'round';
  context.setLineDash(rest ? [4, 4] : []);
  context.strokeStyle = rest ? theme.muted : theme.text;
  context.stroke();
}

const WALL = 0.26; // thickness, in radii

function drawWall({ context, layout, theme }: Drawing): void {
  const { x, y, scale, height } = layout;
  const thick = Math.min(WALL * scale, 60);
  const top = 2 * y - height + 4;
  context.save();
  context.beginPath();
  context.rect(x, top, thick, height - top);
  context.fillStyle = theme.panel;
  context.fill();
  context.clip();
  context.strokeStyle = theme.muted;
  context.globalAlpha = 0.55;
  context.lineWidth = 1;
  context.beginPath();
  for (let at = x - 2 * height; at < x + thick + height; at += 9) {
    context.moveTo(at, height);
    context.lineTo(at + height, 0);
  }
  context.stroke();
  context.restore();
  trace(context, [[x, top], [x, height]], theme.text);
}
