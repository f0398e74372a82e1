// Numbers, with their errors and units, as readers know them; and between those of a sampled function.
import { bisectRight } from 'd3-array';
import { say } from './words';

const RAISED = '⁰¹²³⁴⁵⁶⁷⁸⁹';

function raised(number: number | string): string {
  return String(number).replace(/\d/g, (digit) => RAISED[Number(digit)]!).replace('-', '⁻');
}

/** The shortest decimal text that gives the same number back; far from 1 with a power of ten: 0.005, 1e-7, 2.1e11. */
export function shortest(value: number): string {
  const plain = String(value);
  const size = Math.abs(value);
  if (size === 0 || (size >= 1e-4 && size < 1e6)) return plain;
  const scientific = value.toExponential().replace('e+', 'e');
  return scientific.length < plain.length ? scientific : plain.replace('e+', 'e');
}

/** A value to some significant digits. */
export function rounded(value: number, digits: number): number {
  return Number(value.toPrecision(digits));
}

/** The text of a value to some significant digits, without trailing zeros. */
export function significant(value: number, digits: number): string {
  return shortest(rounded(value, digits));
}

/** The text of a number in a field: short enough to be read there. Typed again unchanged, it is that very number. */
export function displayed(value: number): string {
  const whole = shortest(value);
  return whole.length <= 9 ? whole : significant(value, 6);
}

/** A number for readers: a few digits, a minus sign, a power of ten where there would be many zeros. */
export function written(value: number, digits = 4): string {
  if (Number.isNaN(value)) return '–';
  const [mantissa, power = 0] = value.toExponential(digits - 1).split('e').map(Number) as [number, number?];
  const plain = (power >= -3 && power < 6) || !Number.isFinite(value);
  const text = plain ? String(rounded(value, digits)) : `${mantissa}×${powerOfTen(power)}`.replace(/^(-?)1×/, '$1');
  return text.replace('-', '−').replace('Infinity', '∞');
}

/** 10 to an integer power, with a raised exponent. */
export function powerOfTen(exponent: number): string {
  return `10${raised(exponent)}`;
}

/** An error as large as this share of its value is worth one digit only. */
const ROUGH = 0.1;

/** Digits behind the point beyond which powers of ten are easier to read. */
const MOST_DECIMALS = 8;

/** A value with its error, always with ±: the error has two digits, and the value ends where they end. 0.947060 ±
 *  0.000031, 0.99574253 ± 3.7×10⁻⁷, (3.49794 ± 0.00014)×10⁻¹⁹, 9 ± 5. */
export function withError(value: number, error: number): string {
  if (Number.isFinite(value) && !Number.isFinite(error)) return `${significant(value, 6)} ± ${say('number.unknown')}`;
  if (error === 0 || !Number.isFinite(value)) return `${significant(value, 12)} ± 0`;
  const size = Math.abs(value);
  const digits = error > ROUGH * size ? 1 : 2;
  const [mantissa = '', last = '0'] = error.toExponential(digits - 1).split('e');
  const decimals = digits - 1 - Number(last);
  if (size > error && size < 1e-4) {
    const power = Number(size.toExponential().split('e')[1]);
    const lifted = (number: number): string => (number / 10 ** power).toFixed(Math.max(decimals + power, 0));
    return `(${lifted(value)} ± ${lifted(error)})×${powerOfTen(power)}`;
  }
  if (decimals < 0) {
    const unit = 10 ** -decimals;
    return [value, error].map((each) => String(Math.round(each / unit) * unit)).join(' ± ');
  }
  const shown = value.toFixed(Math.min(decimals, 15));
  return `${shown} ± ${decimals < MOST_DECIMALS ? error.toFixed(decimals) : `${mantissa}×${powerOfTen(Number(last))}`}`;
}

/** A value and the band around it, with the digits that the width of the band is worth: 0.81, 0.70 to 1.00. */
export function bandInWords(value: number, low: number, high: number): { value: string; band: string } {
  if (![value, low, high].every(Number.isFinite)) return { value: '–', band: say('number.unknown') };
  const width = high - low;
  const decimals = width > 0 ? Math.min(MOST_DECIMALS, Math.max(2, 1 - Math.floor(Math.log10(width)))) : 2;
  const [shown, from, to] = [value, low, high].map((each) => each.toFixed(decimals));
  return { value: shown!, band: say('number.range', { from: from!, to: to! }) };
}

/** A unit as readers know it: πRE for the core's piRE, mc²/R for mc^2/R. */
export function unitInWords(unit: string): string {
  return unit.replace(/^pi/, 'π').replace(/\^(-?\d)/g, (_, power: string) => raised(power));
}

/** A positive number as a power of ten times one of 1 … 10. */
function split(value: number): [power: number, lead: number] {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-12);
  return [power, value / power];
}

/** The least of 1, 2 and 5 times a power of ten that is not below `value`. */
export function roundUp(value: number): number {
  const [power, lead] = split(value);
  return power * [1, 2, 5, 10].find((each) => lead <= each + 1e-9)!;
}

/** The maximum of 1, 2 and 5 times a power of ten that is not above `value`. */
export function roundDown(value: number): number {
  const [power, lead] = split(value);
  return power * [5, 2, 1].find((each) => lead >= each - 1e-9)!;
}

const PREFIXES: [number, string][] = [
  [1e9, 'G'], [1e6, 'M'], [1e3, 'k'], [1, ''], [1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n'], [1e-12, 'p'],
];
const PREFIXED = new Set(['s', 'm', 'N', 'N/m', 'Pa', 'Hz']);

/** A unit with the prefix that suits values up to `greatest`, and its size in the unit without; units that are not of
 *  SI stay what they are. */
export function prefixFor(greatest: number, unit: string): { size: number; unit: string } {
  if (!PREFIXED.has(unit) || !(Math.abs(greatest) > 0)) return { size: 1, unit: unitInWords(unit) };
  const [size, prefix] = PREFIXES.find(([each]) => Math.abs(greatest) >= each * (1 - 1e-9)) ?? PREFIXES.at(-1)!;
  return { size, unit: prefix + unit };
}

/** A value with its unit, whose prefix suits `greatest`. */
export function withUnit(value: number, unit: string, digits = 3, greatest = value): string {
  const prefix = prefixFor(greatest, unit);
  return `${written(value / prefix.size, digits)} ${prefix.unit}`.trimEnd();
}

/** A sampled function at a place between its samples, by lines; beyond them its first or last value. */
export function interpolate(places: ArrayLike<number>, values: ArrayLike<number>, place: number): number {
  const k = bisectRight(places, place) - 1;
  if (k < 0) return values[0] ?? NaN;
  if (k >= places.length - 1) return values[places.length - 1]!;
  const share = (place - places[k]!) / (places[k + 1]! - places[k]!);
  return values[k]! + share * (values[k + 1]! - values[k]!);
}
