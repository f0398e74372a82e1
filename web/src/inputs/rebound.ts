// How high a body bounces that falls on what it meets: ε²h, from the height h = v²/2g.
import type { Encounter, Quantity } from '../core/protocol';

/** Standard gravity, m/s². */
const gravity = 9.80665;

export interface Rebound {
  /** m; undefined without SI */
  readonly drop: number | undefined;
  /** m, or without SI in units of the drop */
  readonly height: Quantity;
}

/** The rebound of a body from what rests; undefined for one that meets another body, which moves too. */
export function reboundOf({ si, against }: Encounter, speed: number, restitution: Quantity): Rebound | undefined {
  if (against === 'same' || against === 'body') return undefined;
  const { value, error } = restitution;
  const drop = si ? speed ** 2 / (2 * gravity) : undefined;
  const unit = drop ?? 1;
  const height: Quantity = { value: value ** 2 * unit, unit: si ? 'm' : '' };
  if (error !== undefined) height.error = 2 * value * error * unit;
  return { drop, height };
}
