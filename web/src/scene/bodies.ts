// Draws the bodies of one frame: their stress, their edges, and what a single one meets.

import type { Encounter, Frame, Grid } from '../core/protocol';
import { interpolate } from '../drawing/scale';
import type { Theme } from '../drawing/theme';
import type { Shade } from './colors';
import { between, faceOf, type Edge } from './interface';
import { edgeOf, magnifiedCenter, meshOf, type Mesh, type Placed } from './mesh';
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
  meshes: (Mesh | undefined)[];
}

export function newScratch(): Scratch {
  return { canvas: document.createElement('canvas'), image: undefined, meshes: [] };
}

/** Draws one frame. */
export function drawBodies(
  to: Drawing, frame: Frame, placed: Placed[], grid: Grid, magnification: number, against: Encounter['against']['kind'],
  scratch: Scratch,
): void {
  const meshes = placed.map((body, n) =>
    (scratch.meshes[n] = meshOf(body, frame.bodies[n]!, grid, magnification, scratch.meshes[n])));
  const edges = placed.map((body, n) => edgeOf(body, meshes[n]!));
  const seam = placed.length === 2 ? seamOf(placed, edges) : undefined;
  placed.forEach((body, n) => {
    const { context } = to;
    context.save();
    if (seam) clipBeside(to, seam, n === 0);
    strokeRest(to, body, magnifiedCenter(body, frame.bodies[n]!.center, magnification));
    paint(to, meshes[n]!, frame.bodies[n]![to.shade.quantity], scratch);
    strokeEdge(to, edges[n]!);
    context.restore();
  });
  if (against === 'wall') drawWall(to);
  if (frame.surface) drawSurface(to, frame.surface, magnification);
}

function seamOf(placed: Placed[], edges: Edge[]): Edge {
  const heights = faceOf(edges[placed[0]!.radius <= placed[1]!.radius ? 0 : 1]!).y;
  const curvature = (body: Placed): number => (body.kind === 'rod' ? 0 : 1 / body.radius);
  return between(edges[0]!, edges[1]!, [curvature(placed[0]!), curvature(placed[1]!)], Array.from(heights));
}

/** Keeps what is left, or right, of the seam; above and below it everything. */
function clipBeside({ context, layout, width }: Drawing, seam: Edge, left: boolean): void {
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

function strokeEdge({ context, layout, theme }: Drawing, edge: Edge): void {
  context.beginPath();
  for (const sign of [1, -1]) {
    for (let k = 0; k < edge.x.length; ++k) {
      const n = sign > 0 ? k : edge.x.length - 1 - k;
      context.lineTo(layout.x + layout.scale * edge.x[n]!, layout.y + sign * layout.scale * edge.y[n]!);
    }
  }
  context.closePath();
  context.lineWidth = 1.6;
  context.lineJoin = 'round';
  context.strokeStyle = theme.text;
  context.stroke();
}

/** The edge the body would have here if it were at rest. */
function strokeRest({ context, layout, theme }: Drawing, body: Placed, center: number): void {
  const { x, y, scale } = layout;
  context.beginPath();
  if (body.kind === 'rod') {
    const [long, high] = [scale * body.radius, scale * body.halfHeight];
    context.rect(x + scale * center - 0.5 * long, y - high, long, 2 * high);
  } else {
    context.arc(x + scale * center, y, scale * body.radius, 0, 2 * Math.PI);
  }
  context.setLineDash([4, 4]);
  context.lineWidth = 1;
  context.strokeStyle = theme.muted;
  context.stroke();
  context.setLineDash([]);
}

function hatched({ context, layout, theme }: Drawing, face: Path2D, shape: Path2D, right: number): void {
  const height = layout.height;
  context.save();
  context.fillStyle = theme.panel;
  context.fill(shape);
  context.clip(shape);
  context.strokeStyle = theme.muted;
  context.globalAlpha = 0.55;
  context.lineWidth = 1;
  context.beginPath();
  for (let at = layout.x - 2 * height; at < right + height; at += 9) {
    context.moveTo(at, height);
    context.lineTo(at + height, 0);
  }
  context.stroke();
  context.restore();
  context.strokeStyle = theme.text;
  context.lineWidth = 1.6;
  context.stroke(face);
}

const WALL = 0.26; // thickness, in radii
const STEP = 2; // pixels between two points of a surface

function drawWall(to: Drawing): void {
  const { x, scale, height, y } = to.layout;
  const thick = Math.min(WALL * scale, 60);
  const top = 2 * y - height + 4;
  const shape = new Path2D();
  shape.rect(x, top, thick, height - top);
  const face = new Path2D();
  face.moveTo(x, top);
  face.lineTo(x, height);
  hatched(to, face, shape, x + thick);
}

function drawSurface(to: Drawing, surface: { y: Float32Array; depth: Float32Array }, magnification: number): void {
  const { x, y, scale, height } = to.layout;
  const top = 2 * y - height + 4;
  const at = (reach: number): number =>
    x + scale * magnification * interpolate(surface.y, surface.depth, reach / scale);
  const face = new Path2D();
  for (let reach = y - top; reach > 0; reach -= STEP) face.lineTo(at(reach), y - reach);
  for (let reach = 0; reach < height - y; reach += STEP) face.lineTo(at(reach), y + reach);
  face.lineTo(at(height - y), height);
  const shape = new Path2D(face);
  shape.lineTo(to.width, height);
  shape.lineTo(to.width, top);
  shape.closePath();
  hatched(to, face, shape, to.width);
}
