// What a worker is asked and what it answers: what it has made for one call is kept for the next.
import type { Collision, Grid } from './protocol';
import { type WasmCollision, type WasmCore, type WasmEncounter, value } from './wasm';

/** The calls by their names, with their arguments: first of all the document of an encounter. */
export interface Calls {
  restitution: [document: string, speed: number, tolerance: number];
  collision: [document: string, speed: number, cutoff: number];
  frames: [document: string, speed: number, cutoff: number, times: number[], grid: Grid];
  shape: [document: string, body: 0 | 1, order: number, index: number, grid: Grid];
  curve: [document: string, speeds: number[], tolerance: number];
  header: [document: string, slowest: number, fastest: number, error: number];
}

export type Call = { [Name in keyof Calls]: { name: Name; arguments: Calls[Name] } }[keyof Calls];

/** The first message is the compiled core; then one call after another. */
export type ToWorker = { module: WebAssembly.Module } | { call: Call };

export type FromWorker =
  | { kind: 'alive' }
  /** one of many results of a call */
  | { kind: 'delivered'; value: unknown; index: number }
  | { kind: 'answer'; value: unknown }
  /** one line: what the core cannot do */
  | { kind: 'refusal'; line: string }
  /** the worker is of no further use */
  | { kind: 'broken'; line: string };

/** How many encounters are kept, with the modes of their bodies. */
const kept = 4;

/** Returns the answer to a call; `deliver` gets what comes one by one. Throws CoreError for what the core cannot do. */
export type Answer = (call: Call, deliver: (value: unknown, index: number) => void) => unknown;

export function createAnswer(core: WasmCore): Answer {
  const encounters = new Map<string, WasmEncounter>();
  let last: { key: string; collision: WasmCollision; series: Collision } | undefined;

  function encounterOf(document: string): WasmEncounter {
    const found = encounters.get(document) ?? value(core.makeEncounter(document)).encounter;
    encounters.delete(document);
    encounters.set(document, found);
    for (const [oldest, encounter] of encounters) {
      if (encounters.size <= kept) break;
      encounter.delete();
      encounters.delete(oldest);
    }
    return found;
  }

  function collisionOf(document: string, speed: number, cutoff: number): NonNullable<typeof last> {
    const key = JSON.stringify([document, speed, cutoff]);
    if (last?.key !== key) {
      const made = value(encounterOf(document).collision(speed, cutoff));
      last?.collision.delete();
      last = { key, ...made };
    }
    return last;
  }

  return (call, deliver) => {
    switch (call.name) {
      case 'restitution': {
        const [document, ...given] = call.arguments;
        return value(encounterOf(document).restitution(...given));
      }
      case 'collision':
        return collisionOf(...call.arguments).series;
      case 'frames': {
        const [document, speed, cutoff, ...given] = call.arguments;
        return void value(collisionOf(document, speed, cutoff).collision.frames(...given, deliver));
      }
      case 'shape': {
        const [document, ...given] = call.arguments;
        return value(encounterOf(document).shape(...given));
      }
      case 'curve': {
        const [document, ...given] = call.arguments;
        return void value(encounterOf(document).curve(...given, deliver));
      }
      case 'header': {
        const [document, ...given] = call.arguments;
        return value(encounterOf(document).header(...given)).text;
      }
    }
  };
}
