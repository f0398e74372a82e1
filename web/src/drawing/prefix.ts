// Prefixes of SI units.

import { unitInWords, written } from './ticks';

const PREFIXES: [number, string][] = [
  [1e9, 'G'], [1e6, 'M'], [1e3, 'k'], [1, ''], [1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n'],
];
const PREFIXED = new Set(['s', 'm', 'N', 'N/m', 'Pa', 'Hz']);

/** A unit with the prefix that suits values up to `greatest`, and its size in the unit without; units that are not of
 *  SI stay what they are. */
export function prefixFor(greatest: number, unit: string): { size: number; unit: string } {
  if (!PREFIXED.has(unit) || !(Math.abs(greatest) > 0)) return { size: 1, unit: unitInWords(unit) };
  const fitting = PREFIXES.find(([size]) => Math.abs(greatest) >= size * (1 - 1e-9)) ?? PREFIXES[PREFIXES.length - 1]!;
  return { size: fitting[0], unit: fitting[1] + unit };
}

/** A value with its unit, whose prefix suits `greatest`. */
export function withUnit(value: number, unit: string, digits = 3, greatest = value): string {
  const prefix = prefixFor(greatest, unit);
  const number = written(value / prefix.size, digits);
  return prefix.unit ? `${number} ${prefix.unit}` : number;
}
