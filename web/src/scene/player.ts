// Plays a film: its picture, its controls, and its time.

import { html, nothing, render, type TemplateResult } from 'lit-html';
import { fitCanvas } from '../drawing/canvas';
import { choice, keyed, onResize } from '../drawing/dom';
import type { Picture } from '../drawing/pictures';
import { motionIsReduced, readTheme, type Theme } from '../drawing/theme';
import { say } from '../drawing/words';
import { advance, LENGTH, type Clock } from './film';

/** What can be played. */
export interface Film {
  from: number;
  to: number;
  /** where it rests for readers who want no motion */
  still: number;
  /** one sentence for those who do not see the picture, and a few words for its scrubber */
  describe(time: number): string;
  said(time: number): string;
  /** what is below the picture of a film that takes so many seconds */
  note(seconds: number): string;
  /** of a picture of some width, CSS pixels */
  height(width: number): number;
  draw(canvas: HTMLCanvasElement, width: number, density: number, time: number, theme: Theme): void;
}

const STEPS = 64; // of the film
const PIECES = 400; // of the scrubber
const PRINT = 800; // width of a picture of a scene that is not on the page

const SPEEDS: [number, string][] = [[0.1, '⅒ ×'], [0.25, '¼ ×'], [0.5, '½ ×'], [1, '1 ×'], [2, '2 ×'], [4, '4 ×']];

const PLAY = 'M4 2.5v11l9.5-5.5z';
const PAUSE = 'M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z';
const BACK = 'M12 2.5v11L5 8zM3 2.5h1.8v11H3z';
const NEXT = 'M4 2.5v11L11 8zM11.2 2.5H13v11h-1.8z';

/** Makes an empty player in an element, of what `name` says. `cursor` is called whenever the film's time changes by
 *  itself or by its controls; `more` are controls of its own. */
export function createPlayer(
  host: HTMLElement, name: string, cursor: (time: number) => void = () => {},
  more: () => TemplateResult | typeof nothing = () => nothing,
) {
  let film: Film | undefined;
  let clock: Clock = { time: 0, rested: 0 };
  let [playing, speed, last, turn] = [false, 1, 0, 0];
  let [note, words] = ['', ''];
  let begun = false; // whether a film has ever played by itself

  tell();
  const place = host.querySelector<HTMLElement>('.scene')!;
  const canvas = host.querySelector('canvas')!;
  onResize(place, draw);

  /** Brings all but the picture up to date. */
  function tell(): void {
    const label = !film ? say('player.not_ready', { name }) : playing ? name : `${name}: ${film.describe(clock.time)}`;
    render(html`
      <div class="scene" @keydown=${onKey}>
        <canvas role="img" tabindex="0" aria-label=${label}></canvas>
        ${controls()}
        <p class="scene-note">${note}</p>
        <output class="unseen" aria-live="polite">${words}</output>
      </div>`, host);
  }

  function controls(): TemplateResult {
    const button = (title: string, path: string, act: () => void, kind = ''): TemplateResult => html`
      <button type="button" class=${kind} title=${title} aria-label=${title} ?disabled=${!film} @click=${act}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
          <path fill="currentColor" d=${path}></path>
        </svg>
      </button>`;
    const step = (direction: 1 | -1): void => goTo(shareOf() + direction / STEPS);
    const scrub = (event: Event): void => goTo(Number((event.target as HTMLInputElement).value) / PIECES);
    return html`
      <div class="scene-controls" role="group" aria-label=${name}>
        ${button(say(playing ? 'player.pause' : 'player.play'), playing ? PAUSE : PLAY, toggle, 'scene-play')}
        ${button(say('player.back'), BACK, () => step(-1))} ${button(say('player.forward'), NEXT, () => step(1))}
        <input type="range" class="scene-time" min="0" max=${PIECES} step="1" aria-label=${say('player.time')}
          aria-valuetext=${film?.said(clock.time) ?? ''} .value=${String(Math.round(PIECES * shareOf()))}
          ?disabled=${!film} @input=${scrub} />
        ${choice(say('player.speed'), SPEEDS, speed, (factor) => {
          speed = factor;
          tellSpeed();
          tell();
        })}
        ${more()}
      </div>`;
  }

  /** The share of the film that has passed. */
  function shareOf(): number {
    return film ? (clock.time - film.from) / (film.to - film.from) : 0;
  }

  function goTo(share: number): void {
    if (film) go(film.from + share * (film.to - film.from), true);
  }

  function toggle(): void {
    if (playing) pause();
    else play();
  }

  function onKey(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (!film || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === ' ' && (target === canvas || target.tagName === 'INPUT')) {
      event.preventDefault();
      toggle();
    }
    const share = target === canvas && keyed(event, { at: shareOf(), first: 0, last: 1, step: 1 / STEPS });
    if (typeof share === 'number') goTo(share);
  }

  function go(time: number, own: boolean): void {
    if (!film) return;
    pause();
    clock = { time: Math.min(film.to, Math.max(film.from, time)), rested: 0 };
    if (own) words = film.describe(clock.time);
    draw();
    if (own) cursor(clock.time);
  }

  function tellSpeed(): void {
    if (film) note = film.note(LENGTH / speed);
  }

  function play(): void {
    if (!film || playing) return;
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
    if (!film || !playing) return;
    clock = advance(clock, Math.min(0.1, (now - last) / 1000), speed, film.from, film.to);
    last = now;
    draw();
    cursor(clock.time);
    turn = requestAnimationFrame(tick);
  }

  function draw(): void {
    tell();
    if (film && place.clientWidth) drawOn(canvas, place.clientWidth, film);
  }

  /** Draws the film at its time, with at least so many pixels of the device for one. */
  function drawOn(to: HTMLCanvasElement, width: number, its: Film, least = 1): void {
    const density = fitCanvas(to, width, its.height(width), least);
    its.draw(to, width, density, clock.time, readTheme(place));
  }

  return {
    /** Plays a film from the share at which the last one is; or, where it only goes on longer, from the time. */
    show(next: Film, longer = false): void {
      const share = shareOf();
      film = next;
      clock = { time: longer ? clock.time : next.from + share * (next.to - next.from), rested: 0 };
      tellSpeed();
      draw();
      cursor(clock.time);
      if (!begun && !motionIsReduced()) play();
      else if (!begun) go(next.still, true);
      begun = true;
    },
    redraw: draw,
    /** Says what is with the film. */
    say(line: string, aloud = false): void {
      note = line;
      if (aloud) words = line;
      tell();
    },
    /** Stops, and goes to a time. */
    seek: (time: number): void => go(time, false),
    picture: {
      canvas(): HTMLCanvasElement {
        if (!film) throw new Error(say('player.nothing'));
        const copy = document.createElement('canvas');
        drawOn(copy, place.clientWidth || PRINT, film, 2);
        return copy;
      },
    } satisfies Picture,
  };
}
