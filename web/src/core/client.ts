// The core in workers: what is asked often does not wait for what takes long.
import address from '@wasm/stoss.wasm?url';
import { documentOf } from '../inputs/document';
import { createLane, type Fellow, type Lane } from './lane';
import { setLocal } from './local';
import type { Core, Questions } from './protocol';
import { withWarmUp } from './warm_up';
import { instantiate } from './wasm';
import CoreWorker from './worker?worker&inline';

/** The core of this page, which needs no network once it is loaded. */
export async function createCore(): Promise<Core> {
  const module = await compile(address);
  setLocal(await instantiate(module, () => {}));
  const lane = (): Lane => createLane((): Fellow => new CoreWorker(), module);
  const [value, film] = [lane(), lane()];
  // A value must be there at once, while films, curves and tables take their time.
  const lanes: Record<keyof Questions, Lane> =
    {
      restitution: value, oblique: value, collision: film, obliqueCollision: film, frames: film, sound: film, shape: film,
      curve: lane(), obliqueAngles: lane(), header: lane(), prediction: lane(),
    };
  return withWarmUp((question, encounter, given, { deliver, signal } = {}) =>
    lanes[question]({ question, given: { ...given, document: documentOf(encounter) } }, deliver, signal) as
      Promise<never>);
}

async function compile(from: string): Promise<WebAssembly.Module> {
  const answer = await fetch(from);
  if (!answer.ok) throw new Error(`${from}: ${answer.status}`);
  // Not every static server knows the type that streaming asks for.
  return answer.headers.get('Content-Type') === 'application/wasm'
    ? WebAssembly.compileStreaming(answer)
    : WebAssembly.compile(await answer.arrayBuffer());
}
