// Emscripten's script, which web/core builds.
declare module '@wasm/stoss.mjs' {
  /** What web/core answers. */
  type Module = Record<string, (given: object, deliver: unknown) => { value?: unknown; error?: string }>;
  export default function create(options: object): Promise<Module>;
}
