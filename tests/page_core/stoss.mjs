// Stands for what Emscripten makes of web/core: the same core compiled for this machine (stoss_page_core), asked by Node.js
// itself, or by a browser through the server of the page (web/tests/page/browser.ts).
const known = new Map();

/** Numbers that JSON does not have, and typed arrays, are objects with the member $; halves of characters are none. */
const half = /[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/g;
const written = (_, value) => ArrayBuffer.isView(value) ? [...value] :
  typeof value === 'string' ? value.replace(half, '\ufffd') :
  typeof value === 'number' && !Number.isFinite(value) ? { $: `${value}` } : value;
const read = (_, value) => typeof value?.$ !== 'string' ? value :
  value.of === undefined ? Number(value.$) : globalThis[value.$].from(value.of);

async function program() {
  const [{ execFileSync }, { fileURLToPath }] =
    await Promise.all(['node:child_process', 'node:url'].map((name) => import(/* @vite-ignore */ name)));
  const path = process.env.STOSS_PAGE_CORE ??
    fileURLToPath(new URL('../../release/tests/page_core/stoss_page_core', import.meta.url));
  return (words, input) => execFileSync(path, words, { input, encoding: 'utf8', maxBuffer: 1 << 30 });
}

/** In a browser: without waiting, as the functions of WebAssembly answer. */
function server(words, body) {
  const request = new XMLHttpRequest();
  request.open('POST', new URL(`/page-core/${words[0] ?? ''}`, self.location.origin), false);
  request.send(body);
  return request.responseText;
}

export default async function create({ instantiateWasm }) {
  instantiateWasm?.({}, () => {});
  const ask = globalThis.process === undefined ? server : await program();
  const answer = (name) => (given, deliver) => {
    const text = JSON.stringify(given, written);
    const key = `${name} ${text}`;
    if (!known.has(key)) known.set(key, ask([name], text));
    const lines = known.get(key).trim().split('\n').map((line) => JSON.parse(line, read));
    for (const { each, index } of lines.slice(0, -1)) deliver(each, index);
    return lines.at(-1);
  };
  return Object.fromEntries(ask([], '').trim().split('\n').map((name) => [name, answer(name)]));
}
