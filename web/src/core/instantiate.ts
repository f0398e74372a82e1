// Makes the core of what scripts/web.sh has compiled.
import create from '@wasm/stoss.mjs';
import type { WasmCore } from './wasm';

/** Make the core from its compiled module. @param alive is called during long computations */
export function instantiate(module: WebAssembly.Module, alive: () => void): Promise<WasmCore> {
  return create({
    alive,
    locateFile: (name: string) => name,
    instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance) => void) {
      void WebAssembly.instantiate(module, imports).then(receive);
      return {};
    },
  });
}
