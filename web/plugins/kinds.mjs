// Writes what the core knows of bodies: src/generated/kinds.ts, its table of kinds and its named materials, for the
// types and texts of the page; package/generated/documents.ts, the types of encounters, for the package.
//   node kinds.mjs FOLDER    that of the core, stoss.mjs and stoss.wasm
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { typesOf } from './documents.mjs';

const folder = resolve(process.argv[2]);
const { default: create } = await import(pathToFileURL(join(folder, 'stoss.mjs')).href);
const wasmBinary = readFileSync(join(folder, 'stoss.wasm'));
const core = await create({ wasmBinary });
const asked = (question) => JSON.parse(core[question]({}, null).value);

function write(name, text) {
  const file = new URL(`../${name}`, import.meta.url);
  mkdirSync(new URL('.', file), { recursive: true });
  writeFileSync(file, text);
}

const { kinds, materials } = asked('kinds');
const constant = (name, value) => `export const ${name} = ${JSON.stringify(value, null, 2)} as const;\n`;
write('src/generated/kinds.ts',
  `// Made by plugins/kinds.mjs from the core.\n${constant('kinds', kinds)}${constant('materials', materials)}`);
write('package/generated/documents.ts', typesOf(asked('schema')));
