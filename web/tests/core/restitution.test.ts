// ε of the page's core, and all that comes with it, are those of the native command.
import { describe, expect, it } from 'vitest';
import type { Encounter } from '../../src/core/protocol';
import { unitBody } from '../../src/inputs/document';
import { curveSpeeds } from '../../src/inputs/units';
import { cases, like, made } from '../unit/cases';
import { hasCommand, restitution } from './native';
import { ask } from './wasm';

const one = cases[0]!.encounter;
const ball = cases[4]!.encounter;
const more: [Encounter, number, number][] = [
  [one, 0.01, 1e-3], [one, 0.3, 1e-3], [one, 1e-5, 1e-2],
  [like(one, { first: { ...unitBody, poisson: 0.9 } }), 0.3, 1e-3],
  [ball, 0.1, 1e-3], [ball, 1e-6, 1e-2], [like(ball, { against: 'same' }), 0.05, 1e-3],
  [like(ball, { against: 'half-space', second: { ...unitBody, poisson: 0.3 } }), 0.1, 1e-2],
];
const all = [...cases.map(({ encounter, speed }) => [encounter, speed, 1e-2] as const), ...more];

/** How far numbers may be apart: sums of vectors of another length round differently. */
const same = 1e-12;

/** The same of an error, in units of its value: a multiple, often of more than ten, of a difference of such numbers. */
const sameError = 1e-10;

/** The same of shares of energy, which are differences from 1. */
const rounding = 1e-14;
const shares = ['lost_fraction', 'lost_to_first', 'lost_to_second', 'dissipated'];

describe.skipIf(!hasCommand)('restitution', { timeout: 60_000 }, () => {
  it.each(all.map((each, index) => [index, ...each] as const))('of case %i is that of the command',
    (_, encounter, speed, tolerance) => {
      const row = restitution(encounter, speed, tolerance);
      const ours = ask('restitution', encounter, { speed, tolerance }).value;
      expect(ours.converged).toBe(row.converged);
      let compared = 0;
      for (const [name, { value, error }] of Object.entries(ours.quantities)) {
        if (name === 'energy_error' || name === 'runs') continue; // all of the one is rounding; the other is a list
        const theirs = row[name] as number;
        expect(typeof theirs, name).toBe('number');
        const least = shares.includes(name) ? rounding : 0;
        expect(Math.abs(value - theirs), name).toBeLessThanOrEqual(same * Math.abs(theirs) + least);
        if (typeof row[`${name}_error`] === 'number') {
          expect(Math.abs(error! - (row[`${name}_error`] as number)), `${name}_error`)
            .toBeLessThanOrEqual(sameError * Math.abs(theirs) + 10 * least);
        }
        ++compared;
      }
      expect(compared).toBeGreaterThan(10);
    });

  it('has the yield speed of the command, where a strength is known', () => {
    const steel = like(ball, { si: true, first: made('bearing steel', 0.005) });
    const met = made('brass', 0.002);
    for (const [encounter, known] of [
      [steel, true], [like(steel, { against: 'same' }), true],
      [like(steel, { against: 'body', second: met }), true],
      [like(steel, { against: 'half-space', second: made('glass', 1) }), true],
      [like(steel, { first: made('glass', 0.005), against: 'half-space', second: met }), true],
      [like(steel, { first: made('glass', 0.005) }), false], [like(steel, { kind: 'disk' }), false],
    ] as [Encounter, boolean][]) {
      const { yieldSpeed } = ask('restitution', encounter, { speed: 0.1, tolerance: 1e-2 }).value;
      const theirs = restitution(encounter, 0.1, 1e-2).yield_speed_si as number | undefined;
      expect([yieldSpeed !== undefined, theirs !== undefined]).toEqual([known, known]);
      if (known) expect(Math.abs(yieldSpeed! / theirs! - 1)).toBeLessThan(1e-12);
      const { yieldWarning } = ask('restitution', encounter, { speed: 0.1, tolerance: 1e-2 }).value;
      if (!known || yieldSpeed! > 0.1) expect(yieldWarning).toBeUndefined();
      else expect(yieldWarning).toMatch(/^the (ball|block|other ball) yields above .* times that\): the real rebound is/);
    }
  });

  it('says what the command warns of the loss and the soundness of materials', () => {
    const granite = like(ball, { si: true, first: made('granite', 1), against: 'same' });
    const { materialWarnings } = ask('restitution', granite, { speed: 0.1, tolerance: 1e-2 }).value;
    expect(materialWarnings).toHaveLength(2);
    expect(materialWarnings![0]).toMatch(/^the loss of granite is 149 times too small at 0\.1 m\/s: /);
    expect(materialWarnings![1]).toMatch(/^granite is taken as sound/);
  });

  it('is there up to the end of a curve, at a soft half-space too', () => {
    for (const kind of ['disk', 'sphere'] as const) {
      const soft = like(one, { kind, against: 'half-space', second: { ...unitBody, young: 0.02 } });
      const speeds = [Math.max(...curveSpeeds(soft))];
      expect(ask('curve', soft, { speeds, tolerance: 1e-2 }).all[0]!.restitution).toBeGreaterThan(0);
      expect(() => ask('curve', soft, { speeds: [0.5], tolerance: 1e-2 })).toThrow('at so soft a body');
    }
  });

  it('at many speeds is that at each', () => {
    const speeds = [0.2, 0.01, 0.05];
    const points = ask('curve', one, { speeds, tolerance: 1e-3 }).all;
    expect(points.map((point) => point.speed)).toEqual(speeds);
    for (const point of points) {
      const alone = ask('restitution', one, { speed: point.speed, tolerance: 1e-3 }).value;
      expect(point.restitution).toBe(alone.quantities.restitution!.value);
      expect(point.error).toBe(alone.quantities.restitution!.error);
      expect(point.converged).toBe(true);
    }
  });
});

describe('what is wrong', () => {
  it.each([
    [like(one, { first: { ...unitBody, poisson: 7 } }), 0.1, 'poisson: got 7'],
    [one, 2, 'speed: got 2, allowed 1e-08 to 1 c'],
    [one, Number.NaN, 'speed: got nan'],
    [like(one, { against: 'body', second: { ...unitBody, radius: -1 } }), 0.1, 'against radius: got -1'],
    [{ first: { kind: 'rod' }, against: 'half-space' } as Encounter, 0.1, 'against: got half-space'],
  ] as [Encounter, number, string][])('is refused with one line: case %#', (encounter, speed, line) => {
    expect(() => ask('restitution', encounter, { speed, tolerance: 1e-2 })).toThrow(line);
  });
  it('leaves the core as it was', () => {
    expect((ask('restitution', one, { speed: 0.1, tolerance: 1e-2 }).value).converged).toBe(true);
  });
});
