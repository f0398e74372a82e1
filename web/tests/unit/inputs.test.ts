import { describe, expect, it } from 'vitest';
import { check, parseNumber, problemsOf } from '../../src/inputs/check';
import { type Field, fieldsOf, valueOf, withValue, wordsOf } from '../../src/inputs/fields';
import { type Inputs, defaults, motionOf, withAgainst, withKind } from '../../src/inputs/inputs';
import { displayed, shortest } from '../../src/drawing/numbers';
import { equal, meetingOf, unitBody } from '../../src/inputs/document';
import {
  barSpeed, curveSpeeds, fastest, onAxisOf, placeOf, slowest, speedAt, steps, withoutSi, withSi,
} from '../../src/inputs/units';
import { description } from '../../src/inputs/lines';
import { cases, like } from './cases';

const typed = (inputs: Inputs, field: Field, text: string) => check(inputs, new Map([[field, text]]));
const problem = (inputs: Inputs, field: Field, text: string): string => {
  const result = typed(inputs, field, text);
  return result.problems.get(field) ?? [...result.problems.values()].map((line) => `other field: ${line}`)[0] ?? '';
};

describe('numbers', () => {
  it.each([['0.33', 0.33], [' 1e-4 ', 1e-4], ['+2', 2], ['.5', 0.5],
    ['5.', 5], ['1E3', 1000], ['−0.2', -0.2], ['-0', 0]])(
    'reads %s', (text, value) => expect(parseNumber('x', text)).toEqual({ value }));
  it.each(['', ' ', 'nan', 'inf', 'Infinity', 'abc', '1e', '1e999', '1e-999', '0x10',
    '1 2', '--1', '0,3', '1.2.3', '1_0'])(
    'refuses “%s” with one line', (text) => {
      const result = parseNumber('Speed', text);
      expect(result).toHaveProperty('problem');
      expect((result as { problem: string }).problem).toMatch(/^Speed: [^\n]+$/);
    });
  it('says how to write a comma decimal', () => {
    expect(parseNumber('Speed', '0,3')).toEqual({ problem: 'Speed: got “0,3”, write it with a point: 0.3' });
  });
  it('writes the shortest text that gives the number back', () => {
    for (const value of [0.33, 1e-7, 2.1e11, 7850, 0.0001, 1e21, 5e-324, 123456.789]) {
      expect(Number(shortest(value))).toBe(value);
    }
    expect(shortest(2.1e11)).toBe('2.1e11');
  });
});

describe('limits', () => {
  it.each([['poisson', '-0.95'], ['poisson', '0.995'], ['loss_time', '0'], ['loss_time', '1e5'],
    ['speed', '1e-8'], ['speed', '1']] as
    [Field, string][])('of a disk include %s %s', (field, text) => expect(problem(defaults, field, text)).toBe(''));
  it.each([['poisson', '-0.96'], ['poisson', '1'], ['loss_time', '-1'], ['loss_time', '1e99'],
    ['speed', '0'], ['speed', '-1'],
    ['speed', '1.01'], ['speed', '1e99'], ['speed', '']] as [Field, string][])(
    'of a disk exclude %s %s', (field, text) =>
      expect(problem(defaults, field, text)).toMatch(/: (got|a number is missing)/));
  it('name, got, allowed and a hint are in the line', () => {
    expect(problem(defaults, 'speed', '2')).toBe(
      'Speed of approach: got 2, allowed 1e-8 to 1 c (speed of approach, along the normal)');
  });
  it('of a sphere end below one half', () => {
    const sphere = { ...defaults, encounter: withKind(defaults.encounter, 'sphere') };
    expect(problem(sphere, 'poisson', '0.5')).toContain('allowed -0.95 to 0.4999');
    expect(problem(sphere, 'poisson', '0.4999')).toBe('');
  });
  it('of ratios are those of the command', () => {
    const pair = { ...defaults, encounter: withAgainst(defaults.encounter, 'body') };
    expect(problem(pair, 'radius2', '1000')).toBe('');
    expect(problem(pair, 'radius2', '1001')).toContain('allowed 0.001 to 1000');
    const block = { ...defaults, encounter: withAgainst(defaults.encounter, 'half-space') };
    expect(problem(block, 'young2', '1e6')).toBe('');
    expect(problem(block, 'young2', '1e7')).toContain('allowed 1e-6 to 1e6');
  });
  it('are marked at the number of what it meets, and at the area where impedances differ too much', () => {
    const rods = { ...defaults, encounter: withAgainst(withKind(defaults.encounter, 'rod'), 'body') };
    expect(problem(rods, 'loss_time2', '-1')).toMatch(/^Loss time of what it meets: got -1/);
    expect(problem(rods, 'area2', '1e7')).toMatch(/^Cross-section of what it meets, impedance ratio: got 1e\+07/);
  });
  it('of the friction are said as the core has them', () => {
    expect(wordsOf(defaults.encounter, 'friction').help).toBe('coefficient of Coulomb’s law, 0 to 5');
  });
  it('of the speed in SI follow the bar speed', () => {
    const si = withSi(defaults);
    expect(problem(si, 'speed', '6000')).toMatch(/allowed 5\.\d+e-5 to 5189\.\d+ m\/s/);
  });
  it('a wrong field does not hide a second one', () => {
    const result = check(defaults, new Map<Field, string>([['poisson', 'x'], ['speed', '7']]));
    expect([...result.problems.keys()]).toEqual(['poisson', 'speed']);
  });
  it('allow all cases of the tests', () => {
    for (const inputs of cases) expect([...problemsOf(inputs).values()]).toEqual([]);
  });
});

describe('a number that is too long for its field', () => {
  it('is shown short, and stays what it is', () => {
    const eta = 1 / (3000 * 2 * Math.PI * 1e4);
    expect(displayed(eta)).toBe('5.30516e-9');
    const inputs = { ...defaults, encounter: withValue(defaults.encounter, 'loss_time', eta) };
    const result = typed(inputs, 'loss_time', displayed(eta));
    expect(valueOf(result.inputs, 'loss_time')).toBe(eta);
    const other = typed(inputs, 'loss_time', '5.305e-9');
    expect(valueOf(other.inputs, 'loss_time')).toBe(5.305e-9);
  });
});

describe('losses', () => {
  const quality = (inputs: Inputs, value: string): Inputs => typed(inputs, 'quality', value).inputs;
  it('take the place of each other, and 0 is none', () => {
    const glass = cases[10]!;
    const other = quality(glass, '40');
    expect(other.encounter.first).toEqual({ kind: 'sphere', radius: 0.005, material: 'bearing steel', quality: 40 });
    expect(typed(other, 'loss_time', '1e-8').inputs.encounter.first).toEqual(
      { kind: 'sphere', radius: 0.005, material: 'bearing steel', loss_time: 1e-8 });
    expect(quality(other, '0').encounter.first).toHaveProperty('loss_time', 0);
    expect(quality(defaults, '0').encounter).toEqual(defaults.encounter);
  });
  it('are refused as the core refuses them', () => {
    expect(problem(defaults, 'quality', '3')).toBe('');
    expect(problem(defaults, 'quality', '2')).toMatch(/^Quality: got 2, /);
  });
  it('stay when something else changes', () => {
    const { encounter } = cases[17]!;
    expect(withValue(encounter, 'radius', 0.01).first).toHaveProperty('quality', 50);
    expect(withValue(encounter, 'density2', 4000).against).toHaveProperty('quality', 12);
    expect(meetingOf(withoutSi(cases[17]!).encounter).first.body.quality).toBe(50);
  });
});

describe('a change of units', () => {
  it('begins in SI with a known material of a known strength, at a round speed at which it does not yield', () => {
    const si = withSi(defaults);
    expect(si.speed).toBe(0.1);
    expect(meetingOf(si.encounter).first.material?.name).toBe('bearing steel');
    expect(withSi(si)).toBe(si);
  });
  it('keeps the impact when it leaves SI', () => {
    const si = withSi(defaults);
    const back = withoutSi({ ...si, speed: 0.1 * barSpeed(si.encounter) });
    expect(back.speed).toBeCloseTo(0.1, 6);
    expect(valueOf(back, 'poisson')).toBe(0.3);
  });
  it('of every case leaves it in range, and a second body keeps its ratios', () => {
    for (const inputs of cases) {
      const other = meetingOf(inputs.encounter).si ? withoutSi(inputs) : withSi(inputs);
      expect([...problemsOf(other).values()]).toEqual([]);
      const plain = withoutSi(inputs);
      const round = withoutSi(withSi(plain));
      for (const field of fieldsOf(plain)) {
        if (!['inner', 'inner2', 'radius2', 'young2', 'density2', 'area2', 'thickness2'].includes(field)) continue;
        const [before, after] = [plain, round].map((each) => valueOf(each, field)) as [number, number];
        expect(Math.abs(after - before), field).toBeLessThanOrEqual(1e-4 * Math.abs(before));
      }
    }
  });
  it('makes what is of the same material the same material', () => {
    const block = withSi({ ...defaults, encounter: withAgainst(defaults.encounter, 'half-space') });
    expect(meetingOf(block.encounter).second!.material?.name).toBe('bearing steel');
  });
  it('nothing is changed in place', () => {
    const frozen = JSON.stringify(defaults);
    withSi(defaults);
    withKind(defaults.encounter, 'rod');
    withAgainst(defaults.encounter, 'body');
    expect(JSON.stringify(defaults)).toBe(frozen);
  });
});

describe('friction', () => {
  const fields = (inputs: Inputs): Field[] => fieldsOf(inputs).slice(-5);
  it('brings what is along the surface, and rods have none', () => {
    expect(fieldsOf(defaults).slice(-2)).toEqual(['speed', 'friction']);
    expect(fields({ ...defaults, friction: 0.3 })).toEqual(['coat', 'speed', 'friction', 'angle', 'spin']);
    const pair = { ...defaults, encounter: withAgainst(defaults.encounter, 'same'), friction: 0.3, second_spin: 1 };
    expect(fields(pair)).toEqual(['speed', 'friction', 'angle', 'spin', 'second_spin']);
    expect(motionOf(pair).second_spin).toBe(1);
    expect(motionOf({ ...pair, encounter: defaults.encounter }).second_spin).toBe(0);
    const rod = { ...pair, encounter: withKind(pair.encounter, 'rod') };
    expect(fieldsOf(rod).at(-1)).toBe('speed');
    expect(motionOf(rod)).toEqual({ speed: 0.1, friction: 0, angle: 0, spin: 0, second_spin: 0 });
  });
  it.each([['friction', '6', 'Friction: got 6, allowed 0 to 5'], ['angle', '90', 'Angle: got 90, allowed -90 to 90'],
    ['angle', '89', 'Angle: got 5.729'], ['spin', '2', 'Spin: got 2, allowed -1 to 1']] as [Field, string, string][])(
    'refuses %s %s', (field, text, line) =>
      expect(problem({ ...defaults, friction: 0.3 }, field, text)).toContain(line));
  it('keeps spins when units change', () => {
    const si = withSi({ ...defaults, friction: 0.3, spin: 0.1 });
    expect(si.spin).toBeCloseTo((0.1 * barSpeed(si.encounter)) / 0.01, -1);
    expect(withoutSi(si).spin).toBeCloseTo(0.1, 5);
  });
});

describe('kinds', () => {
  it('a rod meets no half-space, and a sphere has no plane', () => {
    const block = withAgainst(defaults.encounter, 'half-space');
    expect(withKind(block, 'rod').against).toBe('wall');
    expect(meetingOf(withKind(like(defaults.encounter, { si: true, plane: 'strain' }), 'sphere')).plane).toBe('stress');
  });
  it('a sphere gets a Poisson’s ratio that it may have', () => {
    const wide = { ...defaults, encounter: withValue(defaults.encounter, 'poisson', 0.9) };
    expect(problemsOf({ ...wide, encounter: withKind(wide.encounter, 'sphere') }).size).toBe(0);
  });
  it('what is not used does not make two encounters differ', () => {
    const other = (first: object) => like(defaults.encounter, { first: { ...unitBody, ...first } });
    expect(equal(other({ area: 3 }), defaults.encounter)).toBe(true);
    expect(equal(other({ poisson: 0.3 }), defaults.encounter)).toBe(false);
  });
  it('have short descriptions of their own', () => {
    const texts = cases.map(({ encounter }) => description(encounter));
    expect(new Set(texts).size).toBe(new Set(cases.map(({ encounter }) => JSON.stringify(encounter))).size);
    for (const text of texts) expect(text.length).toBeLessThan(90);
  });
});

describe('speeds', () => {
  it('the slider goes there and back', () => {
    const { encounter } = defaults;
    for (const place of [0, 1, 500, 999, steps]) expect(placeOf(encounter, speedAt(encounter, place))).toBe(place);
    expect(placeOf(defaults.encounter, 1e-8)).toBe(0);
    expect(placeOf(defaults.encounter, 1)).toBe(steps);
  });
  it('of curves in other units stand at the same share of the bar speed', () => {
    const si = withSi(defaults).encounter;
    expect(onAxisOf(defaults.encounter, si, 0.1 * barSpeed(si))).toBeCloseTo(0.1, 12);
    expect(onAxisOf(si, defaults.encounter, 0.1)).toBeCloseTo(0.1 * barSpeed(si), 9);
    expect(onAxisOf(si, si, 3)).toBe(3);
  });
  it('of the curve are all different, and begin with the ends of the range', () => {
    const speeds = curveSpeeds(defaults.encounter);
    expect(new Set(speeds).size).toBe(49);
    expect(Math.min(...speeds)).toBe(slowest);
    expect(Math.max(...speeds)).toBe(fastest(defaults.encounter));
  });
  it('end at half of the wave speed of a soft half-space, as far as it is the one that is pressed in', () => {
    const block = (young: number): number => fastest(
      like(defaults.encounter, { against: 'half-space', second: { ...unitBody, young } }));
    expect([block(1), block(100)]).toEqual([0.5, 0.5]);
    expect(block(0.01)).toBeCloseTo(0.5 * 0.1 * 1.01, 12); // c₂/c₁ over the share of the half-space
  });
});
