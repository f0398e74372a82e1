// Writes what the core knows of bodies: src/generated/kinds.ts, its table of kinds and its named materials, for the
// types and texts of the page; package/generated/, the types of encounters and of results, for the package.
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

const { kinds, materials, ranges } = asked('kinds');
const constant = (name, value) => `export const ${name} = ${JSON.stringify(value, null, 2)} as const;\n`;
write('src/generated/kinds.ts',
  `// Made by plugins/kinds.mjs from the core.\n${constant('kinds', kinds)}${constant('materials', materials)}${constant('ranges', ranges)}`);
write('package/generated/documents.ts', typesOf(asked('schema')));
const members = Object.entries(asked('quantities')).map(([name, help]) => `  /** ${help} */\n  readonly ${name}?: Value;\n`);
write('package/generated/quantities.ts', `// Made by web/plugins/kinds.mjs of the core's tables of quantities.

/** Quantities of results, by the names of the command. */
export interface Quantities<Value> {\n${members.join('')}}\n`);
