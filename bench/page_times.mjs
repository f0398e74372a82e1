// Times of what the page asks of its core, in Node.js: node bench/page_times.mjs, after make npm. Prints a table
// in Markdown: milliseconds of processor time of the thread that answers, and in brackets of all threads (the others
// compile), median of five processes each. "fresh": the first call of a process; "warm": after values of spheres and
// disks on half-spaces, as the page computes them at its start; "again": the same call once more, with bodies made anew.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const core = new URL('../build/npm/node.js', import.meta.url);
const others = { disk: 'half-plane', sphere: 'half-space' };
const of = (kind, against) => ({
  first: { kind, poisson: 0.3 },
  against: against === 'half-space' ? { kind: others[kind], poisson: 0.3, young: 1, density: 1 } : against,
});
const onGlass = {
  first: { kind: 'sphere', radius: 0.01, material: { young: 200e9, poisson: 0.29, density: 7850 } },
  against: { kind: 'half-space', material: { young: 70e9, poisson: 0.22, density: 2500 } },
};

const cases = [];
for (const speed of [0.1, 0.01]) {
  for (const kind of ['disk', 'sphere']) {
    for (const against of ['wall', 'same', 'half-space']) {
      cases.push({ name: `${kind}, ${against}, v = ${speed}`, encounter: of(kind, against), speed });
    }
  }
}
cases.push({ name: 'steel ball on glass, 1 m/s', encounter: onGlass, speed: 1 });
// What the page opens with.
cases.push({
  name: 'prediction: a marble falls 0.3 m on granite', question: 'prediction', speed: 2.4256937152080846,
  encounter: {
    first: { kind: 'sphere', radius: 0.008, material: 'glass' }, against: { kind: 'half-space', material: 'granite' },
  },
});

/** Processor time in ms of this thread, and of all. */
function now() {
  const own = Number(readFileSync('/proc/thread-self/schedstat', 'utf8').split(' ')[0]) / 1e6;
  const { user, system } = process.cpuUsage();
  return [own, (user + system) / 1e3];
}

function asked(ask, { encounter, speed, question = 'restitution' }, tolerance) {
  const before = now();
  ask(question, { document: JSON.stringify(encounter), speed, speeds: [speed], constants: false, tolerance }, () => {});
  const after = now();
  return after.map((time, k) => time - before[k]);
}

/** In a process of its own. */
async function measure(number) {
  const { compile, instantiate } = await import(core);
  const module = await compile(new URL('../build/npm/first.wasm', import.meta.url));
  const ask = await instantiate(module);
  const times = {};
  if (process.argv[3] === 'warm') {
    for (const kind of ['sphere', 'disk']) asked(ask, { encounter: of(kind, 'half-space'), speed: 0.1 }, 1e-2);
    await new Promise((resolve) => setTimeout(resolve, 500));
    times.warm = asked(await instantiate(module), cases[number], 1e-2);
  } else {
    times.fresh = asked(ask, cases[number], 1e-2);
    times.again = asked(ask, cases[number], 1e-2);
  }
  console.log(JSON.stringify(times));
}

function medians(number, runs = 5) {
  const all = { fresh: [], warm: [], again: [] };
  for (let run = 0; run < runs; ++run) {
    for (const way of ['fresh', 'warm']) {
      const { stdout } = spawnSync(process.execPath, [fileURLToPath(import.meta.url), String(number), way]);
      for (const [name, times] of Object.entries(JSON.parse(String(stdout)))) all[name].push(times);
    }
  }
  return Object.values(all).map((times) => {
    const [own, every] = [0, 1].map((k) => times.map((each) => each[k]).sort((a, b) => a - b)[Math.floor(runs / 2)]);
    return `${own.toFixed(0)} (${every.toFixed(0)})`;
  });
}

if (process.argv[2] !== undefined) {
  await measure(Number(process.argv[2]));
} else {
  console.log('| first value of the page, to 10⁻² | fresh, ms | warm, ms | again, ms |\n|---|---:|---:|---:|');
  cases.forEach(({ name }, number) => console.log(`| ${name} | ${medians(number).join(' | ')} |`));
}
