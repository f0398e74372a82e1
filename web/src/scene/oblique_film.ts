// The film of an oblique collision: rigid bodies on their ways in and out, and what sticks and slips where they touch.
import { extent, max } from 'd3-array';
import type { Encounter, Motion, ObliqueCollision } from '../core/protocol';
import { box, cleared, trace, write } from '../drawing/canvas';
import { interpolate, roundDown, significant, written } from '../drawing/numbers';
import type { Theme } from '../drawing/theme';
import { say } from '../drawing/words';
import { sizesOf } from '../inputs/document';
import { describe, filmSpan, phaseAt, slowness, timeInWords } from './film';
import { drawStrip, GRIPS, sharesAt, stripOf } from './grip_strip';
import type { Film } from './player';

export interface Place {
  x: number;
  y: number;
  /** by which it has turned since first contact, counterclockwise, radians */
  angle: number;
}

/** A sampled function, which beyond its ends goes on as it does there. */
export function extended(times: Float64Array, values: Float64Array, time: number): number {
  const last = times.length - 1;
  const inside = Math.min(times[last]!, Math.max(times[0]!, time));
  const k = time < inside ? 1 : last;
  const slope = time === inside ? 0 : (values[k]! - values[k - 1]!) / (times[k]! - times[k - 1]!);
  return interpolate(times, values, inside) + slope * (time - inside);
}

/** Where bodies of some radii are at a time, when all motion from where they touch is magnified. While they touch their
 *  shapes take up what their centres move towards each other: they are drawn as if they only touched. */
export function placesIn({ time: times, begin, bodies }: ObliqueCollision, radii: number[], magnification: number) {
  return (time: number): Place[] => bodies.map(({ x, y, angle }, n) => {
    const since = (values: Float64Array): number =>
      magnification * (extended(times, values, time) - extended(times, values, begin));
    const [side, radius] = [n === 0 ? -1 : 1, radii[n]!];
    const apart = Math.max(0, side * extended(times, x, time) - radius);
    return { x: side * (radius + magnification * apart), y: since(y), angle: since(angle) };
  });
}

const FAR = 2.2; // what the first body moves in a picture, in radii
const TURN = 4; // and what bodies turn in it at most, radians

/** A round magnification of the motion between two times, at least 1. */
export function motionMagnification(collision: ObliqueCollision, radii: number[], from: number, to: number): number {
  const places = [from, to].flatMap(placesIn(collision, radii, 1));
  const far = max(places, ({ x, y }, n) => Math.hypot(Math.abs(x) - radii[n % collision.bodies.length]!, y))!;
  const turned = max(places, ({ angle }) => Math.abs(angle))!;
  return Math.max(1, roundDown(Math.min(FAR / far, TURN / Math.max(turned, 1e-12))));
}

const BEFORE = 0.7; // of the time of contact
const AFTER = 0.9;
const HEAD = 26;
const BODIES = 290; // height of their picture beside the strip, and above it
const ABOVE = 230;
const STRIP = 190;
const WIDE = 560;
const LARGEST = 2.5; // of a second body in the picture, in radii of the first
const GROUND = 0.35;

const isWide = (width: number): boolean => width >= WIDE;

/** The angles to the normal at which bodies come and go, in words. */
function anglesOf({ angle }: Motion, { velocity, tangential }: ObliqueCollision): string {
  const after = (180 / Math.PI) * Math.atan2(tangential.at(-1)!, -velocity.at(-1)!);
  return say('film.angles', { angle: written(angle, 3), after: written(after, 3) });
}

/** The contact at a time, in words. */
export function gripInWords(collision: ObliqueCollision, time: number): string {
  const shares = sharesAt(collision, time);
  return GRIPS.filter(([grip]) => shares.has(grip))
    .map(([grip, words]) => `${Math.round(100 * shares.get(grip)!)} % ${say(words)}`).join(', ');
}

/** The film of a collision. */
export function filmOf(encounter: Encounter, motion: Motion, collision: ObliqueCollision): Film {
  const { begin, end, units } = collision;
  const { from, to } = filmSpan(begin, end, BEFORE, AFTER);
  const radii = sizesOf(encounter).slice(0, collision.bodies.length);
  const magnification = motionMagnification(collision, radii, from, to);
  const places = placesIn(collision, radii, magnification);
  const words = anglesOf(motion, collision);
  let strip: { dark: boolean; image: HTMLCanvasElement } | undefined;
  const drawn = (magnification === 1 ? '' : say('film.motion', { factor: significant(magnification, 3) })) +
    (radii.length > 1 ? say('film.centre') : '');
  return {
    from, to, still: 0.5 * (begin + end),
    describe: (time) => [describe(collision, time), gripInWords(collision, time), words].filter(Boolean).join('; '),
    said: (time) => `${timeInWords(collision, time)}, ${say(`phase.${phaseAt(collision, time)}`)}`,
    note: (seconds) => slowness(to - from, units.time, seconds) + drawn,
    height: (width) => (isWide(width) ? BODIES : ABOVE + STRIP),
    draw(canvas, width, density, time, theme): void {
      const context = cleared(canvas, density, width, isWide(width) ? BODIES : ABOVE + STRIP, theme.background);
      const share = isWide(width) ? Math.round(0.56 * width) : width;
      const height = isWide(width) ? BODIES : ABOVE;
      drawWays(context, { width: share, height }, radii, places, [from, time, to], theme);
      write(context, `t = ${timeInWords(collision, time)}, ${say(`phase.${phaseAt(collision, time)}`)}`, 4, 16, theme.text);
      write(context, words, share - 4, 16, theme.muted, 'right');
      if (strip?.dark !== theme.dark) strip = { dark: theme.dark, image: stripOf(collision, theme) };
      drawStrip(context, isWide(width) ? { x: share + 8, y: 0, width: width - share - 8, height: BODIES }
        : { x: 0, y: ABOVE, width, height: STRIP }, collision, strip.image, time, theme);
    },
  };
}

/** Draws bodies at a time, with the ways of their centres from the first to the last. */
function drawWays(
  context: CanvasRenderingContext2D, size: { width: number; height: number }, radii: number[],
  places: (time: number) => Place[], [from, time, to]: [number, number, number], theme: Theme,
): void {
  const instants = Array.from({ length: 121 }, (_, k) => places(from + ((to - from) * k) / 120));
  const shown = instants.flat().map((each, n) => ({ ...each, radius: radii[n % radii.length]! }))
    .filter(({ radius }) => radius <= LARGEST);
  const [left = -2, right = 0] = extent(shown.flatMap(({ x, radius }) => [x - radius, x + radius]));
  const [low = -1, high = 1] = extent(shown.flatMap(({ y, radius }) => [y - radius, y + radius]));
  const wall = radii.length === 1;
  const end = Math.max(right, wall ? GROUND : Math.min(radii[1]!, LARGEST));
  const scale = Math.min((size.width - 16) / (end - left), (size.height - HEAD - 16) / (high - low));
  const origin = {
    x: (size.width - scale * (end + left)) / 2, y: HEAD + (size.height - HEAD - 16 + scale * (high + low)) / 2,
  };
  const at = ({ x, y }: { x: number; y: number }): [number, number] => [origin.x + scale * x, origin.y - scale * y];
  context.save();
  context.beginPath();
  context.rect(0, HEAD - 4, size.width, size.height - HEAD - 12);
  context.clip();
  if (wall) {
    box(context, theme.panel, origin.x, 0, scale * GROUND, size.height);
    box(context, theme.text, origin.x - 0.8, 0, 1.6, size.height);
  }
  trace(context, [[0, origin.y], [size.width, origin.y]], theme.muted, 1, [2, 4]); // the normal
  places(time).forEach((place, n) => {
    drawBody(context, at(place), scale * radii[n]!, place.angle, theme);
    drawWay(context, instants.map((each) => at(each[n]!)), theme);
  });
  context.restore();
}

/** Draws a round body whose turning is seen. @param angle counterclockwise */
export function drawBody(
  context: CanvasRenderingContext2D, [x, y]: [number, number], radius: number, angle: number, theme: Theme,
): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = theme.panel;
  context.fill();
  context.globalAlpha = 0.3;
  context.fillStyle = theme.accent;
  for (const begin of [-angle, Math.PI - angle]) {
    context.beginPath();
    context.moveTo(x, y);
    context.arc(x, y, radius, begin, begin + Math.PI / 2);
    context.fill();
  }
  context.globalAlpha = 1;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.strokeStyle = theme.text;
  context.lineWidth = 1.6;
  context.stroke();
}

const BARB = 7; // pixels of an arrow

/** Draws the way of a centre, with an arrow where it goes; none of what hardly moves. */
export function drawWay(
  context: CanvasRenderingContext2D, way: [number, number][], theme: Theme, color = theme.accent,
): void {
  const [begin, [x, y]] = [way[0]!, way.at(-1)!];
  if (way.every(([a, b]) => Math.hypot(a - begin[0], b - begin[1]) < 2)) return;
  const [fromX, fromY] = way.at(-9) ?? begin;
  const course = Math.atan2(y - fromY, x - fromX);
  const [one, other] = [-0.45, 0.45].map((side): [number, number] =>
    [x - BARB * Math.cos(course + side), y - BARB * Math.sin(course + side)]) as [[number, number], [number, number]];
  trace(context, [...way, one, [x, y], other], color);
}
