// Draws the bodies of one frame: their stress, their edges, and what a single one meets.

import type { Encounter, Frame } from '../core/protocol';
import type { Theme } from '../drawing/theme';
import type { Shade } from './colors';
import { between, faceOf } from './interface';
import { edgeOf, meshOf, type Line, type Mesh, type Part } from './parts';
import { paintMesh, type Pixels } from './raster';
import type { Layout } from './view';

export interface Drawing {
  context: CanvasRenderingContext2D;
  layout: Layout;
  density: number;
  width: number;
  theme: Theme;
  shade: Shade;
}

/** Memory that frames share. */
export interface Scratch {
  canvas: HTMLCanvasElement;
  image: ImageData | undefined;
  meshes: Mesh[];
}

export function newScratch(): Scratch {
  return { canvas: document.createElement('canvas'), image: undefined, meshes: [] };
}

/** Draws one frame. */
export function drawBodies(
  to: Drawing, { bodies }: Frame, parts: Part[], magnification: number, against: Encounter['against'],
  scratch: Scratch,
): void {
  const meshes = parts.map((part, n) =>
    (scratch.meshes[n] = meshOf(part, bodies[n]!, magnification, scratch.meshes[n])));
  const edges = parts.map((part, n) => edgeOf(part, meshes[n]!));
  const seam = parts.length === 2
    ? seamOf(edges as [Line, Line], parts.map(({ curvature }) => curvature) as [number, number]) : undefined;
  parts.forEach((part, n) => {
    to.context.save();
    if (seam) clipBeside(to, seam, n === 0);
    if (part.open) clipDeep(to);
    else strokeEdge(to, edgeOf(part, part, magnification * (bodies[n]!.center - part.center)), true, true);
    paint(to, meshes[n]!, bodies[n]![to.shade.quantity], scratch);
    strokeEdge(to, edges[n]!, !part.open);
    to.context.restore();
  });
  if (against === 'wall') drawWall(to);
}

/** The line where two edges meet, at the heights of the points of the lower face. */
function seamOf(edges: [Line, Line], curvatures: [number, number]): Line {
  const [first, second] = edges.map((edge) => Array.from(faceOf(edge).y)) as [number[], number[]];
  return between(...edges, curvatures, first.at(-1)! <= second.at(-1)! ? first : second);
}

/** Keeps what is shown of a half-space, which has no end. */
function clipDeep({ context, layout }: Drawing): void {
  context.beginPath();
  context.rect(0, 0, layout.right, 2 * layout.y + 8);
  context.clip();
}

/** Keeps what is left, or right, of the seam; above and below it everything. */
function clipBeside({ context, layout, width }: Drawing, seam: Line, left: boolean): void {
  const x = (value: number): number => layout.x + layout.scale * value;
  const y = (value: number): number => layout.y + layout.scale * value;
  const far = left ? -8 : width + 8;
  const near = left ? width + 8 : -8;
  const last = seam.y.length - 1;
  context.beginPath();
  context.moveTo(far, -8);
  context.lineTo(near, -8);
  context.lineTo(near, y(-seam.y[last]!));
  for (let k = last; k >= 0; --k) context.lineTo(x(seam.x[k]!), y(-seam.y[k]!));
  for (let k = 0; k <= last; ++k) context.lineTo(x(seam.x[k]!), y(seam.y[k]!));
  context.lineTo(near, y(seam.y[last]!));
  context.lineTo(near, 2 * layout.y + 8);
  context.lineTo(far, 2 * layout.y + 8);
  context.closePath();
  context.clip();
}

function paint(to: Drawing, mesh: Mesh, stress: Float32Array, scratch: Scratch): void {
  const { context, layout, density, shade } = to;
  const width = context.canvas.width;
  const height = Math.ceil(layout.y * density);
  const { canvas } = scratch;
  if (canvas.width !== width || canvas.height !== height || !scratch.image) {
    canvas.width = width;
    canvas.height = height;
    scratch.image = new ImageData(width, height);
  }
  const pixels: Pixels = { width, height, data: new Uint32Array(scratch.image.data.buffer) };
  pixels.data.fill(0);
  paintMesh(pixels, mesh, stress, { origin: layout.x * density, scale: layout.scale * density }, shade);
  canvas.getContext('2d')!.putImageData(scratch.image, 0, 0);
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
  for (const sign of closed ? [1, -1] : [-1, 1]) {
    for (let k = 0; k < edge.x.length; ++k) {
      const n = sign > 0 ? k : edge.x.length - 1 - k;
      context.lineTo(layout.x + layout.scale * edge.x[n]!, layout.y + sign * layout.scale * edge.y[n]!);
    }
  }
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
  context.beginPath();
  context.moveTo(x, top);
  context.lineTo(x, height);
  context.strokeStyle = theme.text;
  context.lineWidth = 1.6;
  context.stroke();
}
