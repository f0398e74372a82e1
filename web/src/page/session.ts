// What is computed when the inputs change: a first value at once, then the accurate one, then the impact in time.
import { type Collision, type Core, CoreError, type Encounter, type Restitution } from '../core/protocol';

export const coarse = 1e-2;
export const fine = 1e-3;

/** Who gets to see what comes. */
export interface Audience {
  began(): void;
  first(encounter: Encounter, result: Restitution): void;
  final(encounter: Encounter, result: Restitution): void;
  collision(encounter: Encounter, speed: number, collision: Collision): void;
  /** One line: what the core refuses, or that a worker had to be replaced. */
  failed(line: string, refused: boolean): void;
}

/** While inputs change faster than this, in ms, only the first value is computed. */
const settle = 150;

/** Compute for the newest inputs only; `run` drops what is under way. */
export function createSession(core: Core, audience: Audience): (encounter: Encounter, speed: number) => void {
  let current = new AbortController();

  async function compute(encounter: Encounter, speed: number, signal: AbortSignal): Promise<void> {
    const first = await core.restitution(encounter, speed, coarse, signal);
    signal.throwIfAborted();
    audience.first(encounter, first);
    await pause(settle, signal);
    const final = await core.restitution(encounter, speed, fine, signal);
    signal.throwIfAborted();
    audience.final(encounter, final);
    const collision = await core.collision(encounter, speed, fine, signal);
    signal.throwIfAborted();
    audience.collision(encounter, speed, collision);
  }

  async function run(encounter: Encounter, speed: number, again: boolean): Promise<void> {
    const { signal } = current;
    try {
      await compute(encounter, speed, signal);
    } catch (error) {
      if (signal.aborted) return;
      if (error instanceof CoreError) {
        audience.failed(error.message, true);
        return;
      }
      const line = error instanceof Error ? error.message : String(error);
      audience.failed(again ? line : 'The computation stopped without a reason and begins anew.', false);
      if (!again) await run(encounter, speed, true);
    }
  }

  return (encounter, speed) => {
    current.abort();
    current = new AbortController();
    audience.began();
    void run(encounter, speed, false);
  };
}

/** Wait, unless the signal is aborted. */
function pause(time: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(resolve, time);
    signal.addEventListener('abort', () => {
      clearTimeout(timer);
      reject(signal.reason as Error);
    }, { once: true });
  });
}
