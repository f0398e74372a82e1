// The package for browsers; node.ts is that for Node.js.
import type { CompiledCore } from './core.js';
import { loader } from './methods.js';

export { type Ask, type CompiledCore, CoreError, type Deliver, type Refusal, instantiate } from './core.js';
export type { Against, Encounter, First, Material, ModalBody } from './generated/documents.js';
export type { Quantities } from './generated/quantities.js';
export type { NamedMaterial, Options, Stoss } from './methods.js';
export type * from './answers.js';
export type { Questions, QuickQuestions, Row, RowQuestions } from './questions.js';

/** Compile the core. @param from where its WebAssembly is; without it, beside this module */
export async function compile(
  from: string | { readonly href: string } = new URL('./stoss.wasm', import.meta.url),
): Promise<CompiledCore> {
  const address = typeof from === 'string' ? from : from.href;
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
  // Not every static server knows the type that streaming asks for.
  return answer.headers.get('Content-Type') === 'application/wasm'
    ? WebAssembly.compileStreaming(answer)
    : WebAssembly.compile(await answer.arrayBuffer());
}

/** Load the core on this thread. */
export const load = /* @__PURE__ */ loader(compile);
