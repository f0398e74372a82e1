// Every number of an answer of the page's core is that of the native command, with its error.
import { describe, expect, it } from 'vitest';
import { thresholdsOf } from '../../src/core/local';
import type { AnglePoint, Encounter, Quantity, Restitution } from '../../src/core/protocol';
import { type Body, type Choice, encounterOf, unitBody } from '../../src/inputs/document';
import { motionOf } from '../../src/inputs/inputs';
import { encounterArguments } from '../../src/inputs/lines';
import { barSpeed, curveSpeeds } from '../../src/inputs/units';
import { cases, like, made, obliqueCases } from '../unit/cases';
import { type Row, hasCommand, oblique, prediction, restitution, run } from './native';
import { ask } from './wasm';

const one = cases[0]!.encounter;
const ball = cases[4]!.encounter;
const tolerance = 1e-2;

/** Differences from 1 of energies, which are known to some rounding errors. */
const shares = ['lost_fraction', 'lost_to_first', 'lost_to_second', 'dissipated'];

/** How many numbers are those of the command, to `same` of their size and `least`: sums of vectors of another length round
 *  differently. An error, often of a difference of such numbers, is known to a hundred times that. */
function compare(ours: Restitution['quantities'], row: Row, same: number, least: number): number {
  let count = 0;
  for (const [name, { value, error, help }] of Object.entries(ours) as [string, Quantity][]) {
    const theirs = row[name];
    // One is all rounding; one a list; and one by that name the coefficient that was given.
    if (['energy_error', 'runs', 'friction'].includes(name) || typeof theirs !== 'number') continue;
    const floor = Math.max(least, shares.includes(name) ? 1e-14 : 0);
    expect(Math.abs(value - theirs), name).toBeLessThanOrEqual(same * Math.abs(theirs) + floor);
    expect(help.length, name).toBeGreaterThan(10);
    const [, stem, si = ''] = /^(.*?)(_si)?$/.exec(name)!;
    const known = row[`${stem}_error${si}`];
    if (typeof known === 'number') {
      expect(Math.abs(error! - known), `error of ${name}`).toBeLessThanOrEqual(100 * (same * Math.abs(theirs) + floor));
    }
    ++count;
  }
  return count;
}

const steel = made('bearing steel', 0.005);
const at = (against: Choice['against'], first = steel, second: Body = made('glass', 0.01)): Encounter =>
  encounterOf({ kind: 'sphere', si: true, plane: 'stress', against }, first, { ...second, thickness: 0.01 });

describe.skipIf(!hasCommand)('an answer', () => {
  const more: [Encounter, number, number][] = [
    [one, 0.01, 1e-3], [one, 0.3, 1e-3], [one, 1e-5, 1e-2], [like(one, { first: { ...unitBody, poisson: 0.9 } }), 0.3, 1e-3],
    [ball, 0.1, 1e-3], [ball, 1e-6, 1e-2], [like(ball, { against: 'same' }), 0.05, 1e-3],
    [like(ball, { against: 'half-space', second: { ...unitBody, poisson: 0.3 } }), 0.1, 1e-2],
    [at('body', steel, made('brass', 0.002)), 0.3, 1e-2], [at('wall', made('glass', 0.005)), 0.1, 1e-2],
  ];
  const all = [...cases.map(({ encounter, speed }) => [encounter, speed, tolerance] as const), ...more];
  it.each(all.map((each, index) => [index, ...each] as const))('about ε is that of the command: case %i',
    (_, encounter, speed, wanted) => {
      const row = restitution(encounter, speed, wanted);
      const ours = ask('restitution', encounter, { speed, tolerance: wanted }).value;
      expect(ours.converged).toBe(row.converged);
      expect(Math.abs((row.speed as number) * barSpeed(encounter) / speed - 1)).toBeLessThan(1e-12);
      expect(compare(ours.quantities, row, 1e-12, 0)).toBeGreaterThan(10);
      const yields = row.yield_speed_si as number | undefined;
      expect(ours.yieldSpeed === undefined).toBe(yields === undefined);
      if (yields !== undefined) expect(ours.yieldSpeed! / yields).toBeCloseTo(1, 12);
      expect(ours.yieldWarning !== undefined).toBe(yields !== undefined && speed > yields);
    });

  it.each(obliqueCases.map((inputs, index) => [index, inputs] as const))('about friction is that of the command: case %i',
    (_, inputs) => {
      const row = oblique(inputs, tolerance);
      const { value } = ask('oblique', inputs.encounter, { ...motionOf(inputs), tolerance });
      expect(value.converged).toBe(row.converged);
      expect(compare(value.quantities, row, 1e-12, 1e-12)).toBeGreaterThan(10);
    });

  const predicted: [Encounter, number][] = [
    [at('wall'), 1], [at('wall'), 0.01], [at('same'), 0.5], [at('body', steel, made('brass', 0.01)), 1],
    [at('half-space'), 2], [at('plate'), 1], [at('plate', made('glass', 0.002)), 0.2], [at('wall', made('ice', 1e-6)), 1e-3],
    [at('wall', { ...steel, loss_time: 0 }), 1],
    [at('half-space', made('tungsten carbide', 0.005), made('granite', 1)), 1],
    [at('half-space', steel, { ...made('glass', 1), young: 6.5e10 }), 1],
  ];
  it.each(predicted.map((each, index) => [index, ...each] as const))('that predicts is that of the command: case %i',
    (_, encounter, speed) => {
      const row = prediction(encounter, speed, tolerance);
      const [ours] = ask('prediction', encounter, { speeds: [speed], tolerance, constants: true }).all;
      const close = (value: number, theirs: number): void =>
        expect(Math.abs(value - theirs)).toBeLessThanOrEqual(1e-9 * Math.max(1, Math.abs(theirs)));
      // A motion in steps that follow its error is known to 10⁻⁹; JSON has no infinite number.
      const finite = Object.values(ours!.quantities).filter(({ value }) => Number.isFinite(value));
      expect(compare(ours!.quantities, row, 1e-9, 1e-9)).toBe(finite.length);
      for (const { name, share } of ours!.channels) close(share, row[name] as number);
      expect(ours!.channels.map(({ model }) => model)).toEqual([false, false, false, true, true]);
      expect([ours!.dominant, ours!.warnings]).toEqual([row.dominant, row.warnings]);
      expect(ours!.influences.map(({ constant }) => constant)).toEqual(row.influences.map(({ constant }) => constant));
      ours!.influences.forEach(({ change }, k) => close(change, row.influences[k]!.change));
    });

  it.each([[0, 0.01, 0.2], [4, 1e-3, 0.1], [7, 50, 500]])('in C is that of the command: case %i', (index, from, to) => {
    const { encounter } = cases[index]!;
    const range = ['--speed', `${from}:${to}`, '--error', '0.01'];
    // Text and numbers apart; without the comment that says who made it.
    const [native, ours] = [run(['table', ...encounterArguments(encounter), ...range]),
      ask('header', encounter, { slowest: from, fastest: to, error: 0.01 }).value].map((header) => {
      const code = header.replace(/\/\*[\s\S]*?\*\//g, '');
      const number = /-?\d+\.?\d*(e[-+]?\d+)?/g;
      return { text: code.replace(number, '#'), numbers: (code.match(number) ?? []).map(Number) };
    }) as [{ text: string; numbers: number[] }, { text: string; numbers: number[] }];
    expect(ours.text).toBe(native.text);
    ours.numbers.forEach((value, k) => expect(Math.abs(value - native.numbers[k]!))
      .toBeLessThanOrEqual(1e-12 * Math.max(1, Math.abs(value))));
  });
});

it('about a hollow sphere says where linear elasticity of its shell ends', () => {
  const encounter = like(ball, { kind: 'hollow-sphere', si: true, first: { ...made('PMMA', 0.02), inner: 0.9 } });
  const linesAt = (speed: number) => ask('restitution', encounter, { speed, tolerance }).value.materialWarnings;
  expect(linesAt(20)).toEqual([]);
  expect(linesAt(60)).toEqual([expect.stringMatching(/^the shell gives way by more than its thickness from about 24\.3 m\/s on/)]);
});

describe('many answers', () => {
  it('are those at each speed', () => {
    const speeds = [0.2, 0.01, 0.05];
    const points = ask('curve', one, { speeds, tolerance: 1e-3 }).all;
    expect(points.map(({ speed }) => speed)).toEqual(speeds);
    for (const { speed, ...point } of points) {
      const { quantities, converged } = ask('restitution', one, { speed, tolerance: 1e-3 }).value;
      const { value, error } = quantities.restitution!;
      expect(point).toEqual({ restitution: value, error, converged });
    }
  });
  it('are those at each angle', () => {
    const inputs = obliqueCases[2]!;
    const angles = [70, 20];
    const { all } = ask('obliqueAngles', inputs.encounter, { ...motionOf(inputs), angles, tolerance });
    (all as AnglePoint[]).forEach(({ angle, restitution: epsilon, tangential, tangentialError }, k) => {
      expect(angle).toBe(angles[k]);
      const { quantities } = ask('oblique', inputs.encounter, { ...motionOf(inputs), angle, tolerance }).value;
      expect(epsilon).toBe(quantities.restitution!.value);
      expect(Math.abs(tangential - quantities.tangential_restitution!.value)).toBeLessThan(tangentialError);
    });
  });
  it('that predict need no influences', () => {
    const points = ask('prediction', at('wall'), { speeds: [1, 0.05], tolerance, constants: false }).all;
    expect(points.map(({ speed }) => speed)).toEqual([1, 0.05]);
    for (const { influences } of points) expect(influences).toEqual([]);
  });
  it('are there up to the end of a curve, at a soft half-space too', () => {
    for (const kind of ['disk', 'sphere'] as const) {
      const soft = like(one, { kind, against: 'half-space', second: { ...unitBody, young: 0.02 } });
      const speeds = [Math.max(...curveSpeeds(soft))];
      expect(ask('curve', soft, { speeds, tolerance }).all[0]!.restitution).toBeGreaterThan(0);
      expect(() => ask('curve', soft, { speeds: [0.5], tolerance })).toThrow('at so soft a body');
    }
  });
});

describe('what is wrong', () => {
  it.each([
    [like(one, { first: { ...unitBody, poisson: 7 } }), 0.1, 'poisson: got 7'],
    [one, 2, 'speed: got 2, allowed 1e-8 to 1 c'],
    [one, Number.NaN, 'speed: got nan'],
    [like(one, { against: 'body', second: { ...unitBody, radius: -1 } }), 0.1, 'against radius: got -1'],
    [{ first: { kind: 'rod' }, against: 'half-space' } as Encounter, 0.1, 'against: got half-space'],
  ] as const)('is refused with one line: case %#', (encounter, speed, line) => {
    expect(() => ask('restitution', encounter, { speed, tolerance })).toThrow(line);
    expect(ask('restitution', one, { speed: 0.1, tolerance }).value.converged).toBe(true); // the core is as it was
  });
  it('of a prediction has no thresholds either', () => {
    expect(thresholdsOf(at('wall'))!.yield).toBeCloseTo(0.13, 2);
    expect(thresholdsOf(at('wall', made('glass', 0.002)))!.yield).toBeUndefined();
    for (const other of [{ si: false }, { kind: 'disk' }, { kind: 'rod' }] as const) {
      const encounter = like(at('wall'), other);
      expect(thresholdsOf(encounter)).toBeUndefined();
      expect(() => ask('prediction', encounter, { speeds: [0.1], tolerance, constants: false })).toThrow(/missing|allowed/);
    }
  });
});
