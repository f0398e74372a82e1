// What a worker of the core is told, and what it answers.
import type { Encounter, Grid } from './protocol';

/** The calls by their names, with their arguments. */
export interface Calls {
  restitution: [encounter: Encounter, speed: number, tolerance: number];
  collision: [encounter: Encounter, speed: number, cutoff: number];
  frames: [encounter: Encounter, speed: number, cutoff: number, times: number[], grid: Grid];
  shape: [encounter: Encounter, body: 0 | 1, order: number, index: number, grid: Grid];
  curve: [encounter: Encounter, speeds: number[], tolerance: number];
  header: [encounter: Encounter, slowest: number, fastest: number, error: number];
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
