// A collision in units that suit its numbers.

import type { Collision } from '../core/protocol';
import { prefixFor } from '../drawing/prefix';

/** The same collision with prefixes of SI that suit its times and forces; `second`: its unit of time in the old one. */
export function readable(collision: Collision): { collision: Collision; second: number } {
  const { time, force, units } = collision;
  const of = (values: Float64Array): number => values.reduce((most, each) => Math.max(most, Math.abs(each)), 0);
  const [seconds, newtons] = [prefixFor(of(time), units.time), prefixFor(of(force), units.force)];
  return {
    second: seconds.size,
    collision: {
      ...collision,
      units: { ...units, time: seconds.unit, force: newtons.unit },
      time: time.map((each) => each / seconds.size),
      force: force.map((each) => each / newtons.size),
      begin: collision.begin / seconds.size,
      end: collision.end / seconds.size,
    },
  };
}
