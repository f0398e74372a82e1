import { describe, expect, it } from 'vitest';
import { interpolate } from '../../src/drawing/samples';
import { placed, ticksOf } from '../../src/drawing/plot';
import { roundDown, roundUp, unitInWords, written } from '../../src/drawing/numbers';

describe('written', () => {
  it.each([
    [0, '0'], [0.1, '0.1'], [1 / 3, '0.3333'], [-2.5, '−2.5'], [1e-4, '10⁻⁴'], [-1e-4, '−10⁻⁴'], [2e-4, '2×10⁻⁴'],
    [123456, '123500'], [1.25e7, '1.25×10⁷'], [1e7, '10⁷'], [-3e-7, '−3×10⁻⁷'], [Infinity, '∞'], [-Infinity, '−∞'],
    [NaN, '–'], [1.1e-4, '1.1×10⁻⁴'], [0.99996, '1'], [9.99999e-4, '0.001'], [9.9e-4, '9.9×10⁻⁴'],
  ])('%d is %s', (value, words) => expect(written(value)).toBe(words));
});

describe('units', () => {
  it.each([
    ['piRE', 'πRE'], ['mc^2/R', 'mc²/R'], ['N/m', 'N/m'], ['m^-1', 'm⁻¹'], ['', ''],
  ])('%s is %s', (unit, words) =>
    expect(unitInWords(unit)).toBe(words));
});

describe('round numbers', () => {
  it('go up and down by 1, 2, 5', () => {
    const up = [0.9, 1, 1.1, 3, 7, 0.03].map(roundUp);
    expect(up.map((each) => written(each))).toEqual(['1', '1', '2', '5', '10', '0.05']);
    expect([0.9, 1, 2.1, 7, 0.03].map(roundDown).map((each) => written(each))).toEqual(['0.5', '1', '2', '5', '0.02']);
  });
});

describe('ticks', () => {
  const labels = (low: number, high: number, count: number, log = false): string[] => {
    const { places, words } = ticksOf({ low, high, log }, count, 1);
    return places.map(words).filter(Boolean);
  };
  it('are round and inside', () => {
    expect(labels(-0.12, 0.31, 5)).toEqual(['−0.1', '0', '0.1', '0.2', '0.3']);
    expect(labels(0, 1e-5, 2)).toEqual(['0', '5×10⁻⁶', '10⁻⁵']);
    expect(labels(1e5, 3e5, 2)).toEqual(['100000', '200000', '300000']);
  });
  it('of a logarithmic axis have numbers at 1, 2 and 5 where there is room', () => {
    expect(labels(0.01, 0.3, 9, true)).toEqual(['0.01', '0.02', '0.05', '0.1', '0.2']);
    expect(labels(1e-3, 1, 5, true)).toEqual(['0.001', '0.01', '0.1', '1']);
    expect(labels(1e-8, 1, 4, true)).toEqual(['10⁻⁸', '10⁻⁶', '10⁻⁴', '10⁻²', '1']);
    expect(labels(0.31, 0.43, 4, true).length).toBeGreaterThan(1);
  });
});

describe('samples', () => {
  it('are interpolated', () => {
    expect(interpolate([0, 2], [10, 20], 0.5)).toBe(12.5);
    expect(interpolate([0, 2], [10, 20], -5)).toBe(10);
    expect(interpolate([0, 2], [10, 20], 5)).toBe(20);
  });
});

describe('a legend', () => {
  const long = 'bearing steel sphere 5 mm at glass half-space';
  it('breaks labels that are wider than it, and has as many rows as they need', () => {
    const [first, second] = placed([long, 'disk'], 300);
    expect(first!.rows).toBe(2);
    expect(first!.letters).toBeLessThan(long.length);
    expect(second!.y - first!.y).toBe(36);
    expect(second!.x).toBe(first!.x);
  });
  it('has columns where there is room', () => {
    const [one, two, three] = placed([long, 'disk', 'rod'], 900);
    expect(one!.rows).toBe(1);
    expect(two!.y).toBe(one!.y);
    expect([three!.x, three!.y]).toEqual([one!.x, one!.y + 18]);
  });
});
