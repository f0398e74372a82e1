// A half-space in the film: its mesh, and how much of its displacement a picture can magnify.
import { describe, expect, it } from 'vitest';
import type { BodyFrame, Frame } from '../../src/core/protocol';
import { frameAt } from '../../src/scene/film';
import { evenGrid, gridBelow } from '../../src/scene/grid';
import { blockPart, edgeOf, meshOf } from '../../src/scene/parts';
import { magnificationOf, unfoldedUpTo, viewOf } from '../../src/scene/view';
import { diskOf, field } from './disk_frame';

const below = gridBelow(0.05);
const part = blockPart(below);

/** The displacement of a half-space by functions of the depth and the distance. */
function block(radial: (z: number, r: number) => number, tangential: (z: number, r: number) => number): BodyFrame {
  const all = (value: (z: number, r: number) => number): Float32Array =>
    Float32Array.from([...below.depth].flatMap((z) => [...below.distance].map((r) => value(z, r))));
  const none = all(() => 0);
  return { center: 0, radial: all(radial), tangential: all(tangential), vonMises: none, fringes: none };
}

/** The dent under a ball, about as wide as its contact. */
const dent = (size: number): BodyFrame => block((z, r) => (size * 0.05) / Math.hypot(z + 0.05, r), () => 0);

describe('a plate', () => {
  const under = gridBelow(0.05, 0.5);
  const plate = blockPart(under, true);
  const bent = under.depth.length * under.distance.length;
  const frame = (deepest: number): BodyFrame => {
    const radial = new Float32Array(bent).fill(deepest);
    const none = new Float32Array(bent);
    return { center: 0, radial, tangential: none, vonMises: none, fringes: none };
  };
  it('has a lower face at its thickness, which bends with it', () => {
    const lower = edgeOf({ edge: plate.lower }, meshOf(plate, frame(0.01), 10));
    expect(lower.x.length).toBe(under.distance.length);
    lower.x.forEach((each) => expect(each).toBeCloseTo(0.6, 6));
    expect(part.lower).toEqual([]);
  });
  it('is shown to its lower face, and as far as waves run away', () => {
    const grid = evenGrid('disk', 2, 8);
    const still = field(grid, () => 0, () => 0);
    const frames: Frame[] = [0, 0.02].map((deepest) => ({ time: deepest, bodies: [still, frame(deepest)] }));
    const { right, half } = viewOf(frames, [diskOf(grid), plate], 10, 'plate');
    expect(right).toBeCloseTo(0.5 + 0.2 + 0.08, 5);
    expect(half).toBeGreaterThan(3.5);
    expect(half).toBeLessThanOrEqual(under.distance.at(-1)!);
  });
  it('is a half-space in the picture where it is thick', () => {
    const { depth, distance } = gridBelow(0.05, 3);
    expect([depth, distance]).toEqual([below.depth, below.distance]);
  });
});

describe('a half-space', () => {
  it('has its points where it is struck, and goes on beyond the picture', () => {
    for (const places of [below.depth, below.distance]) {
      expect(places[0]).toBe(0);
      expect(places[1]).toBeCloseTo(0.01, 4);
    }
    expect([below.depth.at(-1), below.distance.at(-1)]).toEqual([Math.fround(0.9), Math.fround(1.7)]);
  });
  it('has its surface at x = 0, and moves into x > 0 and away from the axis', () => {
    const still = edgeOf(part, meshOf(part, block(() => 0, () => 0), 10));
    expect(Math.max(...Array.from(still.x))).toBe(0);
    const moved = edgeOf(part, meshOf(part, block(() => 0.01, () => 0.02), 10));
    Array.from(moved.x).forEach((each) => expect(each).toBeCloseTo(0.1, 6));
    Array.from(moved.y).forEach((each, k) => expect(each - below.distance[k]!).toBeCloseTo(0.2, 6));
  });
  it('is magnified as far as it does not fold: a dent does not become a spike', () => {
    expect(unfoldedUpTo(part, block((z) => -0.01 * (z - 1), () => 0))).toBeCloseTo(0.88 / 0.01, 2);
    const limit = unfoldedUpTo(part, dent(1e-3));
    expect(limit).toBeLessThan(60);
    const grid = evenGrid('disk', 2, 8);
    const still = field(grid, () => 0, () => 0);
    const frame: Frame = { time: 0, bodies: [still, dent(1e-3)] };
    expect(magnificationOf([{ time: 0, bodies: [still] }], [diskOf(grid)])).toBe(1); // of the body alone, at rest
    expect(magnificationOf([frame], [diskOf(grid), part])).toBe(50);
  });
  it('is between two frames both of them', () => {
    const at = (time: number): Frame => ({ time, bodies: [block(() => time, () => 2 * time)] });
    const between = frameAt([at(0), at(4)], 1)!.bodies[0]!;
    expect([between.radial[3], between.tangential[3]]).toEqual([1, 2]);
  });
});
