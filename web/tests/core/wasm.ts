// The core of the page in Node.js.
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { createAnswer } from '../../src/core/calls';
import type { Calls } from '../../src/core/messages';

const path = fileURLToPath(new URL('../../../build/wasm/stoss.wasm', import.meta.url));

/** Whether the core is compiled. */
export const hasCore = existsSync(path);

const answer = hasCore
  ? createAnswer(await (await import('../../src/core/wasm')).instantiate(
      new WebAssembly.Module(Uint8Array.from(readFileSync(path))), () => {}))
  : (): never => { throw new Error('the core is not compiled'); };

/** The answer to a call, and what it delivered. */
export function ask<Name extends keyof Calls>(name: Name, ...given: Calls[Name]): { value: unknown; all: unknown[] } {
  const all: unknown[] = [];
  const value = answer({ name, arguments: given } as never, (each, index) => { all[index] = each; });
  return { value, all };
}
