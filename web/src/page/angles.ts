// ε_t and ε of the current inputs at other angles, computed in the background.
import { range } from 'd3-array';
import type { AnglePoint, Core, Encounter, Motion } from '../core/protocol';
import { messageOf } from '../drawing/dom';
import { documentOf } from '../inputs/document';
import { barSpeed, coarseFirst } from '../inputs/units';
import { coarse } from './session';

/** Angles in degrees; those are computed at which no centre is faster along the surface than c. */
const usual = range(2, 90, 3);

/** `changed` gets the points whenever there is a new one, `failed` one line. */
export function createAngles(
  core: Core, changed: (points: readonly AnglePoint[]) => void, failed: (line: string) => void,
) {
  let control = new AbortController();
  let known = '';

  return async (encounter: Encounter, motion: Motion): Promise<void> => {
    const key = `${documentOf(encounter)} ${JSON.stringify({ ...motion, angle: 0 })}`;
    if (key === known) return;
    known = key;
    control.abort();
    const { signal } = (control = new AbortController());
    const points: AnglePoint[] = [];
    changed(points);
    const fastest = (180 / Math.PI) * Math.atan(barSpeed(encounter) / motion.speed);
    const angles = coarseFirst(usual.filter((angle) => angle <= fastest));
    try {
      await core('obliqueAngles', encounter, { ...motion, angles, tolerance: coarse }, {
        signal, deliver: (point) => {
          if (signal.aborted) return;
          points.push(point);
          changed(points);
        },
      });
    } catch (error) {
      if (signal.aborted) return;
      known = '';
      failed(`Curve against the angle: ${messageOf(error)}`);
    }
  };
}
