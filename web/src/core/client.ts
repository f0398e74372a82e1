// The core in workers: what is asked often does not wait for what takes long.
import address from '@wasm/stoss.wasm?url';
import { documentOf } from '../inputs/document';
import { instantiate } from './instantiate';
import { createLane, type Deliver, type Fellow, type Lane } from './lane';
import { setLocal } from './local';
import type { Collision, Core, Restitution, Shape } from './protocol';
import { withWarmUp } from './warm_up';
import CoreWorker from './worker?worker&inline';

/** The core of this page, which needs no network once it is loaded. */
export async function createCore(): Promise<Core> {
  const module = await compile(address);
  setLocal(await instantiate(module, () => {}));
  const spawn = (): Fellow => new CoreWorker();
  // A value must be there at once, while films, curves and tables take their time.
  return withWarmUp(coreOf(() => createLane(spawn, module)));
}

/** A core whose calls go along lanes of their own. */
export function coreOf(lane: () => Lane): Core {
  const [value, film, curve, table] = [lane(), lane(), lane(), lane()];
  return {
    restitution: (encounter, speed, tolerance, signal) =>
      value({ name: 'restitution', arguments: [documentOf(encounter), speed, tolerance] }, undefined, signal) as
        Promise<Restitution>,
    collision: (encounter, speed, cutoff, signal) =>
      film({ name: 'collision', arguments: [documentOf(encounter), speed, cutoff] }, undefined, signal) as
        Promise<Collision>,
    frames: (encounter, speed, cutoff, times, grid, deliver, signal) =>
      film({ name: 'frames', arguments: [documentOf(encounter), speed, cutoff, times, grid] }, deliver as Deliver,
        signal) as Promise<void>,
    shape: (encounter, body, order, index, grid) =>
      film({ name: 'shape', arguments: [documentOf(encounter), body, order, index, grid] }) as Promise<Shape>,
    curve: (encounter, speeds, tolerance, deliver, signal) =>
      curve({ name: 'curve', arguments: [documentOf(encounter), speeds, tolerance] }, deliver as Deliver, signal) as
        Promise<void>,
    header: (encounter, slowest, fastest, error, signal) =>
      table({ name: 'header', arguments: [documentOf(encounter), slowest, fastest, error] }, undefined, signal) as
        Promise<string>,
  };
}

async function compile(from: string): Promise<WebAssembly.Module> {
  const answer = await fetch(from);
  if (!answer.ok) throw new Error(`${from}: ${answer.status}`);
  // Not every static server knows the type that streaming asks for.
  return answer.headers.get('Content-Type') === 'application/wasm'
    ? WebAssembly.compileStreaming(answer)
    : WebAssembly.compile(await answer.arrayBuffer());
}
