// One worker with the calls that wait for it. A call that is aborted ends soon; a worker that dies is replaced.
import type { CompiledCore } from 'stoss';
import { messageOf } from '../drawing/dom';
import { type Call, CoreError, type Deliver, type Refusal } from './protocol';
import { say } from '../drawing/words';

/** The compiled core, once, and one call after another, which wait for it. */
export type ToWorker = { module: CompiledCore } | { call: Call };

export type FromWorker =
  | { kind: 'alive' }
  /** one of many results of a call */
  | { kind: 'delivered'; value: unknown; index: number }
  | { kind: 'answer'; value: unknown }
  /** one line: what the core cannot do */
  | { kind: 'refusal'; line: string; refusal: Refusal | undefined }
  /** the worker is of no further use */
  | { kind: 'broken'; line: string };

/** What a lane needs of a Worker. */
export interface WorkerPort {
  postMessage(message: ToWorker): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** Computes a call: resolves with its answer, rejects with CoreError for what the core cannot do. */
export type Lane = (call: Call, deliver?: Deliver, signal?: AbortSignal) => Promise<unknown>;

interface Task {
  call: Call;
  deliver: Deliver | undefined;
  signal: AbortSignal | undefined;
  resolve: (value: unknown) => void;
  reject: (reason: unknown) => void;
  /** how often a worker died of it */
  deaths: number;
}

/** Time in ms that an aborted call has to end by itself, before its worker is replaced. */
export const patience = 100;

/** A worker that computes says so four times a second: it is taken for dead after so many seconds of silence; and
 *  after some more where it still has to start. */
export const silence = 5;
const startup = 30;

/** @param module is asked for with every worker that starts */
export function createLane(spawn: () => WorkerPort, module: () => Promise<CompiledCore>): Lane {
  const waiting: Task[] = [];
  let current: Task | undefined;
  let worker: WorkerPort | undefined;
  let heard = false; // whether the worker has said anything yet
  let loaded = false; // whether it has the core
  let clock: ReturnType<typeof setTimeout> | undefined;

  function start(): WorkerPort {
    const fresh = spawn();
    worker = fresh;
    heard = loaded = false;
    fresh.onmessage = ({ data }) => {
      if (worker !== fresh) return;
      heard = true;
      listen();
      take(data);
    };
    fresh.onerror = (event) => {
      if (worker === fresh) lose(event.message);
    };
    module().then((its) => {
      if (worker !== fresh) return;
      loaded = true;
      fresh.postMessage({ module: its });
      listen();
    }, (error: unknown) => {
      if (worker === fresh) lose(messageOf(error));
    });
    return fresh;
  }

  function stop(): void {
    worker?.terminate();
    worker = undefined;
    current = undefined;
  }

  /** Waits for the next word of a worker that computes; a slow network may take its time. */
  function listen(): void {
    clearTimeout(clock);
    if (current && loaded) clock = setTimeout(() => lose(say('core.silent')), 1000 * (heard ? silence : startup));
  }

  function take(message: FromWorker): void {
    if (!current || message.kind === 'alive') return;
    const { signal, deliver, resolve, reject } = current;
    if (message.kind === 'delivered') {
      if (!signal?.aborted) deliver?.(message.value as never, message.index);
    } else if (message.kind === 'broken') {
      lose(message.line);
    } else {
      current = undefined;
      if (message.kind === 'answer') resolve(message.value);
      else reject(new CoreError(message.line, message.refusal));
      next();
    }
  }

  /** The worker is dead; its call is tried once more by another. */
  function lose(why: string): void {
    const task = current;
    stop();
    if (task && !task.signal?.aborted) {
      if (++task.deaths > 1) task.reject(new Error(say('core.broken', { why })));
      else waiting.unshift(task);
    }
    next();
  }

  function next(): void {
    if (current) return;
    current = waiting.shift();
    if (current) (worker ?? start()).postMessage({ call: current.call });
    listen();
  }

  function abort(task: Task): void {
    task.reject(task.signal?.reason);
    const place = waiting.indexOf(task);
    if (place >= 0) waiting.splice(place, 1);
    if (current !== task) return;
    setTimeout(() => {
      if (current !== task) return;
      stop();
      start();
      next();
    }, patience);
  }

  return (call, deliver, signal) => new Promise((resolve, reject) => {
    signal?.throwIfAborted();
    const task: Task = { call, deliver, signal, resolve, reject, deaths: 0 };
    signal?.addEventListener('abort', () => abort(task), { once: true });
    waiting.push(task);
    next();
  });
}
