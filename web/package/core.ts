// The core as Emscripten makes it of what web/core has compiled.
import create from './stoss.mjs';

/** The parts of an input that is refused, of which the message is one line. */
export interface Refusal {
  readonly kind: 'out_of_range' | 'missing' | 'conflict';
  /** of the input; after "against" where it is of what the first body meets */
  readonly name: string;
  /** '' where something is missing or does not go together */
  readonly got: string;
  /** what is allowed or needed, or why it does not go together */
  readonly allowed: string;
  readonly hint: string;
}

/** What the core cannot do: one line, with the name of the input first where one is refused. */
export class CoreError extends Error {
  constructor(message: string, /** where an input is refused */ readonly refusal?: Refusal) {
    super(message);
  }
}
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
      const { value, error, refusal } = core[question]!(given, deliver);
      if (error !== undefined) throw new CoreError(error, refusal);
      return value;
    }), reject);
  });
}
