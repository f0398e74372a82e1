// How a worker answers calls: what it has made for one is kept for the next.
import { withStrengths } from '../inputs/materials';
import type { Call } from './messages';
import type { Collision, Encounter } from './protocol';
import { CoreError } from './protocol';
import type { Answered, WasmCollision, WasmCore, WasmEncounter } from './wasm';

/** How many encounters are kept, with the modes of their bodies. */
const kept = 4;

/** Returns the answer to a call; `deliver` gets what comes one by one. Throws CoreError for what the core cannot do. */
export type Answer = (call: Call, deliver: (value: unknown, index: number) => void) => unknown;

export function createAnswer(core: WasmCore): Answer {
  const encounters = new Map<string, WasmEncounter>();
  let last: { key: string; collision: WasmCollision; series: Collision } | undefined;

  function encounterOf(given: Encounter): WasmEncounter {
    const key = JSON.stringify(given);
    const found = encounters.get(key) ?? value(core.makeEncounter(withStrengths(given))).encounter;
    encounters.delete(key);
    encounters.set(key, found);
    for (const [oldest, encounter] of encounters) {
      if (encounters.size <= kept) break;
      encounter.delete();
      encounters.delete(oldest);
    }
    return found;
  }

  function collisionOf(given: Encounter, speed: number, cutoff: number): NonNullable<typeof last> {
    const key = JSON.stringify([given, speed, cutoff]);
    if (last?.key !== key) {
      const made = value(encounterOf(given).collision(speed, cutoff));
      last?.collision.delete();
      last = { key, collision: made.collision, series: made.series };
    }
    return last;
  }

  return (call, deliver) => {
    switch (call.name) {
      case 'restitution': {
        const [encounter, speed, tolerance] = call.arguments;
        return value(encounterOf(encounter).restitution(speed, tolerance));
      }
      case 'collision':
        return collisionOf(...call.arguments).series;
      case 'frames': {
        const [encounter, speed, cutoff, times, grid] = call.arguments;
        value(collisionOf(encounter, speed, cutoff).collision.frames(times, grid, deliver));
        return undefined;
      }
      case 'shape': {
        const [encounter, body, order, index, grid] = call.arguments;
        return value(encounterOf(encounter).shape(body, order, index, grid));
      }
      case 'curve': {
        const [encounter, speeds, tolerance] = call.arguments;
        value(encounterOf(encounter).curve(speeds, tolerance, deliver));
        return undefined;
      }
      case 'header': {
        const [encounter, slowest, fastest, error] = call.arguments;
        return value(encounterOf(encounter).header(slowest, fastest, error)).text;
      }
    }
  };
}

function value<T extends object>(answer: Answered<T>): T {
  if (answer.error !== undefined) throw new CoreError(answer.error);
  return answer as T;
}
