// Writes src/generated/kinds.ts: the core's table of kinds and its named materials, for the types and texts of the page.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import create from '../../build/wasm/stoss.mjs';

const wasmBinary = readFileSync(new URL('../../build/wasm/stoss.wasm', import.meta.url));
const { kinds, materials } = JSON.parse((await create({ wasmBinary })).kinds({}, null).value);
const folder = new URL('../src/generated/', import.meta.url);
mkdirSync(folder, { recursive: true });
const constant = (name, value) => `export const ${name} = ${JSON.stringify(value, null, 2)} as const;\n`;
writeFileSync(new URL('kinds.ts', folder),
  `// Made by plugins/kinds.mjs from the core.\n${constant('kinds', kinds)}${constant('materials', materials)}`);
