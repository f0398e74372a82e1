// The core in the page's own thread, for what must be known at once: units, and whether numbers are right.
import { documentOf } from '../inputs/document';
import { type Encounter, type Units, CoreError } from './protocol';
import { type WasmCore, value } from './wasm';

let core: WasmCore | undefined;

/** Says which core answers. */
export function setLocal(made: WasmCore): void {
  core = made;
}

/** The answers to what was asked last, of which a page asks few again and again. */
function remembered<T extends object>(ask: (text: string) => T): (text: string) => T {
  const known = new Map<string, T | CoreError>();
  const most = 64;
  const answer = (text: string): T | CoreError => {
    try {
      return ask(text);
    } catch (error) {
      if (error instanceof CoreError) return error;
      throw error;
    }
  };
  return (text) => {
    const found = known.get(text) ?? answer(text);
    known.delete(text);
    known.set(text, found);
    for (const oldest of known.keys()) if (known.size > most) known.delete(oldest);
    if (found instanceof CoreError) throw found;
    return found;
  };
}

const units = remembered((document) => value(core!.units(document)).units);
const series = remembered((text) => Array.from(value(core!.series('speeds', text)).values));

/** The units of an encounter. Throws CoreError with one line for one that cannot be. */
export function unitsOf(encounter: Encounter): Units {
  return units(documentOf(encounter));
}

/** Throws CoreError with one line for a speed that is out of range. */
export function requireSpeed(encounter: Encounter, speed: number): void {
  value(core!.ownSpeed(documentOf(encounter), speed));
}

/** A number as the command reads it. Throws CoreError with one line. */
export function numberOf(name: string, text: string): number {
  return value(core!.number(name, text)).value;
}

/** The speeds that a text stands for, as the command reads it: one, a list a,b,c, log:a:b:n or lin:a:b:n. Throws
 *  CoreError with one line. */
export function seriesOf(text: string): readonly number[] {
  return series(text);
}
