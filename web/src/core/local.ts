// The core in the page's own thread, for what must be known at once: units, and whether numbers are right. All of it
// throws CoreError with one line for what the core cannot do.
import type { Ask } from 'stoss';
import { provisional } from './provisional';
import { CoreError, type Encounter, type Motion, type Thresholds, type Units } from './protocol';

let core: Ask = provisional;

/** Says which core answers. */
export function setLocal(made: Ask): void {
  core = made;
  known.clear();
}

/** The answers to what was asked last, of which a page asks few again and again. */
const known = new Map<string, unknown>();
const most = 64;

function ask<Value>(question: string, given: object): Value {
  const key = `${question} ${JSON.stringify(given)}`;
  const value = known.get(key) ?? core(question, given);
  remember(known, key, value, most);
  return value as Value;
}

/** Keeps a value in a map, and forgets the oldest of more than `most`. */
export function remember<Value>(map: Map<string, Value>, key: string, value: Value, most: number): void {
  map.delete(key);
  map.set(key, value);
  for (const oldest of map.keys()) if (map.size > most) map.delete(oldest);
}

export function unitsOf(encounter: Encounter): Units {
  return ask('units', { document: JSON.stringify(encounter) });
}

/** Throws for what the core refuses of a document as it stands, where a key may be twice, which an object forgets. */
export function requireDocument(document: string): void {
  ask('units', { document });
}

/** Whether a speed is in range: throws for one that is not. */
export function requireSpeed(encounter: Encounter, speed: number): void {
  ask('speed', { document: JSON.stringify(encounter), speed });
}

/** Whether a motion is in range: throws for one that is not. */
export function requireMotion(encounter: Encounter, motion: Motion): void {
  ask('motion', { document: JSON.stringify(encounter), ...motion });
}

/** At what speeds models of real materials begin to matter; undefined of what the core does not predict. */
export function thresholdsOf(encounter: Encounter): Thresholds | undefined {
  try {
    return ask('thresholds', { document: JSON.stringify(encounter) });
  } catch (error) {
    if (error instanceof CoreError) return undefined;
    throw error;
  }
}

/** A number as the command reads it. */
export function numberOf(name: string, text: string): number {
  return ask('number', { name, text });
}

/** Shares and times of a relaxation as the command reads it: 0.5:1+0.2:10. */
export function relaxationOf(name: string, text: string): readonly (readonly [number, number])[] {
  return ask('relaxation', { name, text });
}

/** The speeds that a text stands for, as the command reads it: one, a list a,b,c, log:a:b:n or lin:a:b:n. */
export function seriesOf(text: string): readonly number[] {
  return Array.from(ask<Float64Array>('series', { name: 'speeds', text }));
}
