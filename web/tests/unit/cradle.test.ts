// The cradle: what rules say, how balls swing and fall, and its inputs in the address.
import { describe, expect, it } from 'vitest';
import { slowBalls } from '../../src/cradle/bars';
import { fromAddress, massesOf, pairOf, rowOf, speedAt, speedsOf, startOf, toAddress, usual, withBalls } from '../../src/cradle/inputs';
import { pairwise, textbook } from '../../src/cradle/rules';
import { collisionsAt, fallSpan, halfPeriod, heightsAt, outAt, spanOf } from '../../src/cradle/swing';
import { accountsOf, ballsOf } from '../../src/cradle/view';
import type { RowCollision } from '../../src/core/protocol';
import { gravity } from '../../src/inputs/inputs';

const equal = (count: number): number[] => Array.from({ length: count }, () => 1);
const close = (ours: readonly number[], theirs: readonly number[], digits = 12): void => {
  expect(ours.length).toBe(theirs.length);
  ours.forEach((each, k) => expect(each).toBeCloseTo(theirs[k]!, digits));
};

describe('rules', () => {
  it.each([[5, 1], [5, 2], [5, 4], [7, 3], [2, 1]])('of %i balls, %i lifted: as many fly off without loss', (count, lift) => {
    const speeds = equal(count).map((one, k) => (k < lift ? one : 0));
    close(textbook({ masses: equal(count), speeds, restitution: 0.5 }), [...speeds].reverse());
  });
  it('of two balls at a time lose what the pair loses', () => {
    close(pairwise({ masses: [1, 1], speeds: [1, 0], restitution: 0.6 }), [0.2, 0.8]);
    const three = pairwise({ masses: equal(3), speeds: [1, 0, 0], restitution: 0.99 });
    close(three, [0.005, 0.005, 0.99], 4);
    expect(three.reduce((sum, each) => sum + each)).toBeCloseTo(1, 12);
  });
  it('end where balls stick together', () => {
    const after = pairwise({ masses: equal(7), speeds: [1, 0, 0, 0, 0, 0, 0], restitution: 0 });
    close(after, equal(7).map(() => 1 / 7), 3);
  });
  it('of a light ball on a heavy one have three times the speed', () => {
    const drop = { masses: [1, 1e9], speeds: [1, 1], restitution: 1, wall: 1 };
    close(textbook(drop), [-3, -1], 6);
    close(pairwise({ ...drop, wall: 0.5 }), [-2, -0.5], 6);
    close(textbook({ ...drop, masses: [1, 3] }), [-2, 0]); // (3M − m)/(M + m)
  });
});

describe('swings', () => {
  const swings = { half: 0.5, velocities: [[1, 0, 0], [-0.03, 0.03, 1], [-0.9, 0.02, 0.1]] };
  it('come from one side, and each velocity carries half of one', () => {
    expect(spanOf(swings)).toEqual({ from: -0.25, to: 1 });
    close(outAt(swings, -0.25), [-1, 0, 0]);
    close(outAt(swings, 0), [0, 0, 0]);
    close(outAt(swings, 0.25), [-0.03, 0.03, 1]);
    close(outAt(swings, 0.5), [0, 0, 0]);
    close(outAt(swings, 0.75), [-0.9, 0.02, 0.1]);
    expect([-0.1, 0.1, 0.6, 1].map((time) => collisionsAt(swings, time))).toEqual([0, 1, 2, 2]);
  });
  it('have the velocities at the bottom', () => {
    const [time, factor] = [1e-6, 0.5 / Math.PI];
    close(outAt(swings, time).map((out) => (out * factor) / time), swings.velocities[1]!, 6);
    close(outAt(swings, -time).map((out) => (-out * factor) / time), swings.velocities[0]!, 6);
  });
  it('never pass each other', () => {
    for (let time = -0.25; time <= 1; time += 0.01) {
      const out = outAt(swings, time);
      expect([...out].sort((a, b) => a - b).every((each, k) => Math.abs(each - out[k]!) < 1e-12)).toBe(true);
    }
  });
  it('take as long as strings of their length', () => expect(halfPeriod(gravity / Math.PI ** 2)).toBeCloseTo(1, 12));
});

describe('a fall', () => {
  it('begins at the drop height, and ends when the upper ball is at its highest', () => {
    const fall = { speed: Math.sqrt(2 * gravity * 0.5), after: [2, 1] };
    const { from, to } = fallSpan(fall);
    close(heightsAt(fall, from), [0.5, 0.5]);
    close(heightsAt(fall, 0), [0, 0]);
    expect(to).toBeCloseTo(2 / gravity, 12);
    expect(heightsAt(fall, to)[0]).toBeCloseTo(4 / (2 * gravity), 12);
  });
});

describe('inputs', () => {
  it.each([usual, startOf('drop'), { ...usual, balls: 7, lift: 3, gap: 1e-4, vibration: 'stays' as const, material: 'glass' }])(
    'come back from their address: case %#', (inputs) => expect(fromAddress(`?${toAddress(inputs)}`)).toEqual({ inputs, problem: '' }));
  it('without an address are the usual ones', () => expect(fromAddress('')).toEqual({ inputs: usual, problem: '' }));
  it.each([
    ['balls=9', 'balls: got “9”, allowed 2 to 7'], ['balls=3&lift=3', 'lift: got “3”, allowed 1 to 2'],
    ['R=-1', 'R: got -1, allowed 0 or more'], ['material=cheese', 'material: got “cheese”'], ['nu=1', 'nu: got an unknown key'],
    ['gap=x', "gap: got"], ['scene=drop&balls=3', 'balls: got a key that'],
  ])('say what is wrong with %s', (query, line) => {
    const { inputs, problem } = fromAddress(query);
    expect(problem).toContain(line);
    expect(fromAddress(toAddress(inputs)).problem).toBe('');
  });
  it('make rows and pairs', () => {
    const ball = { kind: 'sphere', radius: 0.01, material: 'bearing steel' };
    expect(rowOf(withBalls(usual, 3))).toEqual({ bodies: [ball, ball, ball] });
    expect(rowOf({ ...usual, balls: 3, gap: 1e-4 })).toHaveProperty('gaps', [1e-4, 1e-4]);
    expect(rowOf(startOf('drop'))).toMatchObject({ after: 'wall', gaps: [0.005, 0], bodies: [{ radius: 0.01 }, { radius: 0.03 }] });
    expect(pairOf(usual)).toEqual({ first: ball, against: 'same' });
    expect(massesOf(startOf('drop'))[1]).toBeCloseTo(27, 12);
    expect(speedsOf(withBalls(usual, 3, 2))).toEqual([speedAt(usual), speedAt(usual), 0]);
    expect(withBalls(withBalls(usual, 7, 6), 3)).toMatchObject({ balls: 3, lift: 2 });
  });
});

describe('accounts', () => {
  it('are over the speed at the bottom, of what falls upwards', () => {
    const of = (values: number[]): RowCollision => ({
      bodies: values.map((value) => ({ velocity_after_si: { value, error: 1e-3, unit: 'm/s', help: '' } })),
    }) as unknown as RowCollision;
    const three = withBalls(usual, 3);
    const speed = speedAt(three);
    const [computed, book, pairs] = accountsOf(three, of([-0.027, 0.032, 0.995].map((each) => each * speed)), { pair: 0.99 });
    close(computed!.velocities, [-0.027, 0.032, 0.995]);
    close(computed!.errors!, [1, 1, 1].map((each) => (1e-3 * each) / speed));
    close(book!.velocities, [0, 0, 1]);
    close(pairs!.velocities, [0.005, 0.005, 0.99], 4);
    expect(slowBalls([computed!, book!, pairs!])).toEqual([0, 1]);
    expect(slowBalls([book!])).toEqual([]);
    const drop = startOf('drop');
    const fall = accountsOf(drop, of([-2 * speedAt(drop), -0.5 * speedAt(drop)]), { pair: 1, floor: 1 });
    close(fall[0]!.velocities, [2, 0.5]);
    close(fall[1]!.velocities, [80 / 28, 24 / 28]);
    expect(ballsOf(drop).length).toBe(2);
  });
});
