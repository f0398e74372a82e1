// What a collision does at one time, in words.

import { max } from 'd3-array';
import type { Course } from '../core/protocol';
import { interpolate, unitInWords, withUnit, written } from '../drawing/numbers';

export type Phase = 'approach' | 'compression' | 'restitution' | 'apart';

/** Before contact; while the bodies still approach each other; while they part; after contact. */
export function phaseAt(collision: Course, time: number): Phase {
  if (time < collision.begin) return 'approach';
  if (time > collision.end) return 'apart';
  const first = collision.velocity[0] ?? 0;
  return interpolate(collision.time, collision.velocity, time) * first > 0 ? 'compression' : 'restitution';
}

/** A time with its unit, the same for all times of a collision. */
export function timeInWords(collision: Course, time: number): string {
  return withUnit(time, collision.units.time, 3, collision.end);
}

/** How much slower a film is that shows `span`, in units of time, within `seconds`. */
export function slowness(span: number, unit: string, seconds: number): string {
  const each = span / seconds;
  if (unit === 's') return `Slowed ${written(1 / each, 2)} times.`;
  return `1 s of the film is ${written(each, 2)} ${unitInWords(unit)}.`;
}

/** One sentence for those who do not see the picture. */
export function describe(collision: Course, time: number): string {
  const phase = phaseAt(collision, time);
  const touching = time >= collision.begin && time <= collision.end;
  const force = touching ? Math.max(0, interpolate(collision.time, collision.force, time)) : 0;
  const greatest = Math.max(0, max(collision.force) ?? 0);
  const share = greatest > 0 ? Math.round((100 * force) / greatest) : 0;
  const inWords = withUnit(force, collision.units.force, 3, greatest);
  return `${phase}, time ${timeInWords(collision, time)}, force ${inWords}, ${share} % of the maximum`;
}
