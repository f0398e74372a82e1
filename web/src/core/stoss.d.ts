// Emscripten's script, which web/core builds.
declare module '@wasm/stoss.mjs' {
  import type { WasmCore } from './wasm';

  export default function create(options: object): Promise<WasmCore>;
}

declare module '@wasm/stoss.wasm?url' {
  const address: string;
  export default address;
}
