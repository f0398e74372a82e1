// Emscripten's script, which web/core builds.
declare module '@wasm/stoss.mjs' {
  /** web/core/module.cpp */
  type Module = { ask(question: string, given: object, deliver: unknown): { value?: unknown; error?: string } };
  export default function create(options: object): Promise<Module>;
}
