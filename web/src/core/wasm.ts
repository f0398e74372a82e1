// The core as Emscripten makes it (web/core/module.cpp). It gets an encounter as a document.
import { type Collision, CoreError, type CurvePoint, type Frame, type Grid, type Restitution, type Shape, type Units }
  from './protocol';

/** An answer, or one line that says why there is none. */
export type Answered<T> = (T & { error?: undefined }) | { error: string };

/** What an answer holds. Throws CoreError where there is none. */
export function value<T extends object>(answer: Answered<T>): T {
  if (answer.error !== undefined) throw new CoreError(answer.error);
  return answer as T;
}

interface Deletable {
  delete(): void;
}

export interface WasmCollision extends Deletable {
  frames(times: number[], grid: Grid, deliver: (frame: Frame, index: number) => void): Answered<object>;
}

export interface WasmEncounter extends Deletable {
  restitution(speed: number, tolerance: number): Answered<Restitution>;
  collision(speed: number, cutoff: number): Answered<{ collision: WasmCollision; series: Collision }>;
  shape(body: number, order: number, index: number, grid: Grid): Answered<Shape>;
  curve(
    speeds: number[], tolerance: number, deliver: (point: CurvePoint, index: number) => void,
  ): Answered<object>;
  header(slowest: number, fastest: number, error: number): Answered<{ text: string }>;
}

export interface WasmCore {
  makeEncounter(document: string): Answered<{ encounter: WasmEncounter }>;
  units(document: string): Answered<{ units: Units }>;
  ownSpeed(document: string, speed: number): Answered<{ speed: number }>;
  number(name: string, text: string): Answered<{ value: number }>;
  series(name: string, text: string): Answered<{ values: Float64Array }>;
}
