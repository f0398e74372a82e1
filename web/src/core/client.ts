// The core in workers: what is asked often does not wait for what takes long, and a first value not for the whole core.
import { type CompiledCore, compile, instantiate } from 'stoss';
import firstQuestions from 'stoss/first.wasm?url';
import { createLane, type WorkerPort, type Lane } from './lane';
import { setLocal } from './local';
import type { Core, Questions } from './protocol';
import { withWarmUp } from './warm_up';
import CoreWorker from './worker?worker&inline';

/** The core of this page, which needs no network once all of it is loaded: after its first answer, when `answered` is
 *  called. */
export async function createCore(answered: () => void): Promise<Core> {
  const first = await compile(firstQuestions);
  setLocal(await instantiate(first));
  let loading: Promise<CompiledCore> | undefined;
  const whole = (): Promise<CompiledCore> => (loading ??= compile().catch((error: unknown) => {
    loading = undefined; // to be tried again
    throw error;
  }));
  const lane = (module: () => Promise<CompiledCore>): Lane => createLane((): WorkerPort => new CoreWorker(), module);
  const ready = (): Promise<CompiledCore> => Promise.resolve(first);
  const film = lane(whole);
  // A value must be there at once, while films, curves and tables take their time.
  const lanes: Record<keyof Questions, Lane> = {
    restitution: lane(ready), prediction: lane(ready), curve: lane(ready), oblique: lane(whole),
    collision: film, obliqueCollision: film, frames: film, sound: film, shape: film,
    obliqueAngles: lane(whole), header: lane(whole),
  };
  return withWarmUp((question, encounter, given, { deliver, signal } = {}) =>
    lanes[question]({ question, given: { ...given, document: JSON.stringify(encounter) } }, deliver, signal) as
      Promise<never>, () => setTimeout(() => { // when it is shown
        answered();
        whole().catch(() => {});
      }));
}
