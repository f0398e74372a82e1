// The core in workers: what is asked often does not wait for what takes long, and a first value not for the whole core.
import { type Ask, type CompiledCore, compile, instantiate } from 'stoss';
import firstQuestions from 'stoss/first.wasm?url';
import allQuestions from 'stoss/page.wasm?url';
import { documentOf } from '../inputs/document';
import { createLane, type WorkerPort, type Lane } from './lane';
import { setLocal } from './local';
import type { Core, Encounter, Questions } from './protocol';
import { provisional } from './provisional';
import { withWarmUp } from './warm_up';
import CoreWorker from './worker?worker&inline';

/** Whether the module of first values cannot compute it: it has no hollow spheres. */
const takesAll = (document: string): boolean => document.includes('"hollow-sphere"');

/** Takes for granted what it cannot compute. */
const partly = (core: Ask): Ask => (question, given, deliver) =>
  (takesAll((given as { document?: string }).document ?? '') ? provisional(question, given) : core(question, given, deliver));

/** The core of this page, which needs no network once all of it is loaded: after its first answer, when `answered` is
 *  called, or at once for an encounter that takes all. Then `complete` is called. */
export async function createCore(opened: Encounter, answered: () => void, complete: () => void): Promise<Core> {
  let loading: Promise<CompiledCore> | undefined;
  const loadAll = async (): Promise<CompiledCore> => {
    const module = await compile(allQuestions);
    setLocal(await instantiate(module));
    complete();
    return module;
  };
  const whole = (): Promise<CompiledCore> => (loading ??= loadAll().catch((error: unknown) => {
    loading = undefined; // to be tried again
    throw error;
  }));
  const first = await (takesAll(documentOf(opened)) ? whole() : compile(firstQuestions));
  if (loading === undefined) setLocal(partly(await instantiate(first)));
  const lane = (module: () => Promise<CompiledCore>): Lane => createLane((): WorkerPort => new CoreWorker(), module);
  const ready = (): Promise<CompiledCore> => Promise.resolve(first);
  const film = lane(whole);
  // A value must be there at once, while films, curves and tables take their time.
  const values = (module: () => Promise<CompiledCore>) =>
    ({ restitution: lane(module), prediction: lane(module), curve: lane(module) });
  const lanes: Record<keyof Questions, Lane> = {
    ...values(ready), oblique: lane(whole),
    collision: film, obliqueCollision: film, frames: film, sound: film, shape: film,
    obliqueAngles: lane(whole), header: lane(whole),
  };
  const ofAll: typeof lanes = { ...lanes, ...values(whole) };
  return withWarmUp((question, encounter, given, { deliver, signal } = {}) => {
    const document = documentOf(encounter);
    return (takesAll(document) ? ofAll : lanes)[question]({ question, given: { ...given, document } }, deliver, signal) as
      Promise<never>;
  }, () => setTimeout(() => { // when it is shown
    answered();
    whole().catch(() => {});
  }));
}
