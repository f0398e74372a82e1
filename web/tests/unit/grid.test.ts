import { describe, expect, it } from 'vitest';
import { DEEP, gradedPlaces, gridBelow, gridFor, isShownThrough } from '../../src/scene/grid';

describe('the grid of a film', () => {
  it('is as deep as a plate is thick', () => {
    for (const thickness of [1e-3, 0.01, 0.3, 5]) {
      for (const width of [1e-5, 0.05, 0.5]) {
        const { depth } = gridBelow(width, thickness);
        expect(depth.at(-1)).toBeCloseTo(isShownThrough(thickness) ? thickness : DEEP, 6);
        depth.forEach((place, index) => expect(place).toBeGreaterThan(depth[index - 1] ?? -1));
      }
    }
  });
  it('lies within the body, whatever the width of the contact', () => {
    for (let width = 1e-7; width < 2; width *= 1.01) {
      const { radius, angle } = gridFor('disk', width);
      expect(Math.min(...radius)).toBe(0);
      expect(Math.max(...radius)).toBe(1);
      expect(Math.max(...angle)).toBe(Math.fround(Math.PI));
    }
  });
  it('has ascending places that end at 1', () => {
    const places = gradedPlaces(44, 0.003);
    places.forEach((place, index) => expect(place).toBeGreaterThan(places[index - 1] ?? -1));
    expect(places.at(-1)).toBe(1);
  });
});
