// The film of a collision, with its controls.

import type { Collision, Core, Encounter, Frame } from '../core/protocol';
import { fitCanvas, onResize } from '../drawing/sized';
import { pngOfCanvas } from '../drawing/files';
import { motionIsReduced, readTheme } from '../drawing/theme';
import { newScratch } from './bodies';
import { advance, LENGTH, type Clock } from './clock';
import type { Quantity } from './colors';
import { createControls } from './controls';
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
  clear(): void;
  toPng(): Promise<Blob>;
}

const STEPS = 64; // of the film
const PRINT = 800; // width of a picture of a scene that is not on the page

/** Makes an empty scene in an element. */
export function createScene(host: HTMLElement, core: Core): Scene {
  const canvas = document.createElement('canvas');
  canvas.setAttribute('role', 'img');
  canvas.tabIndex = 0;
  const words = Object.assign(document.createElement('output'), { className: 'scene-words' });
  words.setAttribute('aria-live', 'polite');
  const scratch = newScratch();
  let show: Show | undefined;
  let asked: AbortController | undefined;
  let clock: Clock = { time: 0, rested: 0 };
  let [playing, speed, last, turn] = [false, 1, 0, 0];
  let begun = false; // whether a film has ever played by itself
  let quantity: Quantity = 'fringes';
  let spare: Frame | undefined;
  let cursor: (time: number) => void = () => undefined;

  const controls = createControls({
    toggle: () => (playing ? pause() : play()),
    step: (direction) => show && go(clock.time + (direction * (show.to - show.from)) / STEPS, true),
    scrub: (share) => show && go(show.from + share * (show.to - show.from), true),
    speed: (factor) => {
      speed = factor;
      tellSpeed();
    },
    color: (chosen) => {
      quantity = chosen;
      draw();
    },
  });
  const place = document.createElement('div');
  place.className = 'scene';
  const note = Object.assign(document.createElement('p'), { className: 'scene-note' });
  place.append(canvas, controls.element, note, words);
  host.append(place);
  place.addEventListener('keydown', onKey);
  onResize(place, draw);
  empty();

  function onKey(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (!show || event.altKey || event.ctrlKey || event.metaKey) return;
    const onCanvas = target === canvas;
    const steps: Record<string, () => void> = {
      ' ': () => (playing ? pause() : play()),
      ...(onCanvas && {
        ArrowRight: () => go(clock.time + (show!.to - show!.from) / STEPS, true),
        ArrowLeft: () => go(clock.time - (show!.to - show!.from) / STEPS, true),
        Home: () => go(show!.from, true),
        End: () => go(show!.to, true),
      }),
    };
    if (event.key === ' ' && !onCanvas && target.tagName !== 'INPUT') return;
    const action = steps[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  function empty(): void {
    canvas.setAttribute('aria-label', 'Film of the collision: not ready yet');
    controls.setEnabled(false);
    note.textContent = '';
  }

  function go(time: number, own: boolean): void {
    if (!show) return;
    pause();
    clock = { time: Math.min(show.to, Math.max(show.from, time)), rested: 0 };
    draw();
    if (own) {
      words.textContent = describe(show.collision, clock.time);
      cursor(clock.time);
    }
  }

  function tellSpeed(): void {
    if (!show) return;
    const slow = slowness(show.to - show.from, show.collision.units.time, LENGTH / speed);
    const still = ' The second body is drawn at rest: its inside is not computed.';
    note.textContent = slow + (show.secondAtRest ? still : '');
  }

  function play(): void {
    if (!show || playing) return;
    playing = true;
    controls.setPlaying(true);
    last = performance.now();
    turn = requestAnimationFrame(tick);
  }

  function pause(): void {
    if (!playing) return;
    playing = false;
    cancelAnimationFrame(turn);
    controls.setPlaying(false);
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
    if (!show || !place.clientWidth) return;
    const width = place.clientWidth;
    const theme = readTheme(place);
    const density = fitCanvas(canvas, width, pictureHeight(show, width));
    const frame = frameAt(show.film, clock.time, spare);
    if (!frame) return;
    spare = frame;
    drawPicture(canvas, width, density, show, frame, clock.time, quantity, theme, scratch);
    const { collision, from, to } = show;
    const phase = phaseAt(collision, clock.time);
    controls.setTime((clock.time - from) / (to - from), `${timeInWords(collision, clock.time)}, ${phase}`);
    if (!playing) canvas.setAttribute('aria-label', `Film of the collision: ${describe(show.collision, clock.time)}`);
  }

  function start(next: Show): void {
    const share = show ? (clock.time - show.from) / (show.to - show.from) : 0;
    show = next;
    spare = undefined;
    clock = { time: next.from + share * (next.to - next.from), rested: 0 };
    controls.setEnabled(true);
    controls.setColored(next.encounter.kind !== 'rod');
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
      note.textContent = 'Computing the film …';
      const finer = (): void => void (!playing && draw());
      produce(core, encounter, at, cutoff, collision, mine.signal, start, finer).catch((error) => {
        if (mine.signal.aborted) return;
        const line = `The film could not be computed: ${error instanceof Error ? error.message : error}`;
        note.textContent = words.textContent = line;
      });
    },
    seek: (time) => go(time, false),
    onCursor(callback) {
      cursor = callback;
    },
    clear() {
      asked?.abort();
      pause();
      show = spare = undefined;
      canvas.getContext('2d')!.clearRect(0, 0, canvas.width, canvas.height);
      empty();
    },
    async toPng() {
      const frame = show && frameAt(show.film, clock.time);
      if (!show || !frame) throw new Error('there is no film to draw yet');
      const width = place.clientWidth || PRINT;
      const copy = document.createElement('canvas');
      const density = Math.max(2, devicePixelRatio);
      [copy.width, copy.height] = [density * width, density * pictureHeight(show, width)];
      drawPicture(copy, width, density, show, frame, clock.time, quantity, readTheme(place), newScratch());
      return pngOfCanvas(copy);
    },
  };
}
