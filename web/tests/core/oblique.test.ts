// An oblique impact in time ends as the collision rule says.
import { describe, expect, it } from 'vitest';
import { sizesOf } from '../../src/inputs/document';
import { motionOf } from '../../src/inputs/inputs';
import { type Place, placesIn } from '../../src/scene/oblique_film';
import { obliqueCases } from '../unit/cases';
import { ask } from './wasm';

const tolerance = 1e-2;
const all = obliqueCases.map((inputs, index) => [index, inputs] as const);

describe('an oblique collision', () => {
  it.each(all)('of case %i ends as its rule says', (_, inputs) => {
    const { encounter } = inputs;
    const motion = motionOf(inputs);
    const { quantities, cutoff } = ask('oblique', encounter, { ...motion, tolerance }).value;
    const { value: seen } = ask('obliqueCollision', encounter, { ...motion, cutoff });
    const { value, error } = quantities.tangential_after_si ?? quantities.tangential_after!;
    expect(Math.abs(seen.tangential.at(-1)! - value)).toBeLessThan(error! + 1e-9 * Math.abs(value));
    expect(seen.grips.length).toBe(seen.places.length * seen.time.length);
    expect(new Set(seen.grips).size).toBeGreaterThan(1);
    seen.time.forEach((time, k) => {
      const energies = [seen.translation, seen.across, seen.rotation, seen.second_rotation, seen.elastic, seen.friction_loss];
      expect(Math.abs(energies.reduce((sum, each) => sum + each[k]!, 0) - 1), `${time}`).toBeLessThan(5e-3);
    });
    expect(seen.velocity[0]).toBeCloseTo(motion.speed, 9);
    expect(seen.end).toBeGreaterThan(seen.begin);
    // They come in at the angle, and are drawn as if they only touched.
    const places = placesIn(seen, sizesOf(encounter), 1);
    const [[one, other], [there, that]] = [-2, -1]
      .map((share) => places(seen.begin + share * (seen.end - seen.begin))) as [Place[], Place[]];
    const way = (name: 'x' | 'y'): number => there![name] - one![name] - ((that?.[name] ?? 0) - (other?.[name] ?? 0));
    expect((180 / Math.PI) * Math.atan2(way('y'), way('x'))).toBeCloseTo(motion.angle, 6);
    expect(places(0.5 * (seen.begin + seen.end))[0]!.x).toBe(-1);
  });
});
