// The core in the page's own thread, for what must be known at once: units, and whether numbers are right.
import { documentOf } from '../inputs/document';
import type { Encounter, Units } from './protocol';
import { type Answer, type Wasm, answer, valueOf } from './wasm';

let core: Wasm | undefined;

/** Says which core answers. */
export function setLocal(made: Wasm): void {
  core = made;
}

/** The answers to what was asked last, of which a page asks few again and again. */
const known = new Map<string, Answer>();
const most = 64;

/** An answer, remembered. Throws CoreError with one line for what the core cannot do. */
function ask<Value>(question: string, given: object): Value {
  const key = `${question} ${JSON.stringify(given)}`;
  const found = known.get(key) ?? core!.ask(question, given, null);
  remember(known, key, found, most);
  return valueOf(found) as Value;
}

/** Keeps a value in a map, and forgets the oldest of more than `most`. */
export function remember<Value>(map: Map<string, Value>, key: string, value: Value, most: number): void {
  map.delete(key);
  map.set(key, value);
  for (const oldest of map.keys()) if (map.size > most) map.delete(oldest);
}

/** The units of an encounter. Throws CoreError with one line for one that cannot be. */
export function unitsOf(encounter: Encounter): Units {
  return ask('units', { document: documentOf(encounter) });
}

/** Throws CoreError with one line for a speed that is out of range. */
export function requireSpeed(encounter: Encounter, speed: number): void {
  answer(core!, 'speed', { document: documentOf(encounter), speed });
}

/** A number as the command reads it. Throws CoreError with one line. */
export function numberOf(name: string, text: string): number {
  return answer(core!, 'number', { name, text }) as number;
}

/** The speeds that a text stands for, as the command reads it: one, a list a,b,c, log:a:b:n or lin:a:b:n. Throws
 *  CoreError with one line. */
export function seriesOf(text: string): readonly number[] {
  return Array.from(ask<Float64Array>('series', { name: 'speeds', text }));
}
