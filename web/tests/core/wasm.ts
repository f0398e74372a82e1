// The core of the page in Node.js.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { type Calls, createAnswer } from '../../src/core/calls';
import type { Encounter } from '../../src/core/protocol';
import { instantiate } from '../../src/core/instantiate';
import { documentOf } from '../../src/inputs/document';

const path = fileURLToPath(new URL('../../../build/wasm/stoss.wasm', import.meta.url));

export const core = await instantiate(new WebAssembly.Module(Uint8Array.from(readFileSync(path))), () => {});

const answer = createAnswer(core);

/** Arguments of a call, but for the document. */
type Given<Name extends keyof Calls> = Calls[Name] extends [string, ...infer Rest] ? Rest : never;

/** The answer to a call, and what it delivered. */
export function ask<Name extends keyof Calls>(name: Name, encounter: Encounter, ...given: Given<Name>):
    { value: unknown; all: unknown[] } {
  const all: unknown[] = [];
  const value = answer({ name, arguments: [documentOf(encounter), ...given] } as never, (each, index) => {
    all[index] = each;
  });
  return { value, all };
}
