// Charts in words, for those who do not see them, and in units that suit their numbers.

import type { Collision } from '../core/protocol';
import { prefixFor, unitInWords, withUnit, written } from '../drawing/numbers';
import { interpolate } from '../drawing/samples';
import type { Panel, Series } from './series';

const NOTHING = 1e-9; // of what a panel spans

/** The value of one series at a time. */
export function valueWords(collision: Collision, panel: Panel, series: Series, time: number): string {
  const value = interpolate(collision.time, series.values, time);
  return written(Math.abs(value) < NOTHING * (panel.high - panel.low) ? 0 : value, 3);
}

/** What the charts show at one time. */
export function cursorWords(collision: Collision, panels: Panel[], time: number): string {
  const values = panels.flatMap((panel) => panel.series.map((each) =>
    `${each.label} ${valueWords(collision, panel, each, time)}${panel.unit ? ` ${unitInWords(panel.unit)}` : ''}`));
  return `time ${withUnit(time, collision.units.time)}: ${values.join(', ')}`;
}

/** What the charts show as a whole. */
export function summaryOf(collision: Collision): string {
  const { force, time, units, velocity } = collision;
  let most = 0;
  force.forEach((each, k) => {
    if (each > force[most]!) most = k;
  });
  const end = time.length - 1;
  const energy = (name: string, values: Float64Array): string => `${written(100 * values[end]!, 3)} % ${name}`;
  return `The force is at its maximum, ${withUnit(force[most]!, units.force)}, ` +
    `${withUnit(time[most]!, units.time)} after first contact; the last contact is after ${withUnit(collision.end, units.time)}. The velocity goes from ` +
    `${withUnit(velocity[0]!, units.speed)} to ${withUnit(velocity[end]!, units.speed)}. At the end the energy is ` +
    `${energy('translation', collision.translation)}, ${energy('vibration', collision.vibration)}` +
    `${collision.dissipated[end]! > 0 ? `, ${energy('dissipated', collision.dissipated)}` : ''}.`;
}

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
