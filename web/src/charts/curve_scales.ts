// The axes of a chart of ε against the speed, and what a point is on them.

import type { CurvePoint } from '../core/protocol';
import type { Axis } from '../drawing/plot';

/** An axis without its label. */
export type Scale = Omit<Axis, 'label'>;

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
  const known = Number.isFinite(error);
  if (ordinate === 'restitution') {
    return { value: restitution, ...(known && { low: restitution - error, high: restitution + error }) };
  }
  const value = 1 - restitution * restitution;
  const reach = 2 * Math.abs(restitution) * error;
  return { value, ...(known && { low: value - reach, high: value + reach }) };
}

export interface Current {
  speed: number;
  restitution: number;
  error: number;
}

const LEAST = 1e-7; // of 1 − ε² on a logarithmic axis

/** A logarithmic axis for all speeds, those computed and those planned. */
export function speedScale(speeds: number[]): Scale {
  const positive = speeds.filter((each) => each > 0 && Number.isFinite(each));
  if (!positive.length) return { low: 1e-4, high: 0.3, log: true };
  const [low, high] = [Math.min(...positive), Math.max(...positive)];
  const margin = high > low ? (high / low) ** 0.025 : 3;
  return { low: low / margin, high: high * margin, log: true };
}

/** An axis for all values with their errors: linear for ε, logarithmic for 1 − ε². */
export function ordinateScale(ordinate: Ordinate, all: { restitution: number; error: number }[]): Scale {
  const log = ordinate === 'loss';
  let [low, high] = [Infinity, -Infinity];
  for (const { restitution, error } of all) {
    if (!Number.isFinite(restitution)) continue;
    const bar = barOf(ordinate, restitution, error);
    if (log && !(bar.value > LEAST)) continue;
    const floor = log ? Math.max(LEAST, 0.2 * bar.value) : -Infinity; // an error bar down to 0 would have no end
    low = Math.min(low, bar.value, Math.max(floor, bar.low ?? bar.value));
    high = Math.max(high, bar.value, bar.high ?? bar.value);
  }
  if (!(high >= low)) return log ? { low: 1e-4, high: 1, log } : { low: 0, high: 1, log };
  if (log) {
    const margin = Math.max(1.15, (high / low) ** 0.06);
    return { low: low / margin, high: high * margin, log };
  }
  const pad = Math.max(0.06 * (high - low), 0.005);
  const top = high <= 1 ? Math.min(1.002, high + pad) : high + pad;
  return { low: Math.max(Math.min(low, 0), low - pad), high: top, log };
}

/** The point of a curve nearest to a speed, by the logarithm. */
export function nearestPoint(points: CurvePoint[], speed: number): CurvePoint | undefined {
  const distance = (each: CurvePoint): number => Math.abs(Math.log(each.speed / speed));
  return points.reduce<CurvePoint | undefined>((best, each) =>
    (best === undefined || distance(each) < distance(best) ? each : best), undefined);
}
