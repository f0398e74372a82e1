// The frames of a film that are there already, and what is between two of them.

import type { BodyFrame, Frame, Inside } from '../core/protocol';
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

function mixed(a: Float32Array, b: Float32Array, share: number, into?: Float32Array): Float32Array {
  const out = into?.length === a.length ? into : new Float32Array(a.length);
  for (let k = 0; k < a.length; ++k) out[k] = a[k]! + share * (b[k]! - a[k]!);
  return out;
}

function mixedInside(a: Inside, b: Inside, share: number, into?: Inside): Inside {
  return {
    radial: mixed(a.radial, b.radial, share, into?.radial),
    tangential: mixed(a.tangential, b.tangential, share, into?.tangential),
    vonMises: mixed(a.vonMises, b.vonMises, share, into?.vonMises),
    fringes: mixed(a.fringes, b.fringes, share, into?.fringes),
  };
}

function mixedBody(a: BodyFrame, b: BodyFrame, share: number, into?: BodyFrame): BodyFrame {
  return { center: a.center + share * (b.center - a.center), ...mixedInside(a, b, share, into) };
}

/** The frame of a film at any time: between two of its frames both, mixed by their distance. `into`, an earlier
 *  result that is no longer needed, is written over; a frame of the film never is. */
export function frameAt(film: Film, time: number, into?: Frame): Frame | undefined {
  const k = lastNotAbove(film.times, time);
  if (k < 0 || k >= film.frames.length - 1) return film.frames[Math.max(0, Math.min(k, film.frames.length - 1))];
  const [a, b] = [film.frames[k]!, film.frames[k + 1]!];
  const share = (time - a.time) / (b.time - a.time);
  const spare = into && !film.frames.includes(into) ? into : undefined;
  const frame: Frame = {
    time,
    bodies: a.bodies.map((each, n) => mixedBody(each, b.bodies[n]!, share, spare?.bodies[n])),
  };
  if (a.block && b.block) frame.block = mixedInside(a.block, b.block, share, spare?.block);
  return frame;
}
