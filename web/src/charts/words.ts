// Charts in words, for those who do not see them.

import type { Collision } from '../core/protocol';
import { interpolate } from '../drawing/scale';
import { withUnit } from '../drawing/prefix';
import { unitInWords, written } from '../drawing/ticks';
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
  return `The force is at its maximum, ${withUnit(force[most]!, units.force)}, ${withUnit(time[most]!, units.time)} after ` +
    `first contact; the last contact is after ${withUnit(collision.end, units.time)}. The velocity goes from ` +
    `${withUnit(velocity[0]!, units.speed)} to ${withUnit(velocity[end]!, units.speed)}. At the end the energy is ` +
    `${energy('translation', collision.translation)}, ${energy('vibration', collision.vibration)}` +
    `${collision.dissipated[end]! > 0 ? `, ${energy('dissipated', collision.dissipated)}` : ''}.`;
}
