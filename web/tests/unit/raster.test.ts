import { describe, expect, it } from 'vitest';
import { paintMesh, paintTriangle, type Pixels, shadeOf } from '../../src/scene/raster';
import { evenGrid } from '../../src/scene/grid';
import { meshOf } from '../../src/scene/parts';
import { diskOf, field } from './disk_frame';

describe('raster', () => {
  const blank = (): Pixels => ({ width: 40, height: 30, data: new Uint32Array(1200) });
  const shade = { ...shadeOf('vonMises', 1, false), table: Uint32Array.from({ length: 256 }, (_, k) => k + 1) };
  it('paints each pixel of two triangles with a common side once, and none outside', () => {
    const [one, two, both] = [blank(), blank(), blank()];
    type Point = readonly [number, number];
    const corners: Point[] = [[3.2, 2.1], [33.7, 4.9], [29.3, 26.4], [5.5, 21.7]];
    const paint = (to: Pixels, ...k: [number, number, number]): void => {
      const [a, b, c] = k.map((n) => corners[n]!) as [Point, Point, Point];
      paintTriangle(to, a[0], a[1], 0.5, b[0], b[1], 0.5, c[0], c[1], 0.5, shade);
    };
    paint(one, 0, 1, 2);
    paint(two, 0, 2, 3);
    paint(both, 2, 0, 1);
    const painted = (each: Pixels): number => each.data.filter((pixel) => pixel > 0).length;
    expect(painted(both)).toBe(painted(one));
    one.data.forEach((pixel, k) => expect(pixel > 0 && two.data[k]! > 0).toBe(false));
    const area = 0.5 * Math.abs((33.7 - 3.2) * (26.4 - 2.1) - (29.3 - 3.2) * (4.9 - 2.1));
    expect(Math.abs(painted(one) - area)).toBeLessThan(12);
  });
  it('interpolates stress linearly', () => {
    const pixels = blank();
    paintTriangle(pixels, 0, 0, 0, 40, 0, 1, 0, 30, 0, shade);
    expect(pixels.data[20]).toBe(Math.floor((20.5 / 40) * 256) + 1);
    expect(pixels.data[5 * 40 + 8]).toBe(Math.floor((8.5 / 40) * 256) + 1);
  });
  it('stays inside the picture', () => {
    const pixels = blank();
    paintTriangle(pixels, -50, -50, 0, 90, -50, 1, 20, 90, 0, shade);
    expect(pixels.data.every((each) => each > 0)).toBe(true);
  });
  it('covers half a disk without holes', () => {
    const grid = evenGrid('disk', 10, 60);
    const pixels = blank();
    paintMesh(pixels, meshOf(diskOf(grid), field(grid, () => 0, () => 0), 1), field(grid, () => 0, () => 0).fringes,
      { origin: 35, scale: 15 }, shade);
    for (let row = 0; row < 30; ++row) {
      for (let k = 0; k < 40; ++k) {
        const distance = Math.hypot(k + 0.5 - 20, row + 0.5) / 15;
        if (distance < 0.98) expect(pixels.data[row * 40 + k]).toBeGreaterThan(0);
        if (distance > 1.001) expect(pixels.data[row * 40 + k]).toBe(0);
      }
    }
  });
});
