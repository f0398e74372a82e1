import { describe, expect, it } from 'vitest';
import { fromAddress, toAddress } from '../../src/inputs/address';
import { problemsOf } from '../../src/inputs/check';
import { equal } from '../../src/inputs/document';
import { withValue } from '../../src/inputs/fields';
import { defaults, firstBall, isBall, motionOf, presetOf, presets, withAgainst } from '../../src/inputs/inputs';
import { cases, obliqueCases } from './cases';

const first = 'view=ball&material=structural%20steel&R';

describe('the address', () => {
  it('is short and readable', () => {
    expect(toAddress(defaults)).toBe('body=disk&nu=0.33&v=0.1');
  });
  it('gives all inputs back', () => {
    for (const inputs of [...cases, ...obliqueCases]) {
      const { inputs: back, problem } = fromAddress(`?${toAddress(inputs)}`);
      expect(problem).toBe('');
      expect(motionOf(back)).toEqual(motionOf(inputs));
      expect(equal(back.encounter, inputs.encounter), toAddress(inputs)).toBe(true);
      expect(back.kept.length).toBe(inputs.kept.length);
      back.kept.forEach((kept, index) => expect(equal(kept, inputs.kept[index]!)).toBe(true));
      expect(toAddress(back)).toBe(toAddress(inputs));
    }
  });
  it('survives the escaping of mail programs', () => {
    const text = toAddress(cases[1]!).replaceAll(':', '%3A').replaceAll(',', '%2C');
    expect(toAddress(fromAddress(text).inputs)).toBe(toAddress(cases[1]!));
  });
  it('may name its version', () => {
    expect(fromAddress('body=disk&nu=0.33&v=0.1&version=1')).toEqual({ inputs: defaults, problem: '' });
  });
  it('without anything is the default', () => {
    for (const text of ['', '?', '#']) expect(fromAddress(text)).toEqual({ inputs: firstBall, problem: '' });
  });
  it('of a real ball has names and a height, and gives every one back', () => {
    expect(toAddress(firstBall)).toBe('view=ball&material=glass&R=0.008&material2=granite&drop=0.3');
    const balls = presets.filter(({ encounter }) => isBall(encounter)).map(({ name: _, ...impact }) => ({ ...firstBall, ...impact }));
    const pair = { ...firstBall, encounter: withAgainst(firstBall.encounter, 'same') };
    const lossless = { ...firstBall, encounter: withValue(firstBall.encounter, 'loss_time2', 0) };
    for (const inputs of [...balls, pair, lossless]) {
      const { inputs: back, problem } = fromAddress(toAddress(inputs));
      expect(problem).toBe('');
      expect(back).toEqual(inputs);
    }
  });
  it.each([
    ['body=cube&nu=0.3&v=0.2', 'body=disk&nu=0.3&v=0.2', 'body: got “cube”, allowed disk, sphere, hollow-sphere, rod'],
    ['body=disk&nu=0.4', 'body=disk&nu=0.4&v=0.1', 'v: got none, allowed a number'],
    ['body=disk&v=0.2', 'body=disk&nu=0.33&v=0.2', 'nu: got none, allowed a number'],
    ['body=disk&nu=0.4&v=0,1', 'body=disk&nu=0.4&v=0.1', 'v: got “0,1”, write it with a point: 0.1'],
    ['body=disk&nu=2&v=0.2', 'body=disk&nu=0.33&v=0.2', '2‑D Poisson’s ratio: got 2, allowed -0.95 to 0.995'],
    ['body=disk&nu=0.4&v=7', 'body=disk&nu=0.4&v=0.1', 'Speed of approach: got 7, allowed 1e-8 to 1 c'],
    ['body=disk&nu=0.4&v=0.2&colour=red', 'body=disk&nu=0.4&v=0.2', 'colour: got an unknown key, allowed body'],
    ['body=disk&nu=0.4&v=0.2&version=2', 'body=disk&nu=0.4&v=0.2', 'version: got “2”, allowed 1'],
    ['body=disk&nu=0.4&v=0.2&R=3', 'body=disk&nu=0.4&v=0.2', 'R: got a key that this encounter does not have'],
    ['body=disk&nu=0.3&nu=0.4&v=0.2', 'body=disk&nu=0.3&v=0.2', 'nu: got twice, allowed once'],
    ['nu=0.4&v', 'body=disk&nu=0.4&v=0.1', 'v: got no value'],
    ['nu=0.4&v=__proto__', 'body=disk&nu=0.4&v=0.1', 'v: got \'__proto__\', allowed '],
    ['nu=0.4&v=0.2&%E0%A4%A=1', 'body=disk&nu=0.4&v=0.2', '%E0%A4%A: got an unknown key'],
    ['<script>', 'body=disk&nu=0.33&v=0.1', '<script>: got no value'],
    ['body=rod&v=0.2&against=half-space', 'body=rod&v=0.2', 'against: got “half-space”, allowed wall, same, body'],
    ['body=rod&v=0.2&against=plate', 'body=rod&v=0.2', 'against: got “plate”, allowed wall, same, body'],
    ['nu=0.4&v=0.2&against=plate&nu2=0.3&E2=1&rho2=1', 'body=disk&nu=0.4&against=plate&nu2=0.3&E2=1&rho2=1&h2=1&v=0.2',
      'h2: got none, allowed a number'],
    ['nu=0.4&v=0.2&against=plate&nu2=0.3&E2=1&rho2=1&h2=0',
      'body=disk&nu=0.4&against=plate&nu2=0.3&E2=1&rho2=1&h2=1&v=0.2', 'Thickness of what it meets: got 0, allowed'],
    ['body=rod&v=0.2&against=body&E2=1e9&rho2=1&R2=2&A2=3', 'body=rod&against=body&E2=1&rho2=1&R2=1&A2=1&v=0.2',
      'Length of what it meets, transit time ratio: got 6.32456e-5, allowed 0.001 to 1000 (of the second'],
    ['nu=0.4&v=0.2&keep=body:cube,nu:0.3&keep=body:disk,nu:0.5', 'body=disk&nu=0.4&v=0.2&keep=body:disk,nu:0.5',
      'keep: body: got “cube”'],
    ['nu=0.4&v=0.2&keep=body:disk,nu:7', 'body=disk&nu=0.4&v=0.2', 'keep: 2‑D Poisson’s ratio: got 7'],
    [`nu=0.4&v=0.2${'&keep=body:disk,nu:0.3'.repeat(9)}`, `body=disk&nu=0.4&v=0.2${'&keep=body:disk,nu:0.3'.repeat(5)}`,
      'keep: got 9 curves, allowed 5'],
    ['body=sphere&units=SI&nu=0.3&E=2e11&rho=7850&v=2', 'body=sphere&units=SI&nu=0.3&E=2e11&rho=7850&R=0.01&v=2',
      'R: got none, allowed a number'],
    ['body=sphere&units=SI&nu=0.3&E=1&rho=7850&R=1&v=5', 'body=sphere&units=SI&nu=0.3&E=1&rho=7850&R=1&v=0.00113',
      'Speed of approach: got 5'],
    ['body=sphere&units=SI&nu=0.3&E=0&rho=7850&R=1', 'body=sphere&units=SI&nu=0.3&E=2.1e11&rho=7850&R=1&v=0.1',
      'Young’s modulus: got 0, allowed above 0, 1e-30 to 1e30'],
    ['nu=0.4&v=0.2&spin=1', 'body=disk&nu=0.4&v=0.2', 'spin: got a key that this encounter does not have'],
    ['body=rod&v=0.2&mu=1', 'body=rod&v=0.2', 'mu: got a key that this encounter does not have'],
    ['nu=0.4&v=0.2&mu=6', 'body=disk&nu=0.4&v=0.2', 'Friction: got 6, allowed 0 to 5'],
    ['nu=0.4&v=0.2&mu=1&angle=91&spin=0.1', 'body=disk&nu=0.4&v=0.2&mu=1&spin=0.1', 'Angle: got 91, allowed -90 to 90'],
    ['nu=0.4&v=0.2&view=none', 'body=disk&nu=0.4&v=0.2', 'view: got “none”, allowed full, simple'],
    ['view=ball&material=gold&R=0.01&drop=1', `${first}=0.01&material2=structural%20steel&drop=1`, 'material: got “gold”, allowed'],
    ['view=ball&R=0.01&v=1', `${first}=0.01&material2=structural%20steel&drop=0.3`, 'drop: got none, allowed a number'],
    ['view=ball&R=0.01&drop=-1', `${first}=0.01&material2=structural%20steel&drop=0.3`, 'Speed of approach: got -4.42869'],
  ])('keeps what is right of %s, and says in one line what is not', (text, right, line) => {
    const { inputs, problem } = fromAddress(text);
    expect(toAddress(inputs)).toBe(right);
    expect(problem).toMatch(/^The link is used except for this, where the default applies: [^\n]+\.$/);
    expect(problem).toContain(line);
    expect(problem.length).toBeLessThan(260);
  });
  it('of the simple view keeps it', () => {
    const { inputs, problem } = fromAddress('nu=0.4&v=0.2&view=simple');
    expect([inputs.view, problem]).toEqual(['simple', '']);
    expect(toAddress(inputs)).toBe('body=disk&nu=0.4&v=0.2&view=simple');
  });
  it('tells a few of many problems', () => {
    expect(fromAddress('a=1&b=1&c=1&d=1&e=1').problem).toMatch(/; and 4 more\.$/);
  });
  it('of every example gives it back', () => {
    for (const { name, ...preset } of presets) {
      const { inputs, problem } = fromAddress(toAddress({ ...defaults, ...preset }));
      expect(problem).toBe('');
      expect(presetOf(inputs)?.name).toBe(name);
      expect([...problemsOf(inputs).values()]).toEqual([]);
    }
  });
});
