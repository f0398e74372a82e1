// Values with their errors, always with ±: the error has two digits, and the value ends where they end.
import { powerOfTen } from '../drawing/numbers';

export const unknownError = 'unknown';

/** An error as large as this share of its value is worth one digit only. */
const rough = 0.1;

/** Digits behind the point beyond which powers of ten are easier to read. */
const mostDecimals = 8;

/** A value with its error: 0.947060 ± 0.000031, 0.99574253 ± 3.7×10⁻⁷, (3.49794 ± 0.00014)×10⁻¹⁹, 9 ± 5. */
export function withError(value: number, error: number): string {
  if (Number.isFinite(value) && !Number.isFinite(error)) return `${significant(value, 6)} ± ${unknownError}`;
  if (error === 0 || !Number.isFinite(value)) return `${significant(value, 12)} ± 0`;
  const size = Math.abs(value);
  const digits = error > rough * size ? 1 : 2;
  const [mantissa = '', last = '0'] = error.toExponential(digits - 1).split('e');
  const decimals = digits - 1 - Number(last);
  if (size > error && size < 1e-4) {
    const power = Number(size.toExponential().split('e')[1]);
    const raised = (number: number): string => (number / 10 ** power).toFixed(Math.max(decimals + power, 0));
    return `(${raised(value)} ± ${raised(error)})×${powerOfTen(power)}`;
  }
  if (decimals < 0) return `${rounded(value, decimals)} ± ${rounded(error, decimals)}`;
  const shown = value.toFixed(Math.min(decimals, 15));
  return decimals < mostDecimals
    ? `${shown} ± ${error.toFixed(decimals)}`
    : `${shown} ± ${mantissa}×${powerOfTen(Number(last))}`;
}

/** A whole number, of which −decimals digits before the point are not known. */
function rounded(value: number, decimals: number): string {
  const unit = 10 ** -decimals;
  return String(Math.round(value / unit) * unit);
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
