// A worker of the core: answers one call after another.
import { type Ask, instantiate } from 'stoss';
import type { FromWorker, ToWorker } from './lane';
import { CoreError } from './protocol';

let begin: (core: Promise<Ask>) => void;
const core = new Promise<Ask>((resolve) => (begin = resolve));

const post = (message: FromWorker): void => postMessage(message);

addEventListener('message', async ({ data }: MessageEvent<ToWorker>) => {
  try {
    if ('module' in data) {
      begin(instantiate(data.module, () => post({ kind: 'alive' })));
      await core;
      post({ kind: 'alive' });
    } else {
      const { question, given } = data.call;
      const ask = await core;
      const deliver = (value: never, index: number): void => post({ kind: 'delivered', value, index });
      post({ kind: 'answer', value: ask(question, given, deliver) });
    }
  } catch (error) {
    if (error instanceof CoreError) post({ kind: 'refusal', line: error.message, refusal: error.refusal });
    else post({ kind: 'broken', line: String(error) });
  }
});
