import { describe, expect, it, vi } from 'vitest';
import {
  type Asking, type Collision, type Core, CoreError, type Encounter, type Motion, type Restitution,
} from '../../src/core/protocol';
import { createCurves } from '../../src/page/background';
import { createSession } from '../../src/page/session';
import { defaults, motionOf } from '../../src/inputs/inputs';

const { encounter } = defaults;
const hopeless = 0.9;
const at = (speed: number): Motion => motionOf({ ...defaults, speed });

interface Given {
  speed: number;
  tolerance: number;
  cutoff: number;
  speeds: number[];
}

/** A core whose answers come after a time, and which notes what it was asked. */
function core(time: number, log: string[], refuse = NaN): Core {
  const later = <Value>(value: Value, signal?: AbortSignal): Promise<Value> => new Promise((resolve, reject) => {
    const abort = (): void => {
      clearTimeout(timer);
      log.push('aborted');
      reject(signal?.reason as Error);
    };
    const timer = setTimeout(() => {
      signal?.removeEventListener('abort', abort);
      resolve(value);
    }, time);
    signal?.addEventListener('abort', abort);
  });
  const answers: Record<string, (given: Given, asking: Asking<never>) => Promise<unknown>> = {
    async restitution({ speed, tolerance }, { signal }) {
      log.push(`${speed} ${tolerance}`);
      if (speed === refuse) throw new CoreError('speed: got 7');
      return later({ speed, cutoff: speed === hopeless ? 0 : 45, reason: 'no impact ends' } as Restitution, signal);
    },
    async collision({ speed, cutoff }, { signal }) {
      log.push(`collision ${speed} ${cutoff}`);
      return later({} as Collision, signal);
    },
    async oblique({ speed, tolerance }, { signal }) {
      log.push(`oblique ${speed} ${tolerance}`);
      return later({ speed, cutoff: 16 } as Restitution, signal);
    },
    async obliqueCollision({ speed, cutoff }, { signal }) {
      log.push(`collision ${speed} ${cutoff}`);
      return later({ across: new Float64Array() }, signal);
    },
    async curve({ speeds }, { deliver, signal }) {
      log.push(`curve of ${speeds.length}`);
      for (const [index, speed] of speeds.entries()) {
        await later(null, signal);
        deliver?.({ speed, restitution: 1, error: 0, converged: true } as never, index);
      }
    },
  };
  return ((question: string, _: Encounter, given: Given, asking: Asking<never> = {}) =>
    answers[question]!(given, asking)) as unknown as Core;
}

function audience(log: string[]) {
  return {
    began: () => undefined,
    first: (_: Encounter, result: Restitution) => void log.push(`first ${result.speed}`),
    final: (_: Encounter, result: Restitution) => void log.push(`final ${result.speed}`),
    collision: () => void log.push('shown'),
    oblique: () => void log.push('shown oblique'),
    failed: (line: string, refused: boolean) => void log.push(`failed ${line} ${refused}`),
  };
}

describe('a session', () => {
  it('computes the first value, the accurate one, then the collision', async () => {
    vi.useFakeTimers();
    const log: string[] = [];
    createSession(core(10, log), audience(log))(encounter, at(0.1));
    await vi.runAllTimersAsync();
    expect(log).toEqual(['0.1 0.01', 'first 0.1', '0.1 0.001', 'final 0.1', 'collision 0.1 45', 'shown']);
  });
  it('with friction asks for the collision rule once', async () => {
    vi.useFakeTimers();
    const log: string[] = [];
    createSession(core(10, log), audience(log))(encounter, motionOf({ ...defaults, friction: 0.3 }));
    await vi.runAllTimersAsync();
    expect(log).toEqual(['oblique 0.1 0.01', 'first 0.1', 'final 0.1', 'collision 0.1 16', 'shown oblique']);
  });
  it('says why there is no collision', async () => {
    vi.useFakeTimers();
    const log: string[] = [];
    createSession(core(10, log), audience(log))(encounter, at(hopeless));
    await vi.runAllTimersAsync();
    expect(log.slice(-2)).toEqual([`final ${hopeless}`, 'failed no impact ends true']);
  });
  it('shows first values while a drag goes on, and refines the last only', async () => {
    vi.useFakeTimers();
    const log: string[] = [];
    const run = createSession(core(30, log), audience(log));
    for (const speed of [1, 2, 3, 4, 5]) {
      run(encounter, at(speed));
      await vi.advanceTimersByTimeAsync(16);
    }
    await vi.runAllTimersAsync();
    expect(log.filter((line) => line.startsWith('final'))).toEqual(['final 5']);
    expect(log.filter((line) => line.startsWith('first')).length).toBeGreaterThan(2);
    expect(log.filter((line) => line === 'shown').length).toBe(1);
  });
  it('drops a slow first value for newer inputs', async () => {
    vi.useFakeTimers();
    const log: string[] = [];
    const run = createSession(core(5000, log), audience(log));
    run(encounter, at(1));
    await vi.advanceTimersByTimeAsync(10);
    run(encounter, at(2));
    await vi.runAllTimersAsync();
    expect(log.slice(0, 4)).toEqual(['1 0.01', 'aborted', '2 0.01', 'first 2']);
  });
  it('goes on after what the core refuses', async () => {
    vi.useFakeTimers();
    const log: string[] = [];
    const run = createSession(core(10, log, 7), audience(log));
    run(encounter, at(7));
    await vi.runAllTimersAsync();
    run(encounter, at(1));
    await vi.runAllTimersAsync();
    expect(log.slice(0, 2)).toEqual(['7 0.01', 'failed speed: got 7 true']);
    expect(log.at(-1)).toBe('shown');
  });
});

describe('curves', () => {
  it('are computed once, and continued where they were left', async () => {
    vi.useFakeTimers();
    const log: string[] = [];
    const curves = createCurves(core(10, log), () => undefined, (line) => void log.push(line));
    const other = { ...encounter, first: { ...encounter.first, poisson: 0.5 } };
    curves.want([encounter]);
    await vi.advanceTimersByTimeAsync(105);
    curves.want([other]);
    await vi.runAllTimersAsync();
    curves.want([encounter, other]);
    await vi.runAllTimersAsync();
    expect(log).toEqual(['curve of 49', 'aborted', 'curve of 49', 'curve of 39']);
    expect(curves.of(encounter).points.length).toBe(49);
    expect(new Set(curves.of(encounter).points.map(({ speed }) => speed)).size).toBe(49);
  });
});
