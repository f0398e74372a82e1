// The core as Emscripten makes it of what scripts/web.sh has compiled.
import create from '@wasm/stoss.mjs';
import { CoreError, type Deliver, type Questions } from './protocol';

/** A question with all that the core needs for it. */
export interface Call {
  readonly question: keyof Questions;
  readonly given: object;
}

/** Answers a question; `deliver` gets what comes one by one. Throws CoreError with one line for what the core cannot
 *  do. */
export type Ask = (question: string, given: object, deliver?: Deliver) => unknown;

/** Make the core from its compiled module. @param alive is called during long computations */
export async function instantiate(module: WebAssembly.Module, alive: () => void): Promise<Ask> {
  const core = await create({
    alive,
    locateFile: (name: string) => name,
    instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance) => void) {
      void WebAssembly.instantiate(module, imports).then(receive);
      return {};
    },
  });
  return (question, given, deliver = () => {}) => {
    const { value, error } = core[question]!(given, deliver);
    if (error !== undefined) throw new CoreError(error);
    return value;
  };
}
