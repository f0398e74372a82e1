// The core as Emscripten makes it of what scripts/web.sh has compiled.
import create, { type Wasm } from '@wasm/stoss.mjs';
import { documentOf } from '../inputs/document';
import { CoreError, type Deliver, type Encounter, type Questions } from './protocol';

export type { Wasm };

/** Make the core from its compiled module. @param alive is called during long computations */
export function instantiate(module: WebAssembly.Module, alive: () => void): Promise<Wasm> {
  return create({
    alive,
    locateFile: (name: string) => name,
    instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance) => void) {
      void WebAssembly.instantiate(module, imports).then(receive);
      return {};
    },
  });
}

/** A question to a worker. */
export interface Call {
  readonly question: keyof Questions;
  readonly given: object;
}

export function callOf(question: keyof Questions, encounter: Encounter, given: object): Call {
  return { question, given: { ...given, document: documentOf(encounter) } };
}

export type Answer = ReturnType<Wasm['ask']>;

/** What an answer says. Throws CoreError with one line for what the core cannot do. */
export function valueOf(answer: Answer): unknown {
  if (answer.error !== undefined) throw new CoreError(answer.error);
  return answer.value;
}

/** The answer to a question, or that error. */
export function answer(core: Wasm, question: string, given: object, deliver: Deliver | null = null): unknown {
  return valueOf(core.ask(question, given, deliver));
}
