import type { BodyFrame, Grid } from '../../src/core/protocol';
import { bodyPart, type Part } from '../../src/scene/parts';

/** A disk before a wall. */
export const diskOf = (grid: Grid): Part => bodyPart('disk', 1, 1, 0.1, grid);

type At = (r: number, a: number) => number;

/** A frame of a body by the displacement of its points; its fringes are their distance from the centre. */
export function field(grid: Grid, radial: At, tangential: At): BodyFrame {
  const all = (value: At): Float32Array =>
    Float32Array.from([...grid.radius].flatMap((r) => [...grid.angle].map((a) => value(r, a))));
  const [vonMises, fringes] = [all(() => 0), all((r) => r)];
  return { center: -1, radial: all(radial), tangential: all(tangential), vonMises, fringes };
}
