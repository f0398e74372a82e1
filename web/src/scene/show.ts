// What a film of one collision needs: its frames, and the scales that all of them share.

import { max } from 'd3-array';
import type { Collision, Core, Encounter, Frame, Grid } from '../core/protocol';
import { type Meeting, meetingOf, sizesOf } from '../inputs/document';
import { blockOf, lengthOf, sizeOf } from '../inputs/kinds';
import type { Quantity } from './raster';
import { coarseToFine, filmSpan, insertFrame } from './film';
import { gridBelow, gridFor } from './grid';
import { partsOf, type Part } from './parts';
import { magnificationOf, stressUnit, viewOf, type View } from './view';

export interface Show {
  encounter: Encounter;
  meeting: Meeting;
  collision: Collision;
  /** those that are there already, in the order of their times */
  frames: Frame[];
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

/** The film of a collision, as soon as it can play; and the same again whenever it has become finer. */
export async function* produce(
  core: Core, encounter: Encounter, speed: number, cutoff: number, collision: Collision, signal: AbortSignal,
): AsyncGenerator<Show> {
  const sizes = sizesOf(encounter);
  // That of the contact in radii of the larger body, whose smallest part it is.
  const meeting = meetingOf(encounter);
  const { kind, against } = meeting;
  const first = meeting.si ? meeting.first.body[sizeOf(kind)] : 1;
  const halfWidth = max(collision.contact_half_width)! / first / max(sizes)!;
  const block = blockOf(kind, against);
  const size = block && lengthOf(block);
  const thickness = size && meeting.second!.body[size] / first;
  const grid: Grid = { ...gridFor(kind, halfWidth), ...(block && { below: gridBelow(halfWidth, thickness) }) };
  const { from, to } = filmSpan(collision.begin, collision.end);
  const frames: Frame[] = [];
  let show: Show | undefined;
  for (const times of coarseToFine(from, to, FIRST, LEVELS)) {
    await core('frames', encounter, { speed, cutoff, times, grid },
      { deliver: (frame) => insertFrame(frames, frame), signal });
    signal.throwIfAborted();
    if (frames.length === 0) return;
    show ??= showOf({ encounter, meeting, collision, frames, from, to, parts: partsOf(encounter, sizes, grid, thickness) });
    yield show;
  }
}

/** A film with the scales of the frames that are there. */
function showOf(of: Pick<Show, 'encounter' | 'meeting' | 'collision' | 'frames' | 'from' | 'to' | 'parts'>): Show {
  const { frames, parts } = of;
  const magnification = magnificationOf(frames, parts);
  return {
    ...of, magnification, secondAtRest: secondIsAtRest(frames),
    view: viewOf(frames, parts, magnification, of.meeting.against),
    units: { fringes: stressUnit('fringes', frames, parts), vonMises: stressUnit('vonMises', frames, parts) },
  };
}
