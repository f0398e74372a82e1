// The film of a collision, with its controls.

import { html, render, type TemplateResult } from 'lit-html';
import type { Collision, Core, Encounter } from '../core/protocol';
import { choice, fitCanvas, keyed, messageOf, onResize } from '../drawing/dom';
import { motionIsReduced, readTheme } from '../drawing/theme';
import type { Quantity } from './raster';
import { advance, frameAt, LENGTH, type Clock } from './film';
import { describe, phaseAt, slowness, timeInWords } from './phases';
import { drawPicture, pictureHeight } from './picture';
import { produce, type Show } from './show';

const STEPS = 64; // of the film
const PIECES = 400; // of the scrubber
const PRINT = 800; // width of a picture of a scene that is not on the page

const SPEEDS: [number, string][] = [[0.1, '⅒ ×'], [0.25, '¼ ×'], [0.5, '½ ×'], [1, '1 ×'], [2, '2 ×'], [4, '4 ×']];
const COLORS: [Quantity, string][] = [['fringes', 'Fringes'], ['vonMises', 'von Mises stress']];

const PLAY = 'M4 2.5v11l9.5-5.5z';
const PAUSE = 'M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z';
const BACK = 'M12 2.5v11L5 8zM3 2.5h1.8v11H3z';
const NEXT = 'M4 2.5v11L11 8zM11.2 2.5H13v11h-1.8z';

/** Makes an empty scene in an element. `cursor` is called whenever the film's time changes by itself or by its
 *  controls. */
export function createScene(host: HTMLElement, core: Core, cursor: (time: number) => void) {
  let show: Show | undefined;
  let asked: AbortController | undefined;
  let clock: Clock = { time: 0, rested: 0 };
  let [playing, speed, last, turn] = [false, 1, 0, 0];
  let [note, words] = ['', ''];
  let begun = false; // whether a film has ever played by itself
  let quantity: Quantity = 'fringes';

  tell();
  const place = host.querySelector<HTMLElement>('.scene')!;
  const canvas = host.querySelector('canvas')!;
  onResize(place, draw);

  /** Brings all but the picture up to date. */
  function tell(): void {
    const { time } = clock;
    const label = !show ? 'Film of the collision: not ready yet'
      : playing ? 'Film of the collision' : `Film of the collision: ${describe(show.collision, time)}`;
    render(html`
      <div class="scene" @keydown=${onKey}>
        <canvas role="img" tabindex="0" aria-label=${label}></canvas>
        ${controls()}
        <p class="scene-note">${note}</p>
        <output class="unseen" aria-live="polite">${words}</output>
      </div>`, host);
  }

  function controls(): TemplateResult {
    const button = (name: string, path: string, act: () => void, kind = ''): TemplateResult => html`
      <button type="button" class=${kind} title=${name} aria-label=${name} ?disabled=${!show} @click=${act}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
          <path fill="currentColor" d=${path}></path>
        </svg>
      </button>`;
    const step = (direction: 1 | -1): void => goTo(shareOf() + direction / STEPS);
    const scrub = (event: Event): void => goTo(Number((event.target as HTMLInputElement).value) / PIECES);
    const said = show ? `${timeInWords(show.collision, clock.time)}, ${phaseAt(show.collision, clock.time)}` : '';
    return html`
      <div class="scene-controls" role="group" aria-label="Film of the collision">
        ${button(playing ? 'Pause' : 'Play', playing ? PAUSE : PLAY, toggle, 'scene-play')}
        ${button('Step back', BACK, () => step(-1))} ${button('Step forward', NEXT, () => step(1))}
        <input type="range" class="scene-time" min="0" max=${PIECES} step="1" aria-label="Time in the film"
          aria-valuetext=${said} .value=${String(Math.round(PIECES * shareOf()))} ?disabled=${!show} @input=${scrub} />
        ${choice('Playback', SPEEDS, speed, (factor) => {
          speed = factor;
          tellSpeed();
          tell();
        })}
        ${choice('Colours', COLORS, quantity, (chosen) => {
          quantity = chosen;
          draw();
        }, show?.encounter.kind === 'rod')}
      </div>`;
  }

  /** The share of the film that has passed. */
  function shareOf(): number {
    return show ? (clock.time - show.from) / (show.to - show.from) : 0;
  }

  function goTo(share: number): void {
    if (show) go(show.from + share * (show.to - show.from), true);
  }

  function toggle(): void {
    if (playing) pause();
    else play();
  }

  function onKey(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (!show || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === ' ' && (target === canvas || target.tagName === 'INPUT')) {
      event.preventDefault();
      toggle();
    }
    const share = target === canvas && keyed(event, { at: shareOf(), first: 0, last: 1, step: 1 / STEPS });
    if (typeof share === 'number') goTo(share);
  }

  function go(time: number, own: boolean): void {
    if (!show) return;
    pause();
    clock = { time: Math.min(show.to, Math.max(show.from, time)), rested: 0 };
    if (own) words = describe(show.collision, clock.time);
    draw();
    if (own) cursor(clock.time);
  }

  function tellSpeed(): void {
    if (!show) return;
    const slow = slowness(show.to - show.from, show.collision.units.time, LENGTH / speed);
    const still = ' The second body is drawn at rest: its inside is not computed.';
    note = slow + (show.secondAtRest ? still : '');
  }

  function play(): void {
    if (!show || playing) return;
    playing = true;
    last = performance.now();
    turn = requestAnimationFrame(tick);
    tell();
  }

  function pause(): void {
    if (!playing) return;
    playing = false;
    cancelAnimationFrame(turn);
    draw();
  }

  function tick(now: number): void {
    if (!show || !playing) return;
    clock = advance(clock, Math.min(0.1, (now - last) / 1000), speed, show.from, show.to);
    last = now;
    draw();
    cursor(clock.time);
    turn = requestAnimationFrame(tick);
  }

  function draw(): void {
    tell();
    if (show && place.clientWidth) drawOn(canvas, place.clientWidth, show);
  }

  /** Draws the film at its time, with at least so many pixels of the device for one. */
  function drawOn(to: HTMLCanvasElement, width: number, its: Show, least = 1): void {
    const frame = frameAt(its.film, clock.time);
    if (!frame) return;
    const density = fitCanvas(to, width, pictureHeight(its, width), least);
    drawPicture(to, width, density, its, frame, clock.time, quantity, readTheme(place));
  }

  function start(next: Show): void {
    const share = shareOf();
    show = next;
    clock = { time: next.from + share * (next.to - next.from), rested: 0 };
    tellSpeed();
    draw();
    cursor(clock.time);
    if (!begun && !motionIsReduced()) play();
    else if (!begun) go(0.5 * (next.collision.begin + next.collision.end), true);
    begun = true;
  }

  return {
    /** Shows a collision; what was shown before stays until the first frames of the new one are there. */
    show(encounter: Encounter, at: number, cutoff: number, collision: Collision): void {
      asked?.abort();
      const mine = (asked = new AbortController());
      note = 'Computing the film …';
      tell();
      const finer = (): void => void (!playing && draw());
      produce(core, encounter, at, cutoff, collision, mine.signal, start, finer).catch((error) => {
        if (mine.signal.aborted) return;
        note = words = `The film could not be computed: ${messageOf(error)}`;
        tell();
      });
    },
    /** Stops, and goes to a time, in the collision's units. */
    seek: (time: number): void => go(time, false),
    picture: {
      canvas(): HTMLCanvasElement {
        if (!show) throw new Error('there is no film to draw yet');
        const copy = document.createElement('canvas');
        drawOn(copy, place.clientWidth || PRINT, show, 2);
        return copy;
      },
    },
  };
}
