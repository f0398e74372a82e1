// Numbers as people type them, and as they are shown in a field.
import { numberOf } from '../core/local';
import { CoreError } from '../core/protocol';

/** A number, or in one line what is wrong with the text. */
export type Parsed = { value: number } | { problem: string };

/** Read one decimal number, as in 0.33 or 1e-4; everything else gives a reason. */
export function parseNumber(name: string, text: string): Parsed {
  const typed = text.trim().replaceAll('\u2212', '-');
  if (/^[+-]?\d*,\d+(e[+-]?\d+)?$/i.test(typed)) {
    return { problem: `${name}: got “${typed}”, write it with a point: ${typed.replace(',', '.')}` };
  }
  try {
    const value = numberOf(name, typed);
    return { value: value === 0 ? 0 : value };
  } catch (error) {
    if (error instanceof CoreError) return { problem: error.message };
    throw error;
  }
}

/** The text of a number in a field: short enough to be read there. Typed again unchanged, it is that very number. */
export function displayed(value: number): string {
  const whole = shortest(value);
  return whole.length <= 9 ? whole : shortest(Number(value.toPrecision(6)));
}

/** The shortest decimal text that gives the same number back; far from 1 with a power of ten: 0.005, 1e-7, 2.1e11. */
export function shortest(value: number): string {
  const plain = String(value);
  const size = Math.abs(value);
  if (size === 0 || (size >= 1e-4 && size < 1e6)) return plain;
  const scientific = value.toExponential().replace('e+', 'e');
  return scientific.length < plain.length ? scientific : plain.replace('e+', 'e');
}
