// The film of a collision: its frames with the scales that all of them share, and its controls.
import { max } from 'd3-array';
import { nothing } from 'lit-html';
import type { Collision, Core, Encounter, Frame, Grid, Motion, ObliqueCollision } from '../core/protocol';
import { choice, messageOf } from '../drawing/dom';
import { say } from '../drawing/words';
import { type Meeting, meetingOf, sizesOf } from '../inputs/document';
import { blockOf, lengthOf, sizeOf } from '../inputs/kinds';
import { coarseToFine, describe, filmSpan, frameAt, insertFrame, phaseAt, slowness, timeInWords } from './film';
import { gridBelow, gridFor } from './grid';
import { filmOf } from './oblique_film';
import { type Part, partsOf } from './parts';
import { drawPicture, pictureHeight } from './picture';
import { type Film, createPlayer } from './player';
import type { Quantity } from './raster';
import { type View, magnificationOf, stressUnit, viewOf } from './view';

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

const COLORS: [Quantity, string][] = [['fringes', say('film.fringes')], ['vonMises', say('film.mises')]];

/** Makes an empty scene in an element. `cursor` is called whenever the film's time changes by itself or by its
 *  controls. */
export function createScene(host: HTMLElement, core: Core, cursor: (time: number) => void) {
  let shown: Show | undefined;
  let oblique = false; // such a film has no colours to choose
  let asked: AbortController | undefined;
  let quantity: Quantity = 'fringes';
  const colors = () => choice(say('film.colours'), COLORS, quantity, (chosen) => {
    quantity = chosen;
    player.redraw();
  }, shown?.meeting.kind === 'rod');
  const player = createPlayer(host, say('film.name'), cursor, () => (oblique ? nothing : colors()));

  function film(show: Show): Film {
    const { from, to, collision, secondAtRest, meeting } = show;
    const coated = [meeting.first, meeting.second].some((side) => side && side.body.coat !== 0);
    const hollow = meeting.kind === 'hollow-sphere';
    const more = (hollow ? say('film.hollow') : secondAtRest ? say('film.at_rest') : '') + (coated ? say('film.coat') : '');
    return {
      from, to, still: 0.5 * (collision.begin + collision.end),
      describe: (time) => describe(collision, time),
      said: (time) => `${timeInWords(collision, time)}, ${say(`phase.${phaseAt(collision, time)}`)}`,
      note: (seconds) => slowness(to - from, collision.units.time, seconds) + more,
      height: (width) => pictureHeight(show, width),
      draw(canvas, width, density, time, theme): void {
        const frame = frameAt(show.frames, time);
        if (frame) drawPicture(canvas, width, density, show, frame, time, quantity, theme);
      },
    };
  }

  return {
    /** Shows a collision; what was shown before stays until the first frames of the new one are there. */
    async show(encounter: Encounter, at: number, cutoff: number, collision: Collision): Promise<void> {
      asked?.abort();
      const mine = (asked = new AbortController());
      player.say(say('film.computing'));
      let first = true;
      try {
        for await (const next of produce(core, encounter, at, cutoff, collision, mine.signal)) {
          [shown, oblique] = [next, false];
          if (first) player.show(film(next));
          else player.redraw();
          first = false;
        }
      } catch (error) {
        if (!mine.signal.aborted) player.say(say('film.failed', { why: messageOf(error) }), true);
      }
    },
    /** Shows an oblique one, by rigid bodies and by what sticks and slips. */
    showOblique(encounter: Encounter, motion: Motion, collision: ObliqueCollision): void {
      asked?.abort();
      oblique = true;
      player.show(filmOf(encounter, motion, collision));
    },
    /** Stops, and goes to a time, in the collision's units. */
    seek: player.seek,
    picture: player.picture,
  };
}
