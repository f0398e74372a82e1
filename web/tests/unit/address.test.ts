import { describe, expect, it } from 'vitest';
import { fromAddress, toAddress } from '../../src/inputs/address';
import { defaults, equal } from '../../src/inputs/inputs';
import { cases } from './cases';

describe('the address', () => {
  it('is short and readable', () => {
    expect(toAddress(defaults)).toBe('body=disk&nu=0.33&v=0.1');
  });
  it('gives all inputs back', () => {
    for (const inputs of cases) {
      const { inputs: back, problem } = fromAddress(`?${toAddress(inputs)}`);
      expect(problem).toBe('');
      expect(back.speed).toBe(inputs.speed);
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
  it('without anything is the default', () => {
    for (const text of ['', '?', '#']) expect(fromAddress(text)).toEqual({ inputs: defaults, problem: '' });
  });
  it.each([
    'body=cube&nu=0.3&v=0.1', 'body=disk&nu=0.33', 'body=disk&v=0.1', 'body=disk&nu=0.33&v=0,1', 'body=disk&nu=2&v=0.1',
    'body=disk&nu=0.33&v=0.1&colour=red', 'body=disk&nu=0.33&nu=0.4&v=0.1', 'body=disk&nu=0.33&v=nan', 'v',
    '%E0%A4%A&v=1',
    'body=rod&v=0.1&against=half-space&E2=1&rho2=1', 'body=disk&nu=0.33&v=0.1&keep=body:cube',
    'body=disk&nu=0.33&v=0.1&keep=body:disk,nu:7', `body=disk&nu=0.33&v=0.1${'&keep=body:disk,nu:0.3'.repeat(9)}`,
    'body=sphere&units=SI&nu=0.3&E=2e11&rho=7850&v=1', '<script>', 'body=disk&nu=0.33&v=__proto__',
  ])('that is bad (%s) gives the default and one line', (text) => {
    const { inputs, problem } = fromAddress(text);
    expect(inputs).toEqual(defaults);
    expect(problem).toMatch(/^The link is not readable, so this is the default\. [^\n]+$/);
    expect(problem.length).toBeLessThan(220);
  });
});
