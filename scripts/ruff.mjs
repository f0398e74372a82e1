// Runs ruff, compiled to WebAssembly (Debian 12 has no package of it), on Python files. Prints what it finds, and exits
// with 1 if that is anything. It sees one text at a time: per-file rules are `# ruff: noqa` in the file.
//   ruff.mjs SETTINGS.json FILE …
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const [settings, ...files] = process.argv.slice(2);
const { PositionEncoding, Workspace } = createRequire(new URL('../web/', import.meta.url))('@astral-sh/ruff-wasm-nodejs');
const ruff = new Workspace(JSON.parse(settings), PositionEncoding.UTF16);
for (const file of files) {
  for (const { code, message, start_location: at } of ruff.check(readFileSync(file, 'utf8'))) {
    console.log(`${file}:${at.row}:${at.column}: ${code} ${message}`);
    process.exitCode = 1;
  }
}
console.log(`ruff: checked ${files.length} files`);
