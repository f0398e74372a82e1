// What sticks and what slips in a contact: a picture with the time to the right and the place along the surface up.

import { bisectCenter, bisectRight, max } from 'd3-array';
import type { ObliqueCollision } from '../core/protocol';
import { box, write } from '../drawing/canvas';
import { withUnit, written } from '../drawing/numbers';
import { look, type Theme } from '../drawing/theme';
import { type Word, say } from '../drawing/words';

const OPEN = 2;
const COLUMNS = 480;
const ROWS = 161;

/** What contact points do, in words; the numbers are those of the core. */
export const GRIPS: [grip: number, words: Word][] = [[0, 'grip.sticks'], [1, 'grip.up'], [-1, 'grip.down']];

export function colorOf(grip: number, theme: Theme): string {
  return look([0, 1, -1].indexOf(grip), theme).color;
}

/** What points do at a time, as shares of those that touch. */
export function sharesAt({ time: times, places, grips }: ObliqueCollision, time: number): Map<number, number> {
  const shares = new Map<number, number>();
  const k = bisectRight(times, time) - 1;
  if (k < 0) return shares;
  const touching = grips.subarray(k * places.length, (k + 1) * places.length).filter((each) => each !== OPEN);
  for (const each of touching) shares.set(each, (shares.get(each) ?? 0) + 1 / touching.length);
  return shares;
}

/** The widest place that touches. */
export function reachOf({ places, grips }: ObliqueCollision): number {
  return max(grips, (grip, k) => (grip === OPEN ? 0 : Math.abs(places[k % places.length]!))) || 1;
}

/** What is at a time and a place of a contact; of rings on both sides. */
export function gripAt({ time: times, places, grips }: ObliqueCollision, time: number, place: number): number {
  const k = bisectRight(times, time) - 1;
  if (k < 0 || time > times.at(-1)!) return OPEN;
  const rings = places[0]! >= 0;
  return grips[k * places.length + bisectCenter(places, rings ? Math.abs(place) : place)]!;
}

/** The strip as an image, from the first contact to the last. */
export function stripOf(collision: ObliqueCollision, theme: Theme): HTMLCanvasElement {
  const { begin, end } = collision;
  const reach = reachOf(collision);
  const canvas = Object.assign(document.createElement('canvas'), { width: COLUMNS, height: ROWS });
  const context = canvas.getContext('2d')!;
  for (let column = 0; column < COLUMNS; ++column) {
    const time = begin + ((end - begin) * (column + 0.5)) / COLUMNS;
    for (let row = 0; row < ROWS; ++row) {
      const grip = gripAt(collision, time, reach * (1 - (2 * (row + 0.5)) / ROWS));
      if (grip === OPEN) continue;
      box(context, colorOf(grip, theme), column, row, 1, 1);
    }
  }
  return canvas;
}

const HEAD = 24;
const FOOT = 40;
const LEFT = 46;

/** Draws the strip in a box, with its cursor and its legend. */
export function drawStrip(
  context: CanvasRenderingContext2D, place: Record<'x' | 'y' | 'width' | 'height', number>, collision: ObliqueCollision,
  strip: HTMLCanvasElement, time: number, theme: Theme,
): void {
  const { begin, end, units } = collision;
  const [left, top, width, height] = [place.x + LEFT, place.y + HEAD, place.width - LEFT - 8, place.height - HEAD - FOOT];
  context.imageSmoothingEnabled = false;
  context.drawImage(strip, left, top, width, height);
  context.strokeStyle = theme.muted;
  context.lineWidth = 1;
  context.strokeRect(left, top, width, height);
  const reach = written(reachOf(collision), 2);
  for (const [words, x, y, align] of [
    [`${reach} R`, left - 5, top + 9, 'right'], [`−${reach} R`, left - 5, top + height, 'right'],
    ['0', left - 5, top + height / 2 + 4, 'right'], ['0', left, top + height + 14, 'left'],
    [withUnit(end - begin, units.time), left + width, top + height + 14, 'right'],
  ] as const) write(context, words, x, y, theme.muted, align, 11);
  write(context, say('grip.title'), left, place.y + 16, theme.text, 'left', 11);
  let x = left;
  for (const [grip, name] of GRIPS) {
    const words = say(name);
    box(context, colorOf(grip, theme), x, top + height + 22, 10, 10);
    write(context, words, x + 14, top + height + 32, theme.text, 'left', 12);
    x += 26 + context.measureText(words).width;
  }
  if (time < begin || time > end) return;
  box(context, theme.text, left + (width * (time - begin)) / (end - begin) - 1, top - 3, 2, height + 6);
}
