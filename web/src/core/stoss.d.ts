// Emscripten's script, which web/core builds.
declare module '@wasm/stoss.mjs' {
  /** The core (web/core/module.cpp): the answer to a question, or one line that says why there is none. `deliver` gets
   *  what comes one by one. */
  export interface Wasm {
    ask(question: string, given: object, deliver: ((each: never, index: number) => void) | null):
      { value: unknown; error?: undefined } | { error: string };
  }
  export default function create(options: object): Promise<Wasm>;
}
