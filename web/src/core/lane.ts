// One worker with the calls that wait for it. A call that is aborted ends soon; a worker that dies is replaced.
import { CoreError, type Deliver } from './protocol';
import type { Call } from './wasm';

/** The first message is the compiled core; then one call after another. */
export type ToWorker = { module: WebAssembly.Module } | { call: Call };

export type FromWorker =
  | { kind: 'alive' }
  /** one of many results of a call */
  | { kind: 'delivered'; value: unknown; index: number }
  | { kind: 'answer'; value: unknown }
  /** one line: what the core cannot do */
  | { kind: 'refusal'; line: string }
  /** the worker is of no further use */
  | { kind: 'broken'; line: string };

/** What a lane needs of a Worker. */
export interface Fellow {
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

/** A worker that computes says so four times a second: it is taken for dead after so many seconds of silence. */
export const silence = 5;

/** The same of a worker that starts. */
const startup = 30;

export function createLane(spawn: () => Fellow, module: WebAssembly.Module): Lane {
  const waiting: Task[] = [];
  let current: Task | undefined;
  let worker: Fellow | undefined;
  let clock: ReturnType<typeof setInterval> | undefined;

  function start(): Fellow {
    const fresh = spawn();
    worker = fresh;
    let silent = 0;
    let heard = false;
    fresh.onmessage = ({ data }) => {
      if (worker !== fresh) return;
      silent = 0;
      heard = true;
      take(data);
    };
    fresh.onerror = (event) => {
      if (worker === fresh) lose(event.message);
    };
    fresh.postMessage({ module });
    clearInterval(clock);
    clock = setInterval(() => {
      if (!current) silent = 0;
      else if (++silent > (heard ? silence : startup)) lose('it is silent');
    }, 1000);
    return fresh;
  }

  function stop(): void {
    clearInterval(clock);
    worker?.terminate();
    worker = undefined;
  }

  function take(message: FromWorker): void {
    const task = current;
    if (!task) return;
    if (message.kind === 'delivered') {
      if (!task.signal?.aborted) task.deliver?.(message.value as never, message.index);
      return;
    }
    if (message.kind === 'alive') return;
    if (message.kind === 'broken') {
      lose(message.line);
      return;
    }
    current = undefined;
    if (message.kind === 'answer') task.resolve(message.value);
    else task.reject(new CoreError(message.line));
    next();
  }

  /** The worker is dead; its call is tried once more by another. */
  function lose(why: string): void {
    stop();
    const task = current;
    current = undefined;
    if (task && !task.signal?.aborted) {
      if (++task.deaths > 1) task.reject(new Error(`worker: the computation broke down twice (${why})`));
      else waiting.unshift(task);
    }
    next();
  }

  function next(): void {
    if (current) return;
    current = waiting.shift();
    if (!current) return;
    (worker ?? start()).postMessage({ call: current.call });
  }

  function abort(task: Task): void {
    task.reject(task.signal?.reason);
    const place = waiting.indexOf(task);
    if (place >= 0) waiting.splice(place, 1);
    if (current !== task) return;
    setTimeout(() => {
      if (current !== task) return;
      stop();
      current = undefined;
      start();
      next();
    }, patience);
  }

  return (call, deliver, signal) => new Promise((resolve, reject) => {
    if (signal?.aborted) {
      reject(signal.reason as Error);
      return;
    }
    const task: Task = { call, deliver, signal, resolve, reject, deaths: 0 };
    signal?.addEventListener('abort', () => abort(task), { once: true });
    waiting.push(task);
    next();
  });
}
