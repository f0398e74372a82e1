// The frames of a film that are there already, and what is between two of them.

import type { BodyFrame, Frame } from '../core/protocol';
import { lastNotAbove } from '../drawing/samples';

/** Frames in the order of their times. */
export interface Film {
  times: number[];
  frames: Frame[];
}

/** Adds a frame at its place; one with the same time takes the place of the old. */
export function insertFrame(film: Film, frame: Frame): void {
  const k = lastNotAbove(film.times, frame.time);
  const same = k >= 0 && film.times[k] === frame.time;
  film.times.splice(same ? k : k + 1, same ? 1 : 0, frame.time);
  film.frames.splice(same ? k : k + 1, same ? 1 : 0, frame);
}

function mixed(a: BodyFrame, b: BodyFrame, share: number, into?: BodyFrame): BodyFrame {
  const between = (name: 'radial' | 'tangential' | 'vonMises' | 'fringes'): Float32Array => {
    const [from, to] = [a[name], b[name]];
    const out = into?.[name].length === from.length ? into[name] : new Float32Array(from.length);
    for (let k = 0; k < from.length; ++k) out[k] = from[k]! + share * (to[k]! - from[k]!);
    return out;
  };
  return {
    center: a.center + share * (b.center - a.center), radial: between('radial'), tangential: between('tangential'),
    vonMises: between('vonMises'), fringes: between('fringes'),
  };
}

/** The frame of a film at any time: between two of its frames both, mixed by their distance. `into`, an earlier
 *  result that is no longer needed, is written over; a frame of the film never is. */
export function frameAt(film: Film, time: number, into?: Frame): Frame | undefined {
  const k = lastNotAbove(film.times, time);
  if (k < 0 || k >= film.frames.length - 1) return film.frames[Math.max(0, Math.min(k, film.frames.length - 1))];
  const [a, b] = [film.frames[k]!, film.frames[k + 1]!];
  const share = (time - a.time) / (b.time - a.time);
  const spare = into && !film.frames.includes(into) ? into : undefined;
  return { time, bodies: a.bodies.map((each, n) => mixed(each, b.bodies[n]!, share, spare?.bodies[n])) };
}
