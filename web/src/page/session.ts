// What is computed when the inputs change: a first value at once, then the accurate one, then the impact in time.
import { messageOf } from '../drawing/dom';
import {
  type Collision, type Core, CoreError, type Encounter, type Motion, type ObliqueCollision, type Restitution,
} from '../core/protocol';

export const coarse = 1e-2;
export const fine = 1e-3;

/** Who gets to see what comes. */
export interface Audience {
  began(): void;
  first(encounter: Encounter, result: Restitution, motion: Motion): void;
  final(encounter: Encounter, result: Restitution, motion: Motion): void;
  collision(encounter: Encounter, speed: number, cutoff: number, collision: Collision): void;
  oblique(encounter: Encounter, motion: Motion, collision: ObliqueCollision): void;
  /** One line: what the core refuses, or that the computation broke down. */
  failed(line: string, refused: boolean): void;
}

/** While inputs change faster than this, in ms, only the first value is computed. */
export const settle = 150;

/** A first value that takes longer than this, in ms, gives way to newer inputs; a faster one is worth waiting for. */
const patience = 250;

interface Job {
  readonly encounter: Encounter;
  readonly motion: Motion;
}

/** Compute for the newest inputs only. The result takes new inputs, and drops what is under way for older ones. */
export function createSession(core: Core, audience: Audience): (encounter: Encounter, motion: Motion) => void {
  let waiting: Job | undefined;
  let running = false;
  let control = new AbortController();
  let refining = false;

  async function compute({ encounter, motion }: Job, signal: AbortSignal): Promise<void> {
    const { speed } = motion;
    const oblique = motion.friction !== 0;
    const first = oblique ? await core('oblique', encounter, { ...motion, tolerance: coarse }, { signal })
      : await core('restitution', encounter, { speed, tolerance: coarse }, { signal });
    audience.first(encounter, first, motion);
    if (waiting !== undefined) return;
    refining = true;
    await pause(settle, signal);
    const final = oblique ? first : await core('restitution', encounter, { speed, tolerance: fine }, { signal });
    signal.throwIfAborted();
    audience.final(encounter, final, motion);
    const { cutoff } = final;
    if (cutoff === 0) throw new CoreError(final.reason);
    const collision = oblique ? await core('obliqueCollision', encounter, { ...motion, cutoff }, { signal })
      : await core('collision', encounter, { speed, cutoff }, { signal });
    signal.throwIfAborted();
    if ('across' in collision) audience.oblique(encounter, motion, collision);
    else audience.collision(encounter, speed, cutoff, collision);
  }

  async function work(): Promise<void> {
    running = true;
    for (let job = waiting; job !== undefined; job = waiting) {
      waiting = undefined;
      control = new AbortController();
      refining = false;
      const { signal } = control;
      await compute(job, signal).catch((error: unknown) => {
        if (!signal.aborted) audience.failed(messageOf(error), error instanceof CoreError);
      });
    }
    running = false;
  }

  return (encounter, motion) => {
    waiting = { encounter, motion };
    audience.began();
    if (!running) void work();
    else if (refining) control.abort();
    else {
      const under = control;
      setTimeout(() => {
        if (control === under && waiting !== undefined) under.abort();
      }, patience);
    }
  };
}

/** Wait, unless the signal is aborted. */
export function pause(time: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(resolve, time);
    signal.addEventListener('abort', () => {
      clearTimeout(timer);
      reject(signal.reason as Error);
    }, { once: true });
  });
}
