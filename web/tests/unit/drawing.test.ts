import { describe, expect, it } from 'vitest';
import { legend } from '../../src/drawing/axes';
import { interpolate, lastNotAbove, placeOf, valueAt } from '../../src/drawing/scale';
import { element, escaped, pathThrough, svgDocument } from '../../src/drawing/svg';
import { look } from '../../src/drawing/theme';
import { linearTicks, logTicks, roundDown, roundUp, unitInWords, written } from '../../src/drawing/ticks';

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
  it('are round and inside', () => {
    expect(linearTicks(-0.12, 0.31, 5).map((each) => each.label)).toEqual(['−0.1', '0', '0.1', '0.2', '0.3']);
    expect(linearTicks(0, 1e-5, 2).map((each) => each.label)).toEqual(['0', '5×10⁻⁶', '10⁻⁵']);
    expect(linearTicks(1, 1, 5)).toEqual([]);
  });
  it('of a logarithmic axis have numbers at 1, 2 and 5 where there is room', () => {
    const labels = (low: number, high: number, count: number): string[] =>
      logTicks(low, high, count).map((each) => each.label).filter(Boolean);
    expect(labels(0.01, 0.3, 9)).toEqual(['0.01', '0.02', '0.05', '0.1', '0.2']);
    expect(labels(1e-3, 1, 5)).toEqual(['0.001', '0.01', '0.1', '1']);
    expect(labels(1e-8, 1, 4)).toEqual(['10⁻⁸', '10⁻⁶', '10⁻⁴', '10⁻²', '1']);
    expect(logTicks(0, 1, 4)).toEqual([]);
  });
});

describe('scales', () => {
  it('invert each other', () => {
    for (const log of [false, true]) {
      const scale = { low: 1e-3, high: 0.3, log };
      expect(placeOf(scale, 1e-3)).toBeCloseTo(0);
      expect(placeOf(scale, 0.3)).toBeCloseTo(1);
      for (const place of [0.1, 0.5, 0.93]) expect(placeOf(scale, valueAt(scale, place))).toBeCloseTo(place, 12);
    }
  });
  it('find and interpolate', () => {
    const places = [0, 1, 1, 4];
    expect([-1, 0, 1, 3.9, 9].map((each) => lastNotAbove(places, each))).toEqual([-1, 0, 2, 2, 3]);
    expect(interpolate([0, 2], [10, 20], 0.5)).toBe(12.5);
    expect(interpolate([0, 2], [10, 20], -5)).toBe(10);
    expect(interpolate([0, 2], [10, 20], 5)).toBe(20);
  });
});

describe('a legend', () => {
  const ink = '#000';
  const theme = { text: ink, muted: ink, line: ink, background: '#fff', panel: '#fff', accent: ink, dark: false };
  const drawn = (labels: string[], width: number): [string, number] => legend(
    labels.map((label) => ({ label, look: look(0, theme), line: true, marker: true })), 10, 0, width, theme);
  it('breaks labels that are wider than it, and is as high as its rows', () => {
    const long = 'bearing steel sphere 5 mm at glass half-space';
    const [svg, height] = drawn([long, 'disk'], 240);
    const rows = [...svg.matchAll(/<text x="([\d.]+)" y="([\d.]+)"[^>]*>([^<]+)</g)].map((each) => each.slice(1));
    expect(rows.map((row) => row[2])).toEqual(['bearing steel sphere 5 mm at', 'glass half-space', 'disk']);
    expect(rows.map((row) => Number(row[1]))).toEqual([4, 22, 40]);
    expect(height).toBe(60);
    expect(drawn([long, 'disk'], 900)[1]).toBe(24);
  });
});

describe('SVG', () => {
  it('escapes text and leaves out what is undefined', () => {
    expect(escaped('a<b & "c"')).toBe('a&lt;b &amp; &quot;c&quot;');
    expect(element('g', { x: 1.23456, 'stroke-dasharray': undefined, name: '<' })).toBe('<g x="1.23" name="&lt;"/>');
  });
  it('breaks paths where a value is missing', () => {
    expect(pathThrough([0, 1, 2, 3, 4], [0, 1, NaN, 3, 4])).toBe('M0 0L1 1M3 3L4 4');
  });
  it('is a document with a title', () => {
    const document = svgDocument(10, 20, 'ε & v', '#fff', '<g/>');
    expect(document).toContain('viewBox="0 0 10 20"');
    expect(document).toContain('<title>ε &amp; v</title>');
  });
});
