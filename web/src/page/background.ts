// What is computed in the background: ε against the speed and against the angle, and what drop tests of a real ball show.
import { difference, range } from 'd3-array';
import type { Curve } from '../charts/curve_picture';
import { remember, seriesOf } from '../core/local';
import type { AnglePoint, Asking, Core, CurvePoint, Encounter, Motion, Prediction } from '../core/protocol';
import { messageOf } from '../drawing/dom';
import { say } from '../drawing/words';
import { documentOf, meetingOf } from '../inputs/document';
import { description } from '../inputs/lines';
import { barSpeed, coarseFirst, curveSpeeds } from '../inputs/units';
import { coarse, fine, pause } from './session';

/** Points that are computed for what was wanted last, and remembered: as many sets of them as `most`. */
function createPoints<Point>(most: number, placeOf: (point: Point) => number, changed: () => void) {
  const known = new Map<string, readonly Point[]>();
  let control = new AbortController();
  /** Those that are known of a set, in no order. */
  const of = (key: string): readonly Point[] => known.get(key) ?? [];
  return {
    of,
    stop: (): void => control.abort(),
    /** Ends what is under way, and does this work; `failed` gets one line. */
    async begin(work: (signal: AbortSignal) => Promise<void>, failed: (line: string) => void): Promise<void> {
      control.abort();
      const { signal } = (control = new AbortController());
      await work(signal).catch((error: unknown) => {
        if (!signal.aborted) failed(messageOf(error));
      });
    },
    /** Asks for the points of a set that are missing at some places. */
    async complete(
      key: string, planned: readonly number[], signal: AbortSignal,
      ask: (missing: number[], asking: Asking<Point>) => Promise<void>,
    ): Promise<void> {
      const missing = difference(planned, of(key).map(placeOf));
      if (missing.size > 0) await ask([...missing], { signal, deliver: (point) => {
        if (signal.aborted) return;
        remember(known, key, [...of(key), point], most);
        changed();
      } });
    },
  };
}

/** Angles in degrees, at which no centre is faster along the surface than c; where bodies spin, to both sides. */
function anglesOf(encounter: Encounter, { speed, angle, spin, second_spin }: Motion): number[] {
  const fastest = (180 / Math.PI) * Math.atan(barSpeed(encounter) / speed);
  const both = angle < 0 || spin !== 0 || second_spin !== 0;
  return coarseFirst((both ? range(-88, 90, 4) : range(2, 90, 3)).filter((each) => Math.abs(each) <= fastest));
}

/** ε_t and ε of the current inputs at other angles. `changed` gets the points whenever there is a new one, `failed` one
 *  line. */
export function createAngles(
  core: Core, changed: (points: readonly AnglePoint[]) => void, failed: (line: string) => void,
) {
  let current = '';
  const all = createPoints<AnglePoint>(1, ({ angle }) => angle, () => changed(all.of(current)));
  return async (encounter: Encounter, motion: Motion): Promise<void> => {
    const angles = anglesOf(encounter, motion);
    const key = `${documentOf(encounter)} ${JSON.stringify({ ...motion, angle: angles })}`;
    if (key === current) return;
    current = key;
    changed(all.of(key));
    await all.begin((signal) => all.complete(key, angles, signal, (missing, asking) =>
      core('obliqueAngles', encounter, { ...motion, angles: missing, tolerance: coarse }, asking)), (line) => {
      current = '';
      failed(say('angle.failed', { line }));
    });
  };
}

/** ε(v) of the current encounter and of those kept for comparison, one after the other. `changed` is called when there is
 *  a new point, `failed` with one line. */
export function createCurves(core: Core, changed: () => void, failed: (line: string) => void) {
  const all = createPoints<CurvePoint>(40, ({ speed }) => speed, changed);
  let wanted: readonly Encounter[] = [];
  let series = '';

  const seriesFor = (encounter: Encounter): string =>
    (wanted[0] && meetingOf(wanted[0]).si === meetingOf(encounter).si ? series : '');
  const keyOf = (encounter: Encounter): string => `${documentOf(encounter)} ${seriesFor(encounter)}`;

  /** The curve of an encounter as far as it is known. */
  const of = (encounter: Encounter): Curve =>
    ({ encounter, points: all.of(keyOf(encounter)), planned: curveSpeeds(encounter, seriesFor(encounter)) });

  function begin(): void {
    changed();
    void all.begin(async (signal) => {
      for (const encounter of wanted) {
        await all.complete(keyOf(encounter), of(encounter).planned, signal, (speeds, asking) =>
          core('curve', encounter, { speeds, tolerance: fine }, asking)).catch((error: unknown) => {
          signal.throwIfAborted();
          failed(say('curve.failed', { encounter: description(encounter), why: messageOf(error) }));
        });
      }
    }, failed);
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

/** Speeds of a curve of predictions: a whole one has half of those of ε without models. */
const count = 25;

/** At one speed: a first prediction soon, then the accurate one, with the influences of constants. */
const stages = [{ tolerance: coarse, constants: false }, { tolerance: fine, constants: true }] as const;

export interface PredictionAudience {
  one(encounter: Encounter, prediction: Prediction): void;
  /** There is a new point of the curve. */
  curve(): void;
  failed(line: string): void;
}

/** What drop tests show: at the speed of the inputs first, then along the curve. */
export function createPredictions(core: Core, audience: PredictionAudience) {
  const all = createPoints<Prediction>(20, ({ speed }) => speed, audience.curve);
  return {
    of: (encounter: Encounter): readonly Prediction[] => all.of(documentOf(encounter)),
    /** Predict at a speed, `after` so many ms in which nothing else is wanted, and then at the first of others, which fill their range ever more densely. */
    want: (
      encounter: Encounter, speed: number, planned: readonly number[], after = 0,
    ): Promise<void> => all.begin(async (signal) => {
      if (after > 0) await pause(after, signal);
      const deliver = (prediction: Prediction): void => audience.one(encounter, prediction);
      for (const stage of stages) await core('prediction', encounter, { speeds: [speed], ...stage }, { signal, deliver });
      const few = planned.slice(0, count).sort((a, b) => b - a); // fast first: slow impacts take much longer
      await all.complete(documentOf(encounter), few, signal, (speeds, asking) =>
        core('prediction', encounter, { speeds, ...stages[0] }, asking));
    }, audience.failed),
    /** What is under way is no longer wanted. */
    stop: all.stop,
  };
}
