// The core in the page's own thread, for what must be known at once: units, and whether numbers are right.
import { documentOf } from '../inputs/document';
import { type Encounter, type Units, CoreError } from './protocol';
import { type WasmCore, value } from './wasm';

let core: WasmCore | undefined;

/** Says which core answers. */
export function setLocal(made: WasmCore): void {
  core = made;
}

const known = new Map<string, Units | CoreError>();
const most = 64;

function lookUp(document: string): Units | CoreError {
  try {
    return value(core!.units(document)).units;
  } catch (error) {
    if (error instanceof CoreError) return error;
    throw error;
  }
}

/** The units of an encounter. Throws CoreError with one line for one that cannot be. */
export function unitsOf(encounter: Encounter): Units {
  const document = documentOf(encounter);
  const found = known.get(document) ?? lookUp(document);
  known.delete(document);
  known.set(document, found);
  for (const oldest of known.keys()) if (known.size > most) known.delete(oldest);
  if (found instanceof CoreError) throw found;
  return found;
}

/** Throws CoreError with one line for a speed that is out of range. */
export function requireSpeed(encounter: Encounter, speed: number): void {
  value(core!.ownSpeed(documentOf(encounter), speed));
}

/** The numbers that a text stands for, as the command reads it: one, a list a,b,c, log:a:b:n or lin:a:b:n. Throws
 *  CoreError with one line. */
export function seriesOf(name: string, text: string): number[] {
  return Array.from(value(core!.series(name, text)).values);
}
