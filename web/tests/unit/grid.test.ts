import { describe, expect, it } from 'vitest';
import { gradedPlaces, gridFor } from '../../src/scene/grid';

describe('the grid of a film', () => {
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
