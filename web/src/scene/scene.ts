// The film of a collision, with its controls.

import { nothing } from 'lit-html';
import type { Collision, Core, Encounter, Motion, ObliqueCollision } from '../core/protocol';
import { choice, messageOf } from '../drawing/dom';
import { frameAt } from './film';
import { filmOf } from './oblique_film';
import { describe, phaseAt, slowness, timeInWords } from './phases';
import { drawPicture, pictureHeight } from './picture';
import { createPlayer, type Film } from './player';
import type { Quantity } from './raster';
import { produce, type Show } from './show';

const COLORS: [Quantity, string][] = [['fringes', 'Fringes'], ['vonMises', 'von Mises stress']];

/** Makes an empty scene in an element. `cursor` is called whenever the film's time changes by itself or by its
 *  controls. */
export function createScene(host: HTMLElement, core: Core, cursor: (time: number) => void) {
  let shown: Show | undefined;
  let oblique = false; // such a film has no colours to choose
  let asked: AbortController | undefined;
  let quantity: Quantity = 'fringes';
  const colors = () => choice('Colours', COLORS, quantity, (chosen) => {
    quantity = chosen;
    player.redraw();
  }, shown?.meeting.kind === 'rod');
  const player = createPlayer(host, 'Film of the collision', cursor, () => (oblique ? nothing : colors()));

  function film(show: Show): Film {
    const { from, to, collision, secondAtRest } = show;
    const still = secondAtRest ? ' The second body is drawn at rest: its inside is not computed.' : '';
    return {
      from, to, still: 0.5 * (collision.begin + collision.end),
      describe: (time) => describe(collision, time),
      said: (time) => `${timeInWords(collision, time)}, ${phaseAt(collision, time)}`,
      note: (seconds) => slowness(to - from, collision.units.time, seconds) + still,
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
      player.say('Computing the film …');
      let first = true;
      try {
        for await (const next of produce(core, encounter, at, cutoff, collision, mine.signal)) {
          [shown, oblique] = [next, false];
          if (first) player.show(film(next));
          else player.redraw();
          first = false;
        }
      } catch (error) {
        if (!mine.signal.aborted) player.say(`The film could not be computed: ${messageOf(error)}`, true);
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
