// The core of the page in Node.js.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { createAnswer } from '../../src/core/calls';
import type { Calls } from '../../src/core/messages';
import { instantiate } from '../../src/core/wasm';

const bytes = readFileSync(fileURLToPath(new URL('../../../build/wasm/stoss.wasm', import.meta.url)));
const answer = createAnswer(await instantiate(new WebAssembly.Module(Uint8Array.from(bytes)), () => {}));

/** The answer to a call, and what it delivered. */
export function ask<Name extends keyof Calls>(name: Name, ...given: Calls[Name]): { value: unknown; all: unknown[] } {
  const all: unknown[] = [];
  const value = answer({ name, arguments: given } as never, (each, index) => { all[index] = each; });
  return { value, all };
}
