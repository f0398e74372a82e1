// What a film of one collision needs: its frames, and the scales that all of them share.

import { max } from 'd3-array';
import type { Collision, Core, Encounter, Frame, Grid } from '../core/protocol';
import { sizeOf } from '../inputs/kinds';
import type { Quantity } from './raster';
import { coarseToFine, filmSpan, insertFrame, type Film } from './film';
import { gridBelow, gridFor } from './grid';
import { partsOf, type Part } from './parts';
import { magnificationOf, stressUnit } from './scales';
import { viewOf, type View } from './view';

export interface Show {
  encounter: Encounter;
  collision: Collision;
  film: Film;
  from: number;
  to: number;
  parts: Part[];
  magnification: number;
  view: View;
  units: Record<Quantity, number>;
  /** whether the second body is shown at rest: of a large one only the near side is computed */
  secondAtRest: boolean;
}

/** Whether the second body of all frames has neither stress nor displacement. */
export function secondIsAtRest(frames: Frame[]): boolean {
  const all = frames.flatMap(({ bodies }) => (bodies[1] ? [bodies[1].vonMises, bodies[1].radial] : []));
  return all.length > 0 && all.every((values) => values.every((each) => each === 0));
}

const FIRST = 17; // frames before a film can play
const LEVELS = 4; // 129 frames in the end

/** Asks for the frames of a collision. `ready` gets the film when it can play; it becomes finer from then on, and
 *  `finer` says so. */
export async function produce(
  core: Core, encounter: Encounter, speed: number, cutoff: number, collision: Collision, signal: AbortSignal,
  ready: (show: Show) => void, finer: () => void,
): Promise<void> {
  const halfWidth = relativeHalfWidth(encounter, collision);
  const block = encounter.against === 'half-space';
  const grid: Grid = { ...gridFor(encounter.kind, halfWidth), ...(block && { below: gridBelow(halfWidth) }) };
  const { from, to } = filmSpan(collision.begin, collision.end);
  const [first, ...rest] = coarseToFine(from, to, FIRST, LEVELS);
  const film: Film = { times: [], frames: [] };
  const ask = (times: number[]): Promise<void> => core('frames', encounter, { speed, cutoff, times, grid },
    { deliver: (frame) => insertFrame(film, frame), signal });
  await ask(first!);
  signal.throwIfAborted();
  if (!film.frames.length) return;
  const { frames } = film;
  const parts = partsOf(encounter, collision, grid);
  const magnification = magnificationOf(frames, parts);
  ready({
    encounter, collision, film, from, to, parts, magnification,
    view: viewOf(frames, parts, magnification, encounter.against),
    units: { fringes: stressUnit('fringes', frames, parts), vonMises: stressUnit('vonMises', frames, parts) },
    secondAtRest: secondIsAtRest(frames),
  });
  for (const times of rest) {
    await ask(times);
    signal.throwIfAborted();
    finer();
  }
}

/** Maximum half width of the contact in radii of the larger body, whose smallest part it is. */
function relativeHalfWidth({ kind, si, first }: Encounter, { bodies, halfWidth }: Collision): number {
  return max(halfWidth)! / (si ? first[sizeOf(kind)] : 1) / max(bodies, ({ radius }) => radius)!;
}
