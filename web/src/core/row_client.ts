// The core for the page of the cradle: one module, that of all questions, and a worker for what is computed.
import { compile, instantiate } from 'stoss';
import { createLane, type WorkerPort, type Lane } from './lane';
import { setLocal } from './local';
import type { Core, RowCore } from './protocol';
import CoreWorker from './worker?worker&inline';

/** The core, asked about rows, and about pairs. */
export async function createRowCore(): Promise<{ rows: RowCore; pairs: Core }> {
  const module = await compile();
  setLocal(await instantiate(module));
  const lane = (): Lane => createLane((): WorkerPort => new CoreWorker(), () => Promise.resolve(module));
  const [rows, pairs] = [lane(), lane()];
  return {
    rows: (question, row, given, signal) =>
      rows({ question, given: { ...given, document: JSON.stringify(row) } }, undefined, signal) as Promise<never>,
    pairs: (question, encounter, given, { deliver, signal } = {}) =>
      pairs({ question, given: { ...given, document: JSON.stringify(encounter) } }, deliver, signal) as Promise<never>,
  };
}
