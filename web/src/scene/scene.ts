// The film of a collision, with its controls.

import { html, render } from 'lit-html';
import type { Collision, Core, Encounter, Frame } from '../core/protocol';
import { keyed } from '../drawing/dom';
import type { Picture } from '../drawing/files';
import { fitCanvas, onResize } from '../drawing/dom';
import { motionIsReduced, readTheme } from '../drawing/theme';
import { newScratch } from './bodies';
import { advance, LENGTH, type Clock } from './clock';
import type { Quantity } from './colors';
import { controlsOf } from './controls';
import { frameAt } from './frames';
import { describe, phaseAt, slowness, timeInWords } from './phases';
import { drawPicture, pictureHeight } from './picture';
import { produce, type Show } from './show';
import './scene.css';

export interface Scene {
  /** Shows a collision; what was shown before stays until the first frames of the new one are there. */
  show(encounter: Encounter, speed: number, cutoff: number, collision: Collision): void;
  /** Stops, and goes to a time, in the collision's units. */
  seek(time: number): void;
  /** Calls back whenever the film's time changes by itself or by its controls. */
  onCursor(callback: (time: number) => void): void;
  readonly picture: Picture;
}

const STEPS = 64; // of the film
const PRINT = 800; // width of a picture of a scene that is not on the page

/** Makes an empty scene in an element. */
export function createScene(host: HTMLElement, core: Core): Scene {
  const scratch = newScratch();
  let show: Show | undefined;
  let asked: AbortController | undefined;
  let clock: Clock = { time: 0, rested: 0 };
  let [playing, speed, last, turn] = [false, 1, 0, 0];
  let [note, words] = ['', ''];
  let begun = false; // whether a film has ever played by itself
  let quantity: Quantity = 'fringes';
  let spare: Frame | undefined;
  let cursor: (time: number) => void = () => undefined;

  const actions = {
    toggle: () => (playing ? pause() : play()),
    step: (direction: 1 | -1) => show && go(clock.time + (direction * (show.to - show.from)) / STEPS, true),
    scrub: (share: number) => show && go(show.from + share * (show.to - show.from), true),
    speed(factor: number) {
      speed = factor;
      tellSpeed();
      tell();
    },
    color(chosen: Quantity) {
      quantity = chosen;
      draw();
    },
  };
  tell();
  const place = host.querySelector<HTMLElement>('.scene')!;
  const canvas = host.querySelector('canvas')!;
  onResize(place, draw);

  /** Brings all but the picture up to date. */
  function tell(): void {
    const time = clock.time;
    const said = show ? `${timeInWords(show.collision, time)}, ${phaseAt(show.collision, time)}` : '';
    const label = !show ? 'Film of the collision: not ready yet'
      : playing ? 'Film of the collision' : `Film of the collision: ${describe(show.collision, time)}`;
    render(html`
      <div class="scene" @keydown=${onKey}>
        <canvas role="img" tabindex="0" aria-label=${label}></canvas>
        ${controlsOf({
          playing, speed, quantity, words: said, share: show ? (time - show.from) / (show.to - show.from) : 0,
          ready: show !== undefined, colored: show?.encounter.kind !== 'rod',
        }, actions)}
        <p class="scene-note">${note}</p>
        <output class="unseen" aria-live="polite">${words}</output>
      </div>`, host);
  }

  function onKey(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (!show || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === ' ' && (target === canvas || target.tagName === 'INPUT')) {
      event.preventDefault();
      actions.toggle();
    }
    if (target !== canvas) return;
    const { from, to } = show;
    const time = keyed(event, { at: clock.time, first: from, last: to, step: (to - from) / STEPS });
    if (time !== undefined) go(time, true);
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
    if (!show || !place.clientWidth) return;
    const width = place.clientWidth;
    const density = fitCanvas(canvas, width, pictureHeight(show, width));
    const frame = frameAt(show.film, clock.time, spare);
    if (!frame) return;
    spare = frame;
    drawPicture(canvas, width, density, show, frame, clock.time, quantity, readTheme(place), scratch);
  }

  function start(next: Show): void {
    const share = show ? (clock.time - show.from) / (show.to - show.from) : 0;
    show = next;
    spare = undefined;
    clock = { time: next.from + share * (next.to - next.from), rested: 0 };
    tellSpeed();
    draw();
    cursor(clock.time);
    if (!begun && !motionIsReduced()) play();
    else if (!begun) go(0.5 * (next.collision.begin + next.collision.end), true);
    begun = true;
  }

  return {
    show(encounter, at, cutoff, collision) {
      asked?.abort();
      const mine = (asked = new AbortController());
      note = 'Computing the film …';
      tell();
      const finer = (): void => void (!playing && draw());
      produce(core, encounter, at, cutoff, collision, mine.signal, start, finer).catch((error) => {
        if (mine.signal.aborted) return;
        note = words = `The film could not be computed: ${error instanceof Error ? error.message : error}`;
        tell();
      });
    },
    seek: (time) => go(time, false),
    onCursor(callback) {
      cursor = callback;
    },
    picture: {
      canvas() {
        const frame = show && frameAt(show.film, clock.time);
        if (!show || !frame) throw new Error('there is no film to draw yet');
        const width = place.clientWidth || PRINT;
        const copy = document.createElement('canvas');
        const density = Math.max(2, devicePixelRatio);
        [copy.width, copy.height] = [density * width, density * pictureHeight(show, width)];
        drawPicture(copy, width, density, show, frame, clock.time, quantity, readTheme(place), newScratch());
        return copy;
      },
    },
  };
}
