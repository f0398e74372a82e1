// Draws the bodies of one frame: their stress, their edges, and what a single one meets.

import type { Encounter, Frame, Grid } from '../core/protocol';
import type { Theme } from '../drawing/theme';
import type { Shade } from './colors';
import { between, faceOf, type Edge } from './interface';
import { blockMesh, edgeOf, magnifiedCenter, meshOf, surfaceOf, type Mesh, type Placed } from './mesh';
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
  const edges: Edge[] = placed.map((body, n) => edgeOf(body, meshes[n]!));
  const curvatures = placed.map((body) => (body.kind === 'rod' ? 0 : 1 / body.radius));
  const block = frame.block && grid.below &&
    (scratch.meshes[placed.length] = blockMesh(frame.block, grid.below, magnification, scratch.meshes[placed.length]));
  if (block) {
    edges.push(surfaceOf(block));
    curvatures.push(0);
  }
  const seam = edges.length === 2 ? seamOf(edges as [Edge, Edge], curvatures as [number, number]) : undefined;
  placed.forEach((body, n) => beside(to, seam, n === 0, () => {
    strokeRest(to, body, magnifiedCenter(body, frame.bodies[n]!.center, magnification));
    paint(to, meshes[n]!, frame.bodies[n]![to.shade.quantity], scratch);
    strokeEdge(to, edges[n]!, true);
  }));
  if (against === 'wall') drawWall(to);
  if (block) {
    beside(to, seam, false, () => {
      clipDeep(to);
      paint(to, block, frame.block![to.shade.quantity], scratch);
      strokeEdge(to, edges[1]!, false);
    });
  }
}

/** The line where two edges meet, at the heights of the points of the lower face. */
function seamOf(edges: [Edge, Edge], curvatures: [number, number]): Edge {
  const [first, second] = edges.map((edge) => Array.from(faceOf(edge).y)) as [number[], number[]];
  return between(...edges, curvatures, first.at(-1)! <= second.at(-1)! ? first : second);
}

/** Draws left, or right, of the seam, if there is one. */
function beside(to: Drawing, seam: Edge | undefined, left: boolean, draw: () => void): void {
  to.context.save();
  if (seam) clipBeside(to, seam, left);
  draw();
  to.context.restore();
}

/** Keeps what is shown of a half-space, which has no end. */
function clipDeep({ context, layout }: Drawing): void {
  context.beginPath();
  context.rect(0, 0, layout.right, 2 * layout.y + 8);
  context.clip();
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

/** An edge and its mirror image: around a body, or along an open surface. */
function strokeEdge({ context, layout, theme }: Drawing, edge: Edge, closed: boolean): void {
  context.beginPath();
  for (const sign of closed ? [1, -1] : [-1, 1]) {
    for (let k = 0; k < edge.x.length; ++k) {
      const n = sign > 0 ? k : edge.x.length - 1 - k;
      context.lineTo(layout.x + layout.scale * edge.x[n]!, layout.y + sign * layout.scale * edge.y[n]!);
    }
  }
  if (closed) context.closePath();
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
