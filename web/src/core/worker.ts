// A worker of the core: answers one call after another.
import { createAnswer, type Answer } from './calls';
import type { Call, FromWorker, ToWorker } from './calls';
import { CoreError } from './protocol';
import { instantiate } from './instantiate';

let answer: Promise<Answer> | undefined;

function post(message: FromWorker): void {
  postMessage(message);
}

async function take(call: Call): Promise<void> {
  try {
    const value = (await answer!)(call, (each, index) => post({ kind: 'delivered', value: each, index }));
    post({ kind: 'answer', value });
  } catch (error) {
    if (error instanceof CoreError) post({ kind: 'refusal', line: error.message });
    else post({ kind: 'broken', line: String(error) });
  }
}

addEventListener('message', (event: MessageEvent<ToWorker>) => {
  const message = event.data;
  if ('module' in message) {
    answer = instantiate(message.module, () => post({ kind: 'alive' })).then((core) => {
      post({ kind: 'alive' });
      return createAnswer(core);
    });
    answer.catch((error: unknown) => post({ kind: 'broken', line: String(error) }));
  } else {
    void take(message.call);
  }
});
