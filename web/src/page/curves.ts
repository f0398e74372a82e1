// ε(v) of the current encounter and of those kept for comparison: computed one after the other, and remembered.
import { difference } from 'd3-array';
import type { Curve } from '../charts/curve_picture';
import { remember, seriesOf } from '../core/local';
import type { Core, CurvePoint, Encounter } from '../core/protocol';
import { messageOf } from '../drawing/dom';
import { description } from '../inputs/lines';
import { documentOf, meetingOf } from '../inputs/document';
import { curveSpeeds } from '../inputs/units';
import { fine } from './session';

/** Remembered curves beyond this number are forgotten, oldest first. */
const most = 40;

/** Compute curves in the background; `changed` is called when there is a new point, `failed` with one line. */
export function createCurves(core: Core, changed: () => void, failed: (line: string) => void) {
  const known = new Map<string, Curve>();
  let current = new AbortController();
  let wanted: readonly Encounter[] = [];
  let series = '';

  const seriesFor = (encounter: Encounter): string => (wanted[0] && meetingOf(wanted[0]).si === meetingOf(encounter).si ? series : '');
  const keyOf = (encounter: Encounter): string => `${documentOf(encounter)} ${seriesFor(encounter)}`;

  /** The curve of an encounter as far as it is known. */
  function of(encounter: Encounter): Curve {
    const found = known.get(keyOf(encounter)) ??
      { points: [], planned: curveSpeeds(encounter, seriesFor(encounter)) };
    return { ...found, encounter };
  }

  async function compute(encounter: Encounter, signal: AbortSignal): Promise<void> {
    const begun = of(encounter);
    const missing = difference(begun.planned, begun.points.map(({ speed }) => speed));
    if (missing.size === 0) return;
    const deliver = (point: CurvePoint): void => {
      if (signal.aborted) return;
      const before = of(encounter);
      remember(known, keyOf(encounter), { ...before, points: [...before.points, point] }, most);
      changed();
    };
    await core('curve', encounter, { speeds: [...missing], tolerance: fine }, { deliver, signal });
  }

  async function computeAll(signal: AbortSignal): Promise<void> {
    for (const encounter of wanted) {
      try {
        await compute(encounter, signal);
      } catch (error) {
        if (signal.aborted) return;
        failed(`Curve of ${description(encounter)}: ${messageOf(error)}`);
      }
    }
  }

  function begin(): void {
    current.abort();
    current = new AbortController();
    changed();
    void computeAll(current.signal);
  }

  return {
    of,
    /** Compute these curves, the first of which is the current one; what is not among them is no longer computed. */
    want(encounters: readonly Encounter[]): void {
      if (encounters.map(documentOf).join() === wanted.map(documentOf).join()) return;
      wanted = encounters;
      begin();
    },
    /** Compute at the speeds of a series; those of '' are the usual ones. They are in the units of the current
     *  encounter, and those in others have the usual ones. Throws CoreError for a text that is none. */
    at(text: string): void {
      if (text.trim() !== '') seriesOf(text);
      series = text.trim();
      begin();
    },
  };
}
