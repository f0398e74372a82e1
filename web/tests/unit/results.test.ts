// What the page shows of a result besides ε: how high it bounces, at what speed it yields.
import { describe, expect, it } from 'vitest';
import type { Restitution } from '../../src/core/protocol';
import { flags, reboundInWords, reboundOf, shownQuantity, yieldInWords } from '../../src/page/results';
import { presets } from '../../src/inputs/inputs';
import { like } from './cases';

type Number = { value: number; error?: number; unit: string };

const ball = presets[1]!.encounter;
const plain = like(ball, { si: false, against: 'wall' });

/** Numbers of the core with what they are. */
function result(speed: number, restitution: Number, more: Partial<Restitution> = {}, others: Record<string, Number> = {}): Restitution {
  const quantities = Object.fromEntries(
    Object.entries({ restitution, ...others }).map(([name, each]) => [name, { help: '', ...each }])) as Restitution['quantities'];
  return { speed, quantities, converged: true, reason: '', note: '', cutoff: 8, beyondSmallStrain: false, ...more };
}

describe('the height of rebound', () => {
  it('is ε²h, with the error that follows', () => {
    const rebound = reboundOf(ball, 2, { value: 0.9, error: 0.01, unit: '' })!;
    expect(rebound.drop).toBeCloseTo(4 / 19.6133, 12);
    expect(rebound.height.value).toBeCloseTo(0.81 * rebound.drop!, 12);
    expect(rebound.height.error).toBeCloseTo(0.018 * rebound.drop!, 12);
    const inHeights = { drop: undefined, height: { value: 0.81, unit: '' } };
    expect(reboundOf(plain, 0.1, { value: 0.9, unit: '' })).toEqual(inHeights);
  });
  it('is none where the other body moves too', () => {
    for (const against of ['same', 'body'] as const) {
      const words = reboundInWords(like(ball, { against }), result(1, { value: 0.9, unit: '' }));
      expect(words).toEqual({ full: '', short: '' });
    }
  });
  it('is said whole and in three digits', () => {
    const words = reboundInWords(ball, result(1, { value: 0.986193, error: 1.1e-5, unit: '' }));
    expect(words).toEqual({ full: '49.5876 ± 0.0011\u00a0mm of 51.0\u00a0mm', short: '49.6\u00a0mm of 51.0\u00a0mm' });
    expect(reboundInWords(plain, result(0.1, { value: 0.94706, error: 3e-5, unit: '' })).short).toBe('0.897\u00a0h');
  });
});

describe('the yield speed', () => {
  const at = (speed: number, yieldSpeed?: number): string =>
    yieldInWords(ball, result(speed, { value: 0.9, unit: '' }, yieldSpeed === undefined ? {} : { yieldSpeed }));
  it('is said, and that ε is a bound above it', () => {
    expect(at(0.1, 0.1312)).toBe('Begins to yield at 0.13 m/s: above that, ε is an upper bound.');
    const beyond = result(1, { value: 0.9, unit: '' }, { yieldSpeed: 0.1312, yieldWarning: 'the ball yields' });
    expect(yieldInWords(ball, beyond)).toBe('The ball yields.');
    expect(at(1)).toBe('Once the material yields or cracks, ε is an upper bound.');
    expect(yieldInWords(plain, result(0.1, { value: 0.9, unit: '' }))).toBe('');
  });
});

describe('what materials do that was not computed', () => {
  it('is said as the core says it', () => {
    const materialWarnings = ['glass is taken as sound'];
    expect(flags(result(1, { value: 0.9, unit: '' }, { materialWarnings }))).toEqual(
      ['Glass is taken as sound.']);
  });
});

describe('what rings leave out', () => {
  const said = (value: number): string[] => {
    const quantities = { coupling_tangential_restitution: { value, unit: '' } };
    return flags(result(1, { value: 0.9, unit: '' }, {}, quantities));
  };
  it('is said where it is not small, or unknown', () => {
    expect(said(0)).toEqual([]);
    expect(said(-0.009)).toEqual([]);
    expect(said(-0.223)[0]).toMatch(/may change ε_t by 0\.22\.$/);
    expect(said(NaN)[0]).toMatch(/may change ε_t by an unknown amount\.$/);
  });
});

describe('a quantity', () => {
  it('has no digits that its error does not allow', () => {
    const force = (value: number, error: number): string => {
      const quantities = { max_force_si: { value, error, unit: 'N' } };
      return shownQuantity(result(1, { value: 1, unit: '' }, {}, quantities), 'max_force');
    };
    expect(force(9530, 4960)).toBe('10 ± 5\u00a0kN');
    expect(force(4924, 985)).toBe('5 ± 1\u00a0kN');
    expect(force(327.25, 0.14)).toBe('327.25 ± 0.14\u00a0N');
  });
});

describe('how far bodies are strained and turned', () => {
  it('is said with the number, where it is too far', () => {
    const quantities = { strain: { value: 0.1234, unit: '' }, turned: { value: 4.04, unit: '' } };
    const far = result(1, { value: 0.9, unit: '' }, { beyondSmallStrain: true, beyondSmallTurn: true }, quantities);
    const [strain, turn] = flags(far);
    expect(strain).toMatch(/^Beyond small strain, by some 0\.123: above 0\.1 linear elasticity/);
    expect(turn).toMatch(/^The bodies turn by 4 rad while they touch/);
    expect(flags(result(1, { value: 0.9, unit: '' }, {}, quantities))).toEqual([]);
  });
});
