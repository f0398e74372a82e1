import { describe, expect, it } from 'vitest';
import { ordinateScale, speedScale } from '../../src/charts/curve_picture';
import { frequencyInWords } from '../../src/charts/mode_bars';
import { energyOfWaves, energyScale, layoutModes, swing } from '../../src/charts/mode_picture';
import { barOf } from '../../src/charts/model_picture';
import { cursorWords, panelsOf, summaryOf, thinned } from '../../src/charts/series';
import { unitsOf } from '../../src/core/local';
import type { Collision, CurvePoint, ModeEnergy } from '../../src/core/protocol';
import { withUnit } from '../../src/drawing/numbers';
import { labelOf } from '../../src/drawing/plot';
import { unitBody } from '../../src/inputs/document';
import { defaults } from '../../src/inputs/inputs';
import { describe as describeTime, phaseAt, slowness } from '../../src/scene/film';
import { stressInWords } from '../../src/scene/picture';
import { like } from './cases';

const time = Float64Array.from({ length: 1001 }, (_, k) => k / 125);
const zero = new Float64Array(1001);
const COLLISION: Collision = {
  units: { time: 'R/c', velocity: 'c', force: 'mc^2/R' }, time,
  velocity: time.map((t) => 0.1 * Math.cos((Math.PI * t) / 8)),
  force: time.map((t) => 0.05 * Math.sin((Math.PI * t) / 8)),
  contact_half_width: zero, translation: time.map((t) => Math.cos((Math.PI * t) / 8) ** 2), vibration: zero,
  stored: time.map((t) => Math.sin((Math.PI * t) / 8) ** 2), dissipated: zero, yielded: zero, unresolved: zero,
  modes: [], begin: 0, end: 8,
};
const ENCOUNTER = like(defaults.encounter, { first: { ...unitBody, poisson: 0.3 } });

describe('a collision in words', () => {
  it('has four phases', () => {
    const phases = [-0.1, 1, 7, 8.1].map((each) => phaseAt(COLLISION, each));
    expect(phases).toEqual(['approach', 'compression', 'restitution', 'apart']);
  });
  it('says how slow the film is', () => {
    expect(slowness(4e-4, 's', 8)).toBe('Slowed 20000 times.');
    expect(slowness(16, 'R/c', 8)).toBe('1 s of the film is 2 R/c.');
  });
  it('says time and force', () => {
    expect(describeTime(COLLISION, 4.004)).toBe('restitution, time 4 R/c, force 0.05 mc²/R, 100 % of the maximum');
    expect(describeTime(COLLISION, 9)).toContain('force 0 mc²/R');
    expect(summaryOf(COLLISION)).toContain('The force is at its maximum, 0.05 mc²/R, 4 R/c after first contact');
    expect(cursorWords(COLLISION, panelsOf(COLLISION), 8)).toContain('velocity −0.1 c, translation 1');
  });
});

describe('a collision in SI', () => {
  const si: Collision = {
    ...COLLISION, units: { time: 's', velocity: 'm/s', force: 'N' }, end: 8e-5,
    time: time.map((t) => 1e-5 * t),
    force: COLLISION.force.map((f) => 1e6 * f),
  };
  it('has prefixes that suit its numbers', () => {
    const panels = panelsOf(si);
    expect(panels.map(labelOf)).toEqual(['Force (kN)', 'Velocity (m/s)', 'Share of the energy']);
    expect(cursorWords(si, panels, si.time[500]!)).toContain('time 40 µs: force 50 kN, velocity ');
    expect(describeTime(si, 4.004e-5)).toBe('restitution, time 40 µs, force 50 kN, 100 % of the maximum');
    expect(describeTime(si, 1e-9)).toContain('time 0.001 µs');
  });
  it('stays as it is in units of the body', () => {
    expect(labelOf(panelsOf(COLLISION)[0]!)).toBe('Force (mc²/R)');
    expect([withUnit(0, 's'), withUnit(2e-4, 'R/c'), withUnit(0.25, 'm/s'), withUnit(2e-12, 's')]).toEqual(
      ['0 s', '2×10⁻⁴ R/c', '0.25 m/s', '2 ps']);
  });
});

describe('charts in time', () => {
  it('leave out energies that are never there', () => {
    expect(panelsOf(COLLISION)[2]!.series.map((each) => each.label)).toEqual(['translation', 'stored at the contact']);
  });
  it('thin long curves and keep their peaks', () => {
    const y = time.map((_, k) => (k === 777 ? 5 : 0));
    const thin = thinned(time, y, 100);
    expect(thin.x.length).toBeLessThan(250);
    expect(thin.y).toContain(5);
    expect([thin.x[0], thin.x[thin.x.length - 1]]).toEqual([0, 8]);
    for (let k = 1; k < thin.x.length; ++k) expect(thin.x[k]!).toBeGreaterThanOrEqual(thin.x[k - 1]!);
  });
});

describe('ε against the speed', () => {
  const point = (speed: number, restitution: number, error = 1e-3): CurvePoint =>
    ({ speed, restitution, error, converged: true });
  it('gives 1 − ε² the error 2 ε Δε', () => {
    const bar = barOf('loss', 0.9, 0.001);
    expect(bar.value).toBeCloseTo(0.19);
    expect(bar.high! - bar.value).toBeCloseTo(0.0018);
    expect(barOf('restitution', 0.9, Infinity)).toEqual({ value: 0.9 });
  });
  it('has axes that hold all points', () => {
    const points = [point(1e-3, 0.99), point(0.3, 0.7, 0.02)];
    const speeds = speedScale(points.map((each) => each.speed));
    expect(speeds.low).toBeLessThan(1e-3);
    expect(speeds.high).toBeGreaterThan(0.3);
    const linear = ordinateScale('restitution', points);
    expect(linear.low).toBeLessThan(0.68);
    expect(linear.high).toBeLessThanOrEqual(1.002);
    const loss = ordinateScale('loss', points);
    expect(loss.log).toBe(true);
    expect(loss.low).toBeLessThan(1 - 0.99 ** 2);
    expect(loss.low).toBeGreaterThan(0);
    expect(ordinateScale('loss', []).low).toBeGreaterThan(0);
    expect(speedScale([]).low).toBeGreaterThan(0);
    expect(speedScale([0.1]).high).toBeGreaterThan(0.1);
  });
});

describe('bars of modes', () => {
  const modes: ModeEnergy[] = [];
  for (let n = 0; n < 60; ++n) {
    for (let l = 0; l < 30; ++l) {
      modes.push({ body: 0, order: n, index: l, omega: n + l, after: 1 / (1 + n + l) ** 3, average: 0 });
    }
  }
  it('are the maximum, in groups, and say what is left out', () => {
    const layout = layoutModes(modes, 0, 'after', 20);
    expect(layout.bars).toHaveLength(20);
    expect(layout.omitted).toBe(1780);
    const whole = modes.reduce((sum, each) => sum + each.after, 0);
    expect(layout.rest + layout.bars.reduce((sum, each) => sum + each.energy, 0)).toBeCloseTo(whole);
    expect(Math.min(...layout.bars.map((each) => each.energy))).toBeGreaterThanOrEqual(1 / 7 ** 3);
    for (let k = 1; k < 20; ++k) {
      expect(layout.bars[k]!.left).toBeGreaterThanOrEqual(layout.bars[k - 1]!.left + layout.bars[k - 1]!.width - 1e-12);
    }
    expect(layout.bars[19]!.left + layout.bars[19]!.width).toBeLessThanOrEqual(1);
    expect(layoutModes(modes, 0, 'average', 20).bars).toHaveLength(0);
    expect(layoutModes(modes, 1, 'after', 20).bars).toHaveLength(0);
    expect(energyOfWaves({ modes, vibration: Float64Array.of(0, whole + 0.2) })).toBeCloseTo(0.2);
    expect(energyOfWaves({ modes, vibration: Float64Array.of(9, whole) })).toBeCloseTo(0);
  });
  it('stand on 0, or on the least of them', () => {
    const layout = layoutModes(modes, 0, 'after', 20);
    expect(energyScale(layout, false).low).toBe(0);
    expect(energyScale(layout, true).low).toBeGreaterThan(0);
    expect(energyScale(layoutModes(modes, 0, 'average', 20), true).low).toBeGreaterThan(0);
  });
  it('say frequencies in c/R or Hz', () => {
    const first = { ...unitBody, poisson: 0.3, radius: 0.01, young: 2.1e11, density: 7850 };
    const steel = like(ENCOUNTER, { si: true, first });
    expect(frequencyInWords(2, ENCOUNTER)).toBe('ω = 2 c/R');
    expect(frequencyInWords(2 * Math.PI, steel)).toBe('517.2 kHz');
    expect(unitsOf(like(steel, { plane: 'strain' })).modulus! / (2.1e11 / 0.91)).toBeCloseTo(1, 12);
    expect(unitsOf(like(steel, { kind: 'sphere' })).modulus! / 2.1e11).toBeCloseTo(1, 12);
    expect(unitsOf(ENCOUNTER).modulus).toBeUndefined();
  });
  it('have shapes that come to rest where they are farthest', () => {
    expect([swing(0), swing(0.6), swing(99)].map((each) => Math.round(each * 1e6) / 1e6)).toEqual([1, -1, 1]);
  });
});

describe('stress in words', () => {
  it('is in the modulus, or in SI with a prefix', () => {
    expect(stressInWords(0.02, undefined)).toBe('0.02 E');
    expect(stressInWords(0.02, 2.1e11)).toBe('4.2 GPa');
    expect(stressInWords(1e-5, 2e9)).toBe('20 kPa');
  });
});
