// What is seen of a collision: bodies and half-spaces alike as meshes in the plane of the picture, of the half above
// the line of impact, which the other mirrors. Places are in radii of the first body, y ≥ 0.

import { range } from 'd3-array';
import type { BodyFrame, Encounter, Grid } from '../core/protocol';
import { type Side, meetingOf } from '../inputs/document';
import { type BodyKind, isBlock } from '../inputs/kinds';
import { isShownThrough } from './grid';

/** One of what meets. Its points stand in rows and columns, row-major, as the numbers of frames do. */
export interface Part {
  rows: number;
  columns: number;
  /** at rest, where it would first touch */
  x: Float32Array;
  y: Float32Array;
  /** displacement in the picture of a radial and of a tangential one */
  radial: { x: Float32Array; y: Float32Array };
  tangential: { x: Float32Array; y: Float32Array };
  /** what is between four neighbours of them */
  cells: Cell[];
  /** place of its centre there, and its radius or length */
  center: number;
  size: number;
  /** points of its edge, from the line of impact where it is struck */
  edge: number[];
  /** 1/R of its face at rest */
  curvature: number;
  /** a half-space or a plate goes on beyond the picture */
  open: boolean;
  /** points of the lower face of a plate, from the line of impact; empty where none is seen */
  lower: number[];
  /** those of the hole of a hollow sphere, from the line of impact where it is struck; empty without one */
  hole: number[];
}

type Point = Record<'x' | 'y', number>;

export interface Cell {
  corners: [number, number, number, number];
  /** sides from its first corner, of its mean parallelogram, and the area between them, with a sign */
  sides: [Point, Point];
  area: number;
}

export interface Line {
  x: ArrayLike<number>;
  y: ArrayLike<number>;
}

/** A part at one instant. */
export type Mesh = Pick<Part, 'rows' | 'columns' | 'x' | 'y'>;

/** @param at what is at a row and a column */
function partOf(
  rows: ArrayLike<number>, columns: ArrayLike<number>,
  at: (row: number, column: number) => { rest: Point; radial: Point; tangential: Point },
  more: Pick<Part, 'center' | 'size' | 'edge' | 'curvature' | 'open'> & Partial<Pick<Part, 'lower' | 'hole'>>,
): Part {
  const points = Array.from(rows).flatMap((row) => Array.from(columns, (column) => at(row, column)));
  const of = (name: 'rest' | 'radial' | 'tangential'): { x: Float32Array; y: Float32Array } =>
    ({ x: Float32Array.from(points, (each) => each[name].x), y: Float32Array.from(points, (each) => each[name].y) });
  const rest = of('rest');
  const [count, step] = [rows.length, columns.length];
  const cells = range(count - 1).flatMap((i) => range(i * step, (i + 1) * step - 1)).map((k): Cell => {
    const corners: Cell['corners'] = [k, k + 1, k + step, k + step + 1];
    const sides = sidesOf(rest, corners);
    return { corners, sides, area: cross(...sides) };
  });
  return {
    rows: count, columns: step, ...rest, radial: of('radial'), tangential: of('tangential'), cells, lower: [], hole: [], ...more,
  };
}

const nowhere: Point = { x: 0, y: 0 };

/** A disk, a sphere or a rod. @param facing 1: what it meets is to the right; −1: to the left
 *  @param size radius, or length @param halfHeight of a rod @param inner radius of a hole, in its own: the grid is that of
 *  the wall, which the core computes at rest */
export function bodyPart(
  kind: BodyKind, size: number, facing: 1 | -1, halfHeight: number, grid: Grid, inner = 0,
): Part {
  const [rows, columns] = [grid.radius.length, grid.angle.length];
  if (kind === 'rod') {
    return partOf(grid.radius, grid.angle, (place, side) => ({
      rest: { x: -facing * size * place, y: halfHeight * side },
      radial: { x: facing * size, y: 0 }, tangential: nowhere,
    }), {
      center: -facing * 0.5 * size, size, edge: [0, columns - 1, columns * rows - 1, columns * (rows - 1)],
      curvature: 0, open: false,
    });
  }
  return partOf(grid.radius, grid.angle, (depth, angle) => {
    const r = inner + (1 - inner) * depth;
    const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
    return {
      rest: { x: facing * size * (r * cosine - 1), y: size * r * sine },
      radial: { x: facing * size * cosine, y: size * sine },
      tangential: { x: -facing * size * sine, y: size * cosine },
    };
  }, {
    center: -facing * size, size, edge: range((rows - 1) * columns, rows * columns), curvature: 1 / size, open: false,
    hole: inner > 0 ? range(columns) : [],
  });
}

/** A half-space or a half-plane on the right: depths × distances; with a lower face a plate or a strip. */
export function blockPart({ depth, distance }: NonNullable<Grid['below']>, lower = false): Part {
  const last = (depth.length - 1) * distance.length;
  return partOf(depth, distance, (x, y) => ({ rest: { x, y }, radial: { x: 1, y: 0 }, tangential: { x: 0, y: 1 } }), {
    center: 0, size: Infinity, edge: range(distance.length), curvature: 0, open: true,
    lower: lower ? range(last, last + distance.length) : [],
  });
}

const ROD = 0.1; // half the thickness of the first rod, in its lengths

/** Radius of its hole over its own. */
const innerOf = ({ fields, body }: Side): number => (fields.includes('inner') ? body.inner : 0);

/** What meets, of some sizes. @param thickness of a plate, in the radii of the grid */
export function partsOf(
  encounter: Encounter, sizes: number[], grid: Grid, thickness = Infinity,
): Part[] {
  const { kind, against, first, second = first } = meetingOf(encounter);
  const thick = Math.min(0.4, Math.max(0.03, ROD * Math.sqrt(second.body.area / (second.si ? first.body.area : 1))));
  return sizes.map((size, n) => (n === 1 && isBlock(against) ? blockPart(grid.below!, isShownThrough(thickness))
    : bodyPart(kind, size, n === 0 ? 1 : -1, n === 0 ? ROD : thick, grid, innerOf(n === 0 ? first : second))));
}

/** How the points of a part are displaced, apart from its movement as a whole. */
export function displacementOf({ rows, columns, radial, tangential }: Part, now: BodyFrame): Mesh {
  const of = (along: 'x' | 'y'): Float32Array => now.radial.map((out, k) =>
    out * radial[along][k]! + now.tangential[k]! * tangential[along][k]!);
  return { rows, columns, x: of('x'), y: of('y') };
}

/** Where they are when all movement from where the part touches is magnified. */
export function meshOf(part: Part, now: BodyFrame, magnification: number): Mesh {
  const { x, y, ...mesh } = displacementOf(part, now);
  const shift = now.center - part.center;
  return {
    ...mesh, x: x.map((each, k) => part.x[k]! + magnification * (shift + each)),
    y: y.map((each, k) => part.y[k]! + magnification * each),
  };
}

/** The edge of a part, or some other line of its points: as it is, or at rest in some place. */
export function edgeOf({ edge }: Pick<Part, 'edge'>, { x, y }: Line, shift = 0): { x: number[]; y: number[] } {
  return { x: edge.map((k) => x[k]! + shift), y: edge.map((k) => y[k]!) };
}

/** The sides of a cell of a mesh, or of displacements. */
export function sidesOf({ x, y }: Line, [a, b, c, d]: Cell['corners']): [Point, Point] {
  return [
    { x: 0.5 * (x[c]! + x[d]! - x[a]! - x[b]!), y: 0.5 * (y[c]! + y[d]! - y[a]! - y[b]!) },
    { x: 0.5 * (x[b]! + x[d]! - x[a]! - x[c]!), y: 0.5 * (y[b]! + y[d]! - y[a]! - y[c]!) },
  ];
}

/** The area between two sides. */
export function cross(one: Point, other: Point): number {
  return one.x * other.y - one.y * other.x;
}
