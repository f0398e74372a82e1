import { describe, expect, it } from 'vitest';
import { prefixFor, significant, withError } from '../../src/drawing/numbers';

describe('digits', () => {
  it.each([
    [0.9470600986481247, 3.127668637904846e-5, '0.947060 ± 0.000031'],
    [0.10307716954860428, 5.924e-5, '0.103077 ± 0.000059'],
    [0.16962, 0.00016, '0.16962 ± 0.00016'],
    [0.9957425321, 3.7e-7, '0.99574253 ± 3.7×10⁻⁷'],
    [3.497942e-19, 1.4e-23, '(3.49794 ± 0.00014)×10⁻¹⁹'],
    [-3.497942e-19, 1.4e-23, '(-3.49794 ± 0.00014)×10⁻¹⁹'],
    [0.4002, 0.0014, '0.4002 ± 0.0014'],
    [12.34, 4.2, '12 ± 4'],
    [4924, 985, '5000 ± 1000'],
    [9.53, 4.96, '10 ± 5'],
    [5.87e-6, 7e-8, '(5.870 ± 0.070)×10⁻⁶'],
    [0.0037, 0.021, '0.00 ± 0.02'],
    [1234.4, 42, '1234 ± 42'],
    [0.5, 0, '0.5 ± 0'],
  ] as [number, number, string][])('of %d with the error %d', (value, error, text) => {
    expect(withError(value, error)).toBe(text);
  });
  it('an unknown error is said to be unknown', () => {
    expect(withError(0.5, Infinity)).toBe('0.5 ± unknown');
    expect(withError(0.5, NaN)).toBe('0.5 ± unknown');
  });
  it('significant digits have no trailing zeros', () => {
    expect([significant(0.1, 6), significant(5172.194, 4), significant(1e-8, 6), significant(2.1e11, 3),
      significant(0, 3),
      significant(1.93341e-6, 4), significant(100, 3), significant(1e6, 6)])
      .toEqual(['0.1', '5172', '1e-8', '2.1e11', '0', '1.933e-6', '100', '1e6']);
  });
  it('prefixes keep values between 1 and 1000', () => {
    expect(prefixFor(5.168e-5, 's')).toEqual({ size: 1e-6, unit: 'µs' });
    expect(prefixFor(2352, 'N').unit).toBe('kN');
    expect(prefixFor(0.05, 'piRE')).toEqual({ size: 1, unit: 'πRE' });
    expect(prefixFor(0, 's')).toEqual({ size: 1, unit: 's' });
  });
});
