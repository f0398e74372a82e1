// Whatever stands in an address, the page has inputs that the core takes, and at most one line to say.
import { expect, it } from 'vitest';
import { fromAddress, toAddress } from '../../src/inputs/address';
import { problemsOf } from '../../src/inputs/check';
import { firstBall, motionOf } from '../../src/inputs/inputs';
import { cases, obliqueCases } from './cases';

/** Always the same numbers from 0 to 1 (Mulberry32). */
function randomFrom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

const words = ['&', '=', ':', ',', '?', '#', '%', '%0A', '%00', '%E2%80%A8', '%ED%A0%80', '+', ' ', '\n', '\u2212', '\ud800', '-', '.',
  'e9', 'e400', '0', '1', 'nan', 'Infinity', '0x1', '1_0', '__proto__', 'constructor', 'body=', 'against=', 'keep=', 'file=',
  'units=SI', 'plane=strain', 'disk', 'sphere', 'rod', 'plate', 'half-space', 'same', 'body', 'wall', 'nu=', 'nu2=', 'v=', 'mu=1', 'angle=',
  'spin=', 'spin2=', 'view=ball', 'material=', 'glass', 'drop=', 'R=', '<b>', '0,1', `0,${'1'.repeat(9999)}`, '9'.repeat(9999), '&a=1'.repeat(999), '&keep=body:disk,nu:0.3'.repeat(99)];

it('is read whatever it is', () => {
  const random = randomFrom(1);
  const one = <Item>(items: readonly Item[]): Item => items[Math.floor(random() * items.length)]!;
  const whole = [...cases, ...obliqueCases, firstBall].map(toAddress);
  const damaged = (): string => {
    let text = one(whole);
    for (let count = 1 + Math.floor(4 * random()); count > 0; --count) {
      const begin = Math.floor(random() * (text.length + 1));
      const end = Math.min(text.length, begin + Math.floor(random() * 12));
      text = text.slice(0, begin) + (random() < 0.8 ? one(words) : '') + text.slice(random() < 0.5 ? begin : end);
    }
    return text;
  };
  for (let count = 0; count < 500; ++count) {
    const text = damaged();
    const { inputs, problem } = fromAddress(`?${text}`);
    if (problem !== '') expect(problem, text).toMatch(/^The link is used except for this, [^\p{C}\p{Zl}\p{Zp}]{1,1000}\.$/u);
    expect([...problemsOf(inputs).values()], text).toEqual([]);
    expect(Object.values(motionOf(inputs)).every(Number.isFinite), text).toBe(true);
    const written = toAddress(inputs);
    expect(fromAddress(written).problem, `${text} as ${written}`).toBe('');
    expect(toAddress(fromAddress(written).inputs), text).toBe(written);
  }
});
