// What the page predicts of real balls is what the native command predicts.
import { describe, expect, it } from 'vitest';
import { thresholdsOf } from '../../src/core/local';
import type { Encounter } from '../../src/core/protocol';
import { type Body, type Choice, encounterOf } from '../../src/inputs/document';
import * as all from '../unit/cases';
import { hasCommand, prediction } from './native';
import { ask } from './wasm';

const made = (name: string, radius: number): Body => ({ ...all.made(name, radius), thickness: 0.01 });
const steel = made('bearing steel', 0.005);
const at = (against: Choice['against'], first = steel, second = made('glass', 0.01)): Encounter =>
  encounterOf({ kind: 'sphere', si: true, plane: 'stress', against }, first, second);
const [ball, glass] = [at('wall'), at('wall', made('glass', 0.002))];
const cases: [Encounter, number][] = [
  [ball, 1], [ball, 0.01], [at('same'), 0.5], [at('body', steel, made('brass', 0.01)), 1], [at('half-space'), 2],
  [at('plate'), 1], [at('plate', made('glass', 0.002)), 0.2], [at('wall', made('ice', 1e-6)), 1e-3],
  [at('wall', { ...steel, loss_time: 0 }), 1],
  [at('half-space', made('tungsten carbide', 0.005), made('granite', 1)), 1],
  [at('half-space', steel, { ...made('glass', 1), young: 6.5e10 }), 1],
];

/** How far numbers may be apart: a motion in steps that follow its error is known to 10⁻⁹. */
const same = 1e-9;

describe.skipIf(!hasCommand)('a prediction', { timeout: 60_000 }, () => {
  it.each(cases.map((each, index) => [index, ...each] as const))('of case %i is that of the command',
    (_, encounter, speed) => {
      const row = prediction(encounter, speed, 1e-2);
      const [ours] = ask('prediction', encounter, { speeds: [speed], tolerance: 1e-2, constants: true }).all;
      const close = (value: number, theirs: unknown, name: string): void => {
        expect(typeof theirs, name).toBe('number');
        const size = Math.max(1, Math.abs(theirs as number));
        expect(Math.abs(value - (theirs as number)), name).toBeLessThanOrEqual(same * size);
      };
      for (const [name, { value }] of Object.entries(ours!.quantities)) {
        if (Number.isFinite(value)) close(value, row[name], name);
        else expect(typeof row[name], name).not.toBe('number'); // JSON has no infinite number
      }
      expect(Object.keys(ours!.quantities)).toEqual(expect.arrayContaining(
        ['restitution', 'by_models', 'by_constants', 'models_low', 'models_high', 'restitution_without_models']));
      for (const { name, share } of ours!.channels) close(share, row[name], name);
      expect(ours!.channels.map(({ name, model }) => [name, model])).toEqual(
        [['ringing', false], ['radiation', false], ['material', false], ['yield', true], ['adhesion', true]]);
      expect(ours!.dominant).toBe(row.dominant);
      expect(ours!.warnings).toEqual(row.warnings);
      expect(ours!.influences.map(({ constant }) => constant)).toEqual(row.influences.map(({ constant }) => constant));
      ours!.influences.forEach(({ change }, k) => close(change, row.influences[k]!.change, 'change'));
    });
});

describe('a prediction', () => {
  it('at many speeds is that at each, and needs no influences', () => {
    const given = { tolerance: 1e-2, constants: false };
    const points = ask('prediction', ball, { speeds: [1, 0.05], ...given }).all;
    expect(points.map(({ speed }) => speed)).toEqual([1, 0.05]);
    for (const point of points) {
      const [whole] = ask('prediction', ball, { speeds: [point.speed], tolerance: 1e-2, constants: true }).all;
      expect(point.quantities.restitution).toEqual(whole!.quantities.restitution);
      const names = (of: typeof point): string[] => of.influences.map(({ constant }) => constant);
      expect(names(whole!)).toEqual(expect.arrayContaining(['young', 'poisson', 'density', 'yield_strength']));
      expect(names(point)).toEqual([]);
    }
  });
  it('is there where the core knows thresholds, and only there', () => {
    expect(thresholdsOf(ball)!.yield!).toBeGreaterThan(0.1);
    expect(thresholdsOf(ball)!.yield!).toBeLessThan(0.2);
    expect(thresholdsOf(glass)!.yield).toBeUndefined();
    const given = { speeds: [0.1], tolerance: 1e-2, constants: false };
    const others = [{ si: false }, { kind: 'disk' }, { kind: 'rod' }] as const;
    for (const encounter of others.map((other) => all.like(ball, other))) {
      expect(thresholdsOf(encounter)).toBeUndefined();
      expect(() => ask('prediction', encounter, given)).toThrow(/^material: missing|allowed/);
    }
  });
});
