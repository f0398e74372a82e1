// A worker of the core: answers one call after another.
import type { FromWorker, ToWorker } from './lane';
import { CoreError } from './protocol';
import { type Call, type Wasm, answer, instantiate } from './wasm';

let core: Promise<Wasm> | undefined;

const post = (message: FromWorker): void => postMessage(message);

async function take({ question, given }: Call): Promise<void> {
  try {
    const deliver = (value: never, index: number): void => post({ kind: 'delivered', value, index });
    post({ kind: 'answer', value: answer(await core!, question, given, deliver) });
  } catch (error) {
    if (error instanceof CoreError) post({ kind: 'refusal', line: error.message });
    else post({ kind: 'broken', line: String(error) });
  }
}

addEventListener('message', (event: MessageEvent<ToWorker>) => {
  const message = event.data;
  if ('module' in message) {
    core = instantiate(message.module, () => post({ kind: 'alive' }));
    core.then(() => post({ kind: 'alive' }), (error: unknown) => post({ kind: 'broken', line: String(error) }));
  } else {
    void take(message.call);
  }
});
