// A lane ends what is aborted, and replaces a worker that dies.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { createLane, type WorkerPort, type FromWorker, type Lane, patience, silence, type ToWorker }
  from '../../src/core/lane';
import { type Call, CoreError } from '../../src/core/protocol';

const module = async (): Promise<object> => ({});
const call = (speed: number): Call => ({ question: 'restitution', given: { speed } });

/** A worker that answers when the test says so. */
class Fake implements WorkerPort {
  onmessage: WorkerPort['onmessage'] = null;
  onerror: WorkerPort['onerror'] = null;
  calls: Call[] = [];
  alive = true;
  postMessage(message: ToWorker): void {
    if ('call' in message) this.calls.push(message.call);
  }
  terminate(): void {
    this.alive = false;
  }
  say(data: FromWorker): void {
    this.onmessage?.({ data } as MessageEvent<FromWorker>);
  }
}

let workers: Fake[];
let lane: Lane;
const last = (): Fake => workers[workers.length - 1]!;
const settle = (): Promise<unknown> => vi.advanceTimersByTimeAsync(0);

beforeEach(() => {
  vi.useFakeTimers();
  workers = [];
  lane = createLane(() => {
    workers.push(new Fake());
    return last();
  }, module);
});
afterEach(() => void vi.useRealTimers());

describe('a lane', () => {
  it('starts a worker with the first call, and asks one after another', async () => {
    expect(workers.length).toBe(0);
    const answers = [lane(call(1)), lane(call(2))];
    await settle();
    expect(last().calls).toEqual([call(1)]);
    last().say({ kind: 'answer', value: 'one' });
    await settle();
    expect(last().calls).toEqual([call(1), call(2)]);
    last().say({ kind: 'answer', value: 'two' });
    expect(await Promise.all(answers)).toEqual(['one', 'two']);
    expect(workers.length).toBe(1);
  });

  it('passes on what comes one by one', async () => {
    const all: [unknown, number][] = [];
    void lane(call(1), (value, index) => void all.push([value, index]));
    await settle();
    last().say({ kind: 'delivered', value: 'a', index: 1 });
    last().say({ kind: 'delivered', value: 'b', index: 0 });
    expect(all).toEqual([['a', 1], ['b', 0]]);
  });

  it('says what the core cannot do, and goes on', async () => {
    const refused = lane(call(1));
    const next = lane(call(2));
    await settle();
    last().say({ kind: 'refusal', line: 'speed: got 1', refusal: undefined });
    await expect(refused).rejects.toThrow(new CoreError('speed: got 1'));
    await settle();
    last().say({ kind: 'answer', value: 2 });
    expect(await next).toBe(2);
  });

  it('forgets what is aborted before it began', async () => {
    const controller = new AbortController();
    void lane(call(1));
    const second = lane(call(2), undefined, controller.signal);
    const rejected = expect(second).rejects.toThrow('newer');
    await settle();
    controller.abort(new Error('newer'));
    await rejected;
    last().say({ kind: 'answer', value: 1 });
    await settle();
    expect(last().calls).toEqual([call(1)]);
    await expect(lane(call(3), undefined, controller.signal)).rejects.toThrow('newer');
  });

  it('ends the work of a call that is aborted by another worker', async () => {
    const controller = new AbortController();
    const all: unknown[] = [];
    const first = lane(call(1), (value) => void all.push(value), controller.signal);
    const rejected = expect(first).rejects.toThrow('newer');
    await settle();
    controller.abort(new Error('newer'));
    const second = lane(call(2));
    await rejected;
    workers[0]!.say({ kind: 'delivered', value: 'late', index: 0 });
    await vi.advanceTimersByTimeAsync(patience);
    expect(workers.map((worker) => worker.alive)).toEqual([false, true]);
    expect(last().calls).toEqual([call(2)]);
    workers[0]!.say({ kind: 'answer', value: 'too late' });
    last().say({ kind: 'answer', value: 2 });
    expect(await second).toBe(2);
    expect(all).toEqual([]);
  });

  it('keeps a worker that ends an aborted call in time', async () => {
    const controller = new AbortController();
    const first = lane(call(1), undefined, controller.signal);
    const rejected = expect(first).rejects.toThrow('newer');
    await settle();
    controller.abort(new Error('newer'));
    await rejected;
    const second = lane(call(2));
    last().say({ kind: 'answer', value: 1 });
    await vi.advanceTimersByTimeAsync(2 * patience);
    expect(workers.length).toBe(1);
    last().say({ kind: 'answer', value: 2 });
    expect(await second).toBe(2);
  });

  it.each<[string, (worker: Fake) => void]>([
    ['has an error', (worker) => worker.onerror?.({ message: 'boom' } as ErrorEvent)],
    ['says that it is broken', (worker) => worker.say({ kind: 'broken', line: 'boom' })],
    ['is silent', (worker) => {
      worker.say({ kind: 'alive' });
      vi.advanceTimersByTime((silence + 1) * 1000);
    }],
  ])('tries a call once more if a worker %s', async (_, die) => {
    const answer = lane(call(1));
    await settle();
    die(last());
    await settle();
    expect(workers.map((worker) => worker.alive)).toEqual([false, true]);
    expect(last().calls).toEqual([call(1)]);
    const twice = expect(answer).rejects.toThrow(/^worker: the computation broke down twice/);
    die(last());
    await twice;
    const next = lane(call(2));
    await settle();
    last().say({ kind: 'answer', value: 2 });
    expect(await next).toBe(2);
  });

  it('is patient with a worker that is idle, and with one that says it computes', async () => {
    const answer = lane(call(1));
    await settle();
    for (let k = 0; k < 20; ++k) {
      last().say({ kind: 'alive' });
      await vi.advanceTimersByTimeAsync(2000);
    }
    last().say({ kind: 'answer', value: 1 });
    expect(await answer).toBe(1);
    await vi.advanceTimersByTimeAsync(60_000);
    expect(workers.length).toBe(1);
  });
});
