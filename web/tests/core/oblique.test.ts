// The collision rule of the page's core is that of the native command; the impact in time ends as the rule says.
import { describe, expect, it } from 'vitest';
import type { AnglePoint } from '../../src/core/protocol';
import { meetingOf, sizesOf } from '../../src/inputs/document';
import { motionOf } from '../../src/inputs/inputs';
import { type Place, placesIn } from '../../src/scene/oblique_film';
import { obliqueCases } from '../unit/cases';
import { hasCommand, oblique } from './native';
import { ask } from './wasm';

const tolerance = 1e-2;
const all = obliqueCases.map((inputs, index) => [index, inputs] as const);

describe('the collision rule', { timeout: 60_000 }, () => {
  it.skipIf(!hasCommand).each(all)('of case %i is that of the command', (_, inputs) => {
    const row = oblique(inputs, tolerance);
    const { value } = ask('oblique', inputs.encounter, { ...motionOf(inputs), tolerance });
    expect(value.converged).toBe(row.converged);
    const names = ['restitution', 'tangential_restitution', 'sliding', 'sliding_after', 'tangential_after',
      'spin_after', 'second_spin_after', 'friction_loss', 'vibration', 'contact_time', 'cutoff'];
    if (meetingOf(inputs.encounter).si) names.push('tangential_after_si', 'spin_after_si');
    for (const name of names) {
      const [ours, theirs] = [value.quantities[name]!, row[name] as number];
      // Sums of vectors of another length round differently.
      expect(Math.abs(ours.value - theirs), name).toBeLessThanOrEqual(1e-12 * Math.max(1, Math.abs(theirs)));
      const error = row[`${name.replace(/_si$/, '')}_error${name.endsWith('_si') ? '_si' : ''}`];
      if (typeof error !== 'number') continue;
      expect(Math.abs(ours.error! - error), name).toBeLessThanOrEqual(1e-10 * (1 + error));
    }
  });

  it('of many angles has that of each', () => {
    const inputs = obliqueCases[2]!;
    const angles = [70, 20];
    const { all: points } = ask('obliqueAngles', inputs.encounter, { ...motionOf(inputs), angles, tolerance });
    (points as AnglePoint[]).forEach(({ angle, restitution, tangential, tangentialError }, k) => {
      expect(angle).toBe(angles[k]);
      const { quantities } = ask('oblique', inputs.encounter, { ...motionOf(inputs), angle, tolerance }).value;
      expect(restitution).toBe(quantities.restitution!.value);
      expect(Math.abs(tangential - quantities.tangential_restitution!.value)).toBeLessThan(tangentialError);
    });
  });
});

describe('an oblique collision', { timeout: 60_000 }, () => {
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
