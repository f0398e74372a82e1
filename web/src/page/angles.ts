// ε_t and ε of the current inputs at other angles, computed in the background.
import { range } from 'd3-array';
import type { AnglePoint, Core, Encounter, Motion } from '../core/protocol';
import { messageOf } from '../drawing/dom';
import { documentOf } from '../inputs/document';
import { barSpeed, coarseFirst } from '../inputs/units';
import { coarse } from './session';

/** Angles in degrees, at which no centre is faster along the surface than c; where bodies spin, to both sides. */
function anglesOf(encounter: Encounter, { speed, angle, spin, spin2 }: Motion): number[] {
  const fastest = (180 / Math.PI) * Math.atan(barSpeed(encounter) / speed);
  const both = angle < 0 || spin !== 0 || spin2 !== 0;
  return coarseFirst((both ? range(-88, 90, 4) : range(2, 90, 3)).filter((each) => Math.abs(each) <= fastest));
}

/** `changed` gets the points whenever there is a new one, `failed` one line. */
export function createAngles(
  core: Core, changed: (points: readonly AnglePoint[]) => void, failed: (line: string) => void,
) {
  let control = new AbortController();
  let known = '';

  return async (encounter: Encounter, motion: Motion): Promise<void> => {
    const angles = anglesOf(encounter, motion);
    const key = `${documentOf(encounter)} ${JSON.stringify({ ...motion, angle: angles })}`;
    if (key === known) return;
    known = key;
    control.abort();
    const { signal } = (control = new AbortController());
    const points: AnglePoint[] = [];
    changed(points);
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
