// The core as Emscripten makes it of what web/core has compiled.
import create from './stoss.mjs';

/** What the core cannot do: one line, with the name of the argument first where there is one. */
export class CoreError extends Error {}
CoreError.prototype.name = 'CoreError';

/** Gets what comes one by one. */
export type Deliver = (each: never, index: number) => void;

/** Answers a question; `deliver` gets what comes one by one. Throws CoreError for what the core cannot do. */
export type Ask = (question: string, given: object, deliver?: Deliver) => unknown;

/** A compiled WebAssembly.Module of the core. Workers can be sent it, so that they need not compile it again. */
export type CompiledCore = object;

/** Make a core of its compiled module. @param alive is called some four times a second during long computations */
export function instantiate(module: CompiledCore, alive: () => void = () => {}): Promise<Ask> {
  return new Promise((resolve, reject) => {
    const made = create({
      alive,
      locateFile: (name: string) => name,
      instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance) => void) {
        WebAssembly.instantiate(module as WebAssembly.Module, imports).then(receive).catch(reject);
        return {};
      },
    });
    made.then((core) => resolve((question, given, deliver = () => {}) => {
      const { value, error } = core[question]!(given, deliver);
      if (error !== undefined) throw new CoreError(error);
      return value;
    }), reject);
  });
}
