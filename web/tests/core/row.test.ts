// Rows of bodies, as the page of the cradle asks for them.
import { describe, expect, it } from 'vitest';
import type { Numbers, Row, RowQuestions } from '../../src/core/protocol';
import { halfPeriod } from '../../src/cradle/swing';
import { rowOf, speedsOf, startOf, usual } from '../../src/cradle/inputs';
import { hasCommand, run } from './native';
import { core } from './wasm';

function ask<Name extends keyof RowQuestions>(question: Name, row: Row, given: Parameters<RowQuestions[Name]>[0]) {
  return core(question, { ...given, document: JSON.stringify(row) }) as ReturnType<RowQuestions[Name]>;
}

const tolerance = 1e-3;
const sphere = { kind: 'sphere', poisson: 0.3 } as const;
const three: Row = { bodies: [sphere, sphere, sphere] };
const after = (bodies: readonly Numbers[]): number[] => bodies.map(({ velocity_after: its }) => its!.value);

describe('a row of three balls', () => {
  const fast = ask('row', three, { speeds: [0.1], tolerance });
  it('has the velocities of finite elements', () => {
    expect(fast.converged).toBe(true);
    [-0.02709, 0.03197, 0.99512].forEach((value, k) => {
      const { value: ours, error = 0 } = fast.bodies[k]!.velocity_after!;
      expect(Math.abs(ours / 0.1 - value)).toBeLessThan(error / 0.1 + 2e-5);
      expect(error / 0.1).toBeLessThan(tolerance);
    });
    expect(fast.quantities.translation!.value).toBeCloseTo(0.99202, 3);
    expect(fast.contacts.length).toBe(2);
  });
  it.skipIf(!hasCommand)('has the numbers of the command', () => {
    const text = run(['row', '--body', 'sphere', '--poisson', '0.3', '--count', '3', '--speed', '0.1', '--format', 'json']);
    const [record] = (JSON.parse(text) as { records: (Record<string, number> & { velocities_after: number[]; velocities_after_error: number[] })[] }).records;
    after(fast.bodies).forEach((each, k) => {
      expect(Math.abs(each - record!.velocities_after[k]!)).toBeLessThan(1e-12);
      expect(Math.abs(fast.bodies[k]!.velocity_after!.error! - record!.velocities_after_error[k]!)).toBeLessThan(1e-10);
    });
    for (const name of ['translation', 'vibration', 'cutoff', 'duration'] as const) {
      expect(fast.quantities[name]!.value / record![name]!).toBeCloseTo(1, 9);
    }
  });
  it('meets again with all of its vibration, or with what time leaves', () => {
    const { cutoff } = fast;
    const again = ask('rowAgain', three, { speeds: [0.1], cutoff, pause: 0, tolerance });
    expect(again.left).toBeCloseTo(fast.quantities.vibration!.value, 6);
    const before = again.bodies.map(({ velocity }) => velocity!.value);
    before.forEach((each, k) => expect(each).toBeCloseTo(-after(fast.bodies)[k]!, 12));
    const sum = (values: number[]): number => values.reduce((all, each) => all + each);
    expect(sum(after(again.bodies))).toBeCloseTo(sum(before), 9);
    expect(after(again.bodies)[0]! / 0.1).toBeLessThan(-0.9);
    const lossy: Row = { bodies: three.bodies.map((each) => ({ ...each, quality: 30 })) };
    const first = ask('row', lossy, { speeds: [0.1], tolerance });
    const [soon, late] = [10, 1e4].map((pause) => ask('rowAgain', lossy, { speeds: [0.1], cutoff: first.cutoff, pause, tolerance }));
    expect(soon!.left).toBeLessThan(first.quantities.vibration!.value);
    expect(soon!.left).toBeGreaterThan(1e-6);
    expect(late!.left).toBeLessThan(1e-12);
    expect(late!.converged).toBe(true);
  });
  it('is heard', () => {
    const given = { speeds: [0.1], cutoff: fast.cutoff };
    const pitch = ask('rowPitch', three, given);
    expect(pitch).toBeCloseTo(1.64, 2); // of the lowest mode, (2, 0)
    const sound = ask('rowSound', three, { ...given, body: 2, interval: 0.1, count: 1000, quality: 1000 });
    expect(sound.length).toBe(1000);
    expect(Math.max(...sound.map(Math.abs))).toBeGreaterThan(1e-4);
  });
});

describe('the rows of the page', () => {
  it('are computed in SI, again too', () => {
    const speeds = speedsOf(usual);
    const row = rowOf(usual);
    const first = ask('row', row, { speeds, tolerance });
    expect(first.converged).toBe(true);
    const last = first.bodies.at(-1)!.velocity_after_si!;
    expect(last.unit).toBe('m/s');
    expect(last.value / speeds[0]!).toBeCloseTo(0.99, 2);
    const again = ask('rowAgain', row, { speeds, cutoff: first.cutoff, pause: halfPeriod(0.2), tolerance });
    expect(again.left).toBeLessThan(1e-9);
    expect(again.bodies[0]!.velocity_after_si!.value / speeds[0]!).toBeLessThan(-0.9);
  });
  it('drop a ball on a ball: with a gap nearly as the textbook, in touch far from it', () => {
    const drop = { ...startOf('drop'), material: 'bearing steel', drop: 0.0025, gap: 1e-4 };
    const speeds = speedsOf(drop);
    const [apart, touching] = [drop, { ...drop, gap: 0 }].map((inputs) =>
      ask('row', rowOf(inputs), { speeds, tolerance }).bodies[0]!.velocity_after_si!.value / speeds[0]!);
    expect(apart!).toBeLessThan(-2.7);
    expect(touching!).toBeGreaterThan(-2);
  });
});

describe('what is wrong with a row', () => {
  it('is refused with one line', () => {
    expect(() => ask('row', { bodies: [] }, { speeds: [0.1], tolerance })).toThrow(/bodies/);
    expect(() => ask('row', three, { speeds: [0], tolerance })).toThrow(/^speed: /);
    expect(() => ask('rowAgain', { ...three, after: 'wall' }, { speeds: [0.1], cutoff: 10, pause: 0, tolerance })).toThrow(/^after: /);
    expect(() => ask('rowSound', three, { speeds: [0.1], cutoff: 10, body: 3, interval: 0.1, count: 10, quality: 1000 }))
      .toThrow(/^body: got 3/);
  });
});
