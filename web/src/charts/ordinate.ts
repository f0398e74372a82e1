// What is drawn of a coefficient of restitution.

/** What is drawn of a speed: ε, or the lost share of the energy 1 − ε². */
export type Ordinate = 'restitution' | 'loss';

/** A value with the ends of its error bar; they are missing where the error is unknown. */
export interface Bar {
  value: number;
  low?: number;
  high?: number;
}

/** What a point is on the vertical axis: of 1 − ε² the error is 2 ε times that of ε. */
export function barOf(ordinate: Ordinate, restitution: number, error: number): Bar {
  const ratio = ordinate === 'restitution';
  const value = ratio ? restitution : 1 - restitution * restitution;
  const reach = ratio ? error : 2 * Math.abs(restitution) * error;
  return { value, ...(Number.isFinite(error) && { low: value - reach, high: value + reach }) };
}
