// The core in workers: what is asked often does not wait for what takes long.
import { compile, instantiate } from 'stoss';
import { createLane, type Fellow, type Lane } from './lane';
import { setLocal } from './local';
import type { Core, Questions } from './protocol';
import { withWarmUp } from './warm_up';
import CoreWorker from './worker?worker&inline';

/** The core of this page, which needs no network once it is loaded. */
export async function createCore(): Promise<Core> {
  const module = await compile();
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
    lanes[question]({ question, given: { ...given, document: JSON.stringify(encounter) } }, deliver, signal) as
      Promise<never>);
}
