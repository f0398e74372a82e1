// What drop tests of a real ball show: at the speed of the inputs first, then along the curve, which is remembered.
import { difference } from 'd3-array';
import { remember } from '../core/local';
import type { Core, Encounter, Prediction } from '../core/protocol';
import { messageOf } from '../drawing/dom';
import { documentOf } from '../inputs/document';
import { coarse, fine } from './session';

/** Speeds of a curve: a whole one has half of those of ε without models. */
const count = 25;

/** Remembered curves beyond this number are forgotten, oldest first. */
const most = 20;

/** At one speed: a first prediction soon, then the accurate one, with the influences of constants. */
const stages = [{ tolerance: coarse, constants: false }, { tolerance: fine, constants: true }] as const;

export interface PredictionAudience {
  one(encounter: Encounter, prediction: Prediction): void;
  /** There is a new point of the curve. */
  curve(): void;
  failed(line: string): void;
}

/** Predict in the background, for what was wanted last. */
export function createPredictions(core: Core, audience: PredictionAudience) {
  const known = new Map<string, readonly Prediction[]>();
  let control = new AbortController();

  /** The curve of an encounter as far as it is known, in no order. */
  const of = (encounter: Encounter): readonly Prediction[] => known.get(documentOf(encounter)) ?? [];

  async function compute(
    encounter: Encounter, speed: number, planned: readonly number[], signal: AbortSignal,
  ): Promise<void> {
    const deliver = (prediction: Prediction): void => audience.one(encounter, prediction);
    for (const stage of stages) await core('prediction', encounter, { speeds: [speed], ...stage }, { signal, deliver });
    const missing = difference(planned.slice(0, count), of(encounter).map((each) => each.speed));
    if (missing.size === 0) return;
    const fastFirst = [...missing].sort((a, b) => b - a); // slow impacts take much longer
    await core('prediction', encounter, { speeds: fastFirst, ...stages[0] }, {
      signal, deliver: (prediction) => {
        remember(known, documentOf(encounter), [...of(encounter), prediction], most);
        audience.curve();
      },
    });
  }

  return {
    of,
    /** Predict at a speed, and then at the first of others, which fill their range ever more densely. */
    async want(encounter: Encounter, speed: number, planned: readonly number[]): Promise<void> {
      control.abort();
      const { signal } = (control = new AbortController());
      try {
        await compute(encounter, speed, planned, signal);
      } catch (error) {
        if (!signal.aborted) audience.failed(messageOf(error));
      }
    },
    /** What is under way is no longer wanted. */
    stop: (): void => control.abort(),
  };
}
