import { describe, expect, it } from 'vitest';
import type { Frame } from '../../src/core/protocol';
import { faceOf, seamOf } from '../../src/scene/bodies';
import { advance, coarseToFine, filmSpan, frameAt, insertFrame, LENGTH, REST } from '../../src/scene/film';
import { evenGrid, gradedPlaces, gridFor } from '../../src/scene/grid';
import { bodyPart, edgeOf, meshOf } from '../../src/scene/parts';
import { colorTable, contrast, pixelOf, shadeOf } from '../../src/scene/raster';
import { secondIsAtRest } from '../../src/scene/scene';
import { coveringStress, layoutOf, magnificationOf, stressUnit, unfoldedUpTo, viewOf } from '../../src/scene/view';
import { diskOf, field } from './disk_frame';

describe('grid', () => {
  it('grows from the contact and ends where it must', () => {
    const places = gradedPlaces(50, 1e-3);
    expect([places[0], places[50]]).toEqual([0, 1]);
    expect(places[1]).toBeCloseTo(1e-3, 6);
    for (let k = 2; k <= 50; ++k) expect(places[k]! - places[k - 1]!).toBeGreaterThan(places[k - 1]! - places[k - 2]!);
    expect(gradedPlaces(4, 1)).toEqual([0, 0.25, 0.5, 0.75, 1]);
  });
  it('is the upper half of a round body, and a line along a rod', () => {
    const grid = gridFor('disk', 0.05);
    expect([grid.radius[0], grid.radius[grid.radius.length - 1]]).toEqual([0, 1]);
    expect([grid.angle[0], grid.angle[grid.angle.length - 1]]).toEqual([0, Math.fround(Math.PI)]);
    expect(1 - grid.radius[grid.radius.length - 2]!).toBeLessThan(0.02);
    expect([...gridFor('rod', 1).angle]).toEqual([0, 1]);
  });
});

describe('schedule', () => {
  it('has every time once, the coarse ones first', () => {
    const levels = coarseToFine(-1, 3, 5, 3);
    expect(levels[0]).toEqual([-1, 0, 1, 2, 3]);
    const all = levels.flat().sort((a, b) => a - b);
    expect(all).toEqual(Array.from({ length: 17 }, (_, k) => -1 + k / 4));
  });
  it('begins before the contact and ends after it', () => {
    const { from, to } = filmSpan(0, 8);
    expect(from).toBeLessThan(0);
    expect(to).toBeGreaterThan(8);
  });
});

describe('film', () => {
  const frame = (time: number, value: number): Frame => ({
    time,
    bodies: [{ center: value, radial: Float32Array.of(value), tangential: Float32Array.of(0),
      vonMises: Float32Array.of(2 * value), fringes: Float32Array.of(0) }],
  });
  it('is in order whatever the order of its frames, and mixes neighbours', () => {
    const film: Frame[] = [];
    for (const time of [4, 0, 2]) insertFrame(film, frame(time, time));
    expect(film.map(({ time }) => time)).toEqual([0, 2, 4]);
    const middle = frameAt(film, 2.5)!;
    const body = middle.bodies[0]!;
    expect([body.center, body.radial[0], body.vonMises[0]]).toEqual([2.5, 2.5, 5]);
    expect(frameAt(film, -3)!.time).toBe(0);
    expect(frameAt(film, 9)!.time).toBe(4);
  });
  it('takes the place of a frame of the same time', () => {
    const film: Frame[] = [];
    insertFrame(film, frame(1, 1));
    insertFrame(film, frame(1, 5));
    expect(film.map(({ time }) => time)).toEqual([1]);
    expect(frameAt(film, 1)!.bodies[0]!.center).toBe(5);
  });
});

describe('a second body', () => {
  it('is at rest where nothing of it is computed', () => {
    const still = field(evenGrid('disk', 2, 2), () => 0, () => 0);
    const moved = field(evenGrid('disk', 2, 2), () => 1e-9, () => 0);
    expect(secondIsAtRest([{ time: 0, bodies: [moved, still] }])).toBe(true);
    expect(secondIsAtRest([{ time: 0, bodies: [still, still] }, { time: 1, bodies: [still, moved] }])).toBe(false);
    expect(secondIsAtRest([{ time: 0, bodies: [still] }])).toBe(false);
  });
});

describe('mesh', () => {
  const grid = evenGrid('disk', 4, 32);
  const disk = diskOf(grid);
  it('is round at rest, and touches x = 0', () => {
    const edge = edgeOf(disk, meshOf(disk, field(grid, () => 0, () => 0), 20));
    for (let k = 0; k < edge.x.length; ++k) expect(Math.hypot(edge.x[k]! + 1, edge.y[k]!)).toBeCloseTo(1, 6);
    expect(edge.x[0]).toBeCloseTo(0, 6);
  });
  it('magnifies movement and displacement alike: a face at the wall stays there', () => {
    const frame = { ...field(grid, () => -0.01, () => 0), center: -0.99 };
    for (const magnification of [1, 7]) expect(meshOf(disk, frame, magnification).x[4 * 33]).toBeCloseTo(0, 6);
    const other = bodyPart('disk', 1, -1, 0.1, grid);
    const far = meshOf(other, { ...field(grid, () => 0, () => 0), center: 1.02 }, 10);
    expect(far.x[0]).toBeCloseTo(1.2); // its centre
  });
  it('moves every point sideways by a rigid displacement', () => {
    const frame = field(grid, (_, a) => 0.1 * Math.cos(a), (_, a) => -0.1 * Math.sin(a));
    const [moved, still] = [meshOf(disk, frame, 1), meshOf(disk, field(grid, () => 0, () => 0), 1)];
    moved.x.forEach((each, k) => expect(each - still.x[k]!).toBeCloseTo(0.1, 6));
    moved.y.forEach((each, k) => expect(each - still.y[k]!).toBeCloseTo(0, 6));
  });
});

describe('magnification', () => {
  const grid = evenGrid('disk', 8, 64);
  const disk = diskOf(grid);
  it('stops where an even compression leaves too little area', () => {
    const limit = unfoldedUpTo(disk, field(grid, (r) => -0.1 * r, () => 0));
    expect((1 - 0.1 * limit) ** 2).toBeCloseTo(0.12, 3);
  });
  it('has no limit for a rigid displacement, nor an even expansion', () => {
    const rigid = field(grid, (_, a) => 0.1 * Math.cos(a), (_, a) => -0.1 * Math.sin(a));
    expect(unfoldedUpTo(disk, rigid)).toBeGreaterThan(200);
    expect(unfoldedUpTo(disk, field(grid, (r) => 0.1 * r, () => 0))).toBe(Infinity);
  });
  it('of a rod ends where points would change places', () => {
    const rod = gridFor('rod', 1);
    const limit = unfoldedUpTo(bodyPart('rod', 1, 1, 0.1, rod), field(rod, (r) => -0.02 * (1 - r), () => 0));
    expect(limit).toBeCloseTo(0.88 / 0.02, 2);
  });
  it('is a round number, and 1 for large deformations and bodies at rest', () => {
    const of = (size: number): number =>
      magnificationOf([{ time: 0, bodies: [field(grid, (r, a) => size * r * Math.cos(2 * a), () => 0)] }], [disk]);
    expect([of(0.001), of(0.2), of(0)]).toEqual([100, 1, 1]);
  });
});

describe('colours', () => {
  it('go through their stops', () => {
    const table = colorTable(['#000000', '#ff8000']);
    expect(table[0]).toBe(0xff000000);
    expect(table[255]).toBe(0xff0080ff);
  });
  it('of fringes repeat with every order and fade when they are too fine', () => {
    const shade = shadeOf('fringes', 0.1, true);
    expect(pixelOf(shade, 0.33)).toBe(pixelOf(shade, 0.13));
    expect(pixelOf(shade, 0.05)).not.toBe(pixelOf(shade, 0));
    expect(pixelOf(shade, 0.05, 0)).toBe(pixelOf(shade, 0, 0));
    expect([contrast(0), contrast(1), contrast(5)]).toEqual([1, 0, 0]);
    expect(contrast(0.5)).toBeCloseTo(2 / Math.PI);
  });
  it('of the stress end at the ends', () => {
    const shade = shadeOf('vonMises', 2, false);
    expect([pixelOf(shade, -1), pixelOf(shade, 9)]).toEqual([shade.table[0], shade.table[255]]);
  });
  it('have a scale that covers most of the area', () => {
    const grid = evenGrid('disk', 40, 40);
    const frame = field(grid, () => 0, () => 0); // its fringes are r: the area below r is r²
    expect(coveringStress(diskOf(grid), frame.fringes, 0.25)).toBeCloseTo(0.5, 1);
    expect(stressUnit('fringes', [{ time: 0, bodies: [frame] }], [diskOf(grid)])).toBeCloseTo(0.2);
    expect(stressUnit('vonMises', [{ time: 0, bodies: [frame] }], [diskOf(grid)])).toBe(1);
  });
});

describe('a hollow sphere', () => {
  it('has the wall that its grid stands for, with a face inside', () => {
    const part = bodyPart('hollow-sphere', 2, 1, 0.1, evenGrid('hollow-sphere', 4, 8), 0.75);
    const distances = (points: readonly number[]): number[] => points.map((k) => Math.hypot(part.x[k]! + 2, part.y[k]!));
    for (const each of distances(part.hole)) expect(each).toBeCloseTo(1.5, 6);
    for (const each of distances(part.edge)) expect(each).toBeCloseTo(2, 6);
    expect([part.hole.length, part.x.length]).toEqual([9, 45]);
    expect(bodyPart('sphere', 1, 1, 0.1, evenGrid('sphere', 4, 8)).hole).toEqual([]);
  });
  it('leaves the colours to what it meets, as it is drawn at rest', () => {
    const grid = evenGrid('disk', 40, 40);
    const [rest, block] = [{ ...field(grid, () => 0, () => 0) }, field(grid, () => 0, () => 0)];
    rest.fringes = new Float32Array(rest.fringes.length);
    const parts = [diskOf(grid), { ...diskOf(grid), open: true }];
    expect(stressUnit('fringes', [{ time: 0, bodies: [rest, block] }], parts)).toBeCloseTo(0.2);
  });
});

describe('interface of two bodies', () => {
  const y = [0, 0.1, 0.2, 0.3];
  it('is in the middle of equal ones, and where a plane is', () => {
    const [left, right] = [{ x: [0.02, 0.02, 0.01, -0.1], y }, { x: [-0.02, -0.02, -0.01, 0.1], y }];
    expect(Array.from(seamOf([left, right], [1, 1]).x, (each) => Math.abs(each))).toEqual([0, 0, 0, 0]);
    expect(seamOf([left, right], [1, 0]).x[0]).toBeCloseTo(-0.02);
    expect(seamOf([left, right], [0, 1]).x[0]).toBeCloseTo(0.02);
  });
  it('goes as far up as both faces', () => {
    expect(seamOf([{ x: [0, 0], y: [0, 0.15] }, { x: [0, 0, 0, 0], y }], [1, 1]).y).toEqual([0, 0.15]);
    expect(faceOf({ x: [0, 1, 2, 1], y: [0, 1, 2, 1.5] }).y).toEqual([0, 1, 2]);
  });
});

describe('clock', () => {
  it('lasts its length, rests at the end, and begins again', () => {
    let clock = { time: -1, rested: 0 };
    for (let k = 0; k < 10; ++k) clock = advance(clock, LENGTH / 10, 1, -1, 3);
    expect(clock.time).toBeCloseTo(3);
    clock = advance({ time: 3, rested: 0 }, 0.5 * REST, 1, -1, 3);
    expect(clock).toEqual({ time: 3, rested: 0.5 * REST });
    expect(advance(clock, REST, 1, -1, 3)).toEqual({ time: -1, rested: 0 });
  });
});

describe('layout', () => {
  it('shows a half-space as deep as it is pressed in', () => {
    const grid = evenGrid('disk');
    const disk = diskOf(grid);
    const at = (center: number): Frame =>
      ({ time: 0, bodies: [{ ...field(grid, () => 0, () => 0), center }] });
    const deepest = (center: number): number =>
      Math.max(...Array.from(edgeOf(disk, meshOf(disk, at(center).bodies[0]!, 2)).x));
    const right = (center: number): number => viewOf([at(-1.5), at(center)], [disk], 2, 'half-space').right;
    expect(right(-1)).toBe(0.9);
    expect(deepest(-0.4)).toBeGreaterThan(0.9);
    expect(right(-0.4)).toBeGreaterThan(deepest(-0.4));
  });
  it('fits wide and narrow, with the line of impact on whole pixels', () => {
    const view = { left: -2.4, right: 0.3, half: 1.1 };
    for (const width of [300, 900]) {
      const layout = layoutOf(view, width, 2);
      expect(layout.x + layout.scale * view.left).toBeGreaterThanOrEqual(0);
      expect(layout.x + layout.scale * view.right).toBeLessThanOrEqual(width);
      expect((layout.y * 2) % 1).toBe(0);
    }
  });
});
