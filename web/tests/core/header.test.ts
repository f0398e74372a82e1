// The header in C is that of `stoss table`, but for the comment that says who made it.
import { describe, expect, it } from 'vitest';
import { encounterArguments } from '../../src/inputs/lines';
import { cases } from '../unit/cases';
import { hasCommand, run } from './native';
import { ask } from './wasm';

/** Text and numbers of a header apart; without comments. */
function parts(header: string): { text: string; numbers: number[] } {
  const code = header.replace(/\/\*[\s\S]*?\*\//g, '');
  const number = /-?\d+\.?\d*(e[-+]?\d+)?/g;
  return { text: code.replace(number, '#'), numbers: (code.match(number) ?? []).map(Number) };
}

describe.skipIf(!hasCommand)('header', { timeout: 60_000 }, () => {
  it.each([[0, 0.01, 0.2], [4, 1e-3, 0.1], [7, 50, 500]])('of case %i is that of the command', (index, from, to) => {
    const { encounter } = cases[index]!;
    const range = ['--speed', `${from}:${to}`, '--error', '0.01'];
    const native = parts(run(['table', ...encounterArguments(encounter), ...range]));
    const ours = parts(ask('header', encounter, { slowest: from, fastest: to, error: 0.01 }).value);
    expect(ours.text).toBe(native.text);
    expect(ours.numbers.length).toBe(native.numbers.length);
    ours.numbers.forEach((value, k) => {
      expect(Math.abs(value - native.numbers[k]!)).toBeLessThanOrEqual(1e-12 * Math.max(1, Math.abs(value)));
    });
  });
});
