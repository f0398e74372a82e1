// Numbers as people type them.

/** A number, or in one line what is wrong with the text. */
export type Parsed = { value: number } | { problem: string };

const decimal = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** Read one decimal number, as in 0.33 or 1e-4; everything else gives a reason. */
export function parseNumber(name: string, text: string): Parsed {
  const trimmed = text.trim().replace(/^\u2212/, '-').replace(/e\u2212/i, 'e-');
  const refuse = (reason: string): Parsed => ({ problem: `${name}: ${reason}` });
  if (trimmed === '') return refuse('a number is missing (one decimal number, as in 0.33 or 1e-4)');
  const got = `got “${trimmed.length > 24 ? `${trimmed.slice(0, 24)}…` : trimmed}”`;
  if (/^[+-]?\d*,\d+(e[+-]?\d+)?$/i.test(trimmed)) {
    return refuse(`${got}, write it with a point: ${trimmed.replace(',', '.')}`);
  }
  if (!decimal.test(trimmed)) return refuse(`${got}, not a decimal number (allowed: one such as 0.33 or 1e-4)`);
  const value = Number(trimmed);
  const zero = !/[1-9]/.test(trimmed.split(/e/i)[0] ?? '');
  if (!Number.isFinite(value) || (value === 0 && !zero)) {
    return refuse(`${got}, beyond double precision, about 1e-308 to 1e308`);
  }
  return { value: value === 0 ? 0 : value };
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
