// The core of the page in Node.js.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Encounter, Questions } from '../../src/core/protocol';
import { instantiate } from '../../src/core/wasm';
import { documentOf } from '../../src/inputs/document';

const path = fileURLToPath(new URL('../../../build/wasm/stoss.wasm', import.meta.url));

export const core = await instantiate(new WebAssembly.Module(Uint8Array.from(readFileSync(path))), () => {});

/** The answer to a question, and what it delivered. */
export function ask<Name extends keyof Questions>(
  question: Name, encounter: Encounter, given: Parameters<Questions[Name]>[0],
): { value: ReturnType<Questions[Name]>; all: (Parameters<Questions[Name]>[1] & {})[] } {
  const all: (Parameters<Questions[Name]>[1] & {})[] = [];
  const value = core(question, { ...given, document: documentOf(encounter) },
    (each, index) => void (all[index] = each));
  return { value: value as ReturnType<Questions[Name]>, all };
}
