// What a film of one collision needs: its frames, and the scales that all of them share.

import type { Collision, Core, Encounter, Frame, Grid } from '../core/protocol';
import { sizeOf } from '../inputs/kinds';
import type { Quantity } from './colors';
import { insertFrame, type Film } from './frames';
import { gridBelow, gridFor } from './grid';
import { magnificationOf } from './magnify';
import type { Placed } from './mesh';
import { stressUnit } from './scales';
import { coarseToFine, filmSpan } from './schedule';
import { placedBodies, viewOf, type View } from './view';

export interface Show {
  encounter: Encounter;
  collision: Collision;
  grid: Grid;
  film: Film;
  from: number;
  to: number;
  placed: Placed[];
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
  const block = encounter.against.kind === 'half-space';
  const grid: Grid = { ...gridFor(encounter.kind, halfWidth), ...(block && { below: gridBelow(halfWidth) }) };
  const { from, to } = filmSpan(collision.begin, collision.end);
  const [first, ...rest] = coarseToFine(from, to, FIRST, LEVELS);
  const film: Film = { times: [], frames: [] };
  const add = (frame: Frame): void => insertFrame(film, frame);
  await core.frames(encounter, speed, cutoff, first!, grid, add, signal);
  signal.throwIfAborted();
  if (!film.frames.length) return;
  const bodies = collision.bodies.filter((each) => each.kind !== 'half-space');
  const placed = placedBodies(encounter, bodies.map((each) => each.radius));
  const magnification = magnificationOf(film.frames, grid);
  ready({
    encounter, collision, grid, film, from, to, placed, magnification,
    view: viewOf(film.frames, placed, grid, magnification, encounter.against.kind),
    units: { fringes: stressUnit('fringes', film.frames, grid), vonMises: stressUnit('vonMises', film.frames, grid) },
    secondAtRest: secondIsAtRest(film.frames),
  });
  for (const times of rest) {
    await core.frames(encounter, speed, cutoff, times, grid, add, signal);
    signal.throwIfAborted();
    finer();
  }
}

/** Maximum half width of the contact in radii of the larger body, whose smallest part it is. */
function relativeHalfWidth({ kind, si, first }: Encounter, { bodies, halfWidth }: Collision): number {
  const greatest = halfWidth.reduce((most, each) => Math.max(most, each), 0) / (si ? first[sizeOf(kind)] : 1);
  return greatest / Math.max(...bodies.filter((each) => each.kind !== 'half-space').map((each) => each.radius));
}
