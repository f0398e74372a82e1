// The package for Node.js, where the core is a file.
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import type { CompiledCore } from './core.js';
import { loader } from './methods.js';

export { CoreError, type Refusal, instantiate } from './core.js';

export async function compile(
  from: string | { readonly href: string } = new URL('./stoss.wasm', import.meta.url),
): Promise<CompiledCore> {
  const file = typeof from === 'string' ? from : fileURLToPath(from.href);
  return WebAssembly.compile(new Uint8Array(await readFile(file)));
}

export const load = /* @__PURE__ */ loader(compile);
