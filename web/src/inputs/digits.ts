// Values as the command prints them: the error has two digits, and the value ends where they end.

export const unknownError = 'unknown';

/** A value with its error: 0.947060 ± 0.000031, 0.99574253(37), 3.49794(14)e-19. */
export function withError(value: number, error: number): string {
  if (Number.isFinite(value) && !Number.isFinite(error)) return `${significant(value, 6)} ± ${unknownError}`;
  const most = 12;
  let decimals = most;
  if (error > 0) decimals = Math.max(1 - Math.floor(Math.log10(error)), 0);
  const size = Math.abs(value);
  if (decimals > most && size < 1e-6 && error < size && error > 1e-15 * size) return inPowersOfTen(value, error);
  decimals = Math.min(decimals, most);
  if (decimals < 8) return `${value.toFixed(decimals)} ± ${error.toFixed(decimals)}`;
  return `${value.toFixed(decimals)}(${(error * 10 ** decimals).toFixed(0)})`;
}

/** As in 3.49794(14)e-19: the error counts units of the last digit of the value. */
function inPowersOfTen(value: number, error: number): string {
  const doubt = error.toExponential(1);
  const last = Number(doubt.slice(4)) - 1;
  const digits = String(Math.round(Math.abs(value) / 10 ** last));
  const power = last + digits.length - 1;
  const shown = `e${power < 0 ? '-' : '+'}${String(Math.abs(power)).padStart(2, '0')}`;
  return `${value < 0 ? '-' : ''}${digits[0]}.${digits.slice(1)}(${doubt[0]}${doubt[2]})${shown}`;
}

/** A value to some significant digits without trailing zeros, as %g prints it. */
export function significant(value: number, digits: number): string {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const text = value.toPrecision(digits);
  const [mantissa = '', power] = text.split('e');
  const short = mantissa.includes('.') ? mantissa.replace(/\.?0+$/, '') : mantissa;
  const size = Math.abs(value);
  if (power === undefined && size < 1e-4) return value.toExponential(digits - 1).replace(/\.?0+e/, 'e');
  return power === undefined ? short : `${short}e${power.replace('+', '')}`;
}

const prefixes: readonly [number, string][] = [
  [1e-12, 'p'], [1e-9, 'n'], [1e-6, 'µ'], [1e-3, 'm'], [1, ''], [1e3, 'k'], [1e6, 'M'], [1e9, 'G'],
];

/** The factor and the unit with the prefix that gives a value 1 to 1000: 5.2e-5 s is 52 µs. */
export function prefixed(value: number, unit: string): { factor: number; unit: string } {
  const size = Math.abs(value);
  const known = /^(s|m|N|m\/s|N\/m|Pa)$/.test(unit);
  const found = [...prefixes].reverse().find(([scale]) => size >= scale * 0.99999);
  if (!known || found === undefined || size >= 1e12) return { factor: 1, unit };
  return { factor: 1 / found[0], unit: found[1] + unit };
}
