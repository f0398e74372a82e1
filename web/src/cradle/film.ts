// The film of the cradle, seen from the side, and that of two balls that fall on a floor.
import { max } from 'd3-array';
import { box, cleared, trace, write } from '../drawing/canvas';
import { withUnit, written } from '../drawing/numbers';
import type { Theme } from '../drawing/theme';
import { say } from '../drawing/words';
import { slowness } from '../scene/film';
import type { Film } from '../scene/player';
import { type Fall, type Swings, collisionsAt, fallSpan, heightsAt, outAt, spanOf } from './swing';

const HEIGHT = 290;
const TOP = 26; // of the bar from which the balls hang
const WIDEST = (34 * Math.PI) / 180; // of the fastest ball, in the picture
const LARGEST = 22; // radius of a ball, pixels
const GROUND = 22;

type Place = [x: number, y: number];

function drawBall(context: CanvasRenderingContext2D, [x, y]: Place, radius: number, name: string, theme: Theme, struck: boolean): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = struck ? theme.accent : theme.panel;
  context.fill();
  context.strokeStyle = theme.text;
  context.lineWidth = 1.6;
  context.stroke();
  if (radius > 8) write(context, name, x, y + 4.5, struck ? theme.background : theme.text, 'center', 12);
}

const SAID = ['cradle.said_before', 'cradle.said_after', 'cradle.said_again'] as const;

/** Velocities in words, over the speed at the bottom. */
export function inWords(velocities: readonly number[]): string {
  return velocities.map((each) => written(each, 3)).join(', ');
}

/** The film of swings; `lift` balls come first. @param apart whether there are gaps */
export function cradleFilm(swings: Swings, lift: number, apart: boolean): Film {
  const { from, to } = spanOf(swings);
  const count = swings.velocities[0]!.length;
  const fastest = max(swings.velocities.flat(), Math.abs)!;
  const said = (time: number): string => withUnit(time, 's', 2, 0.5);
  return {
    from, to, still: swings.half / 2, said,
    describe: (time) => say(SAID[collisionsAt(swings, time)]!,
      { time: said(time), velocities: inWords(swings.velocities[collisionsAt(swings, time)]!) }),
    note: (seconds) => say('cradle.note', { slowed: slowness(to - from, 's', seconds) }),
    height: () => HEIGHT,
    draw(canvas, width, density, time, theme) {
      const context = cleared(canvas, density, width, HEIGHT, theme.background);
      const length = Math.min(HEIGHT - TOP - LARGEST - 14, 0.42 * width);
      const between = apart ? 3 : 0;
      const reach = length * Math.sin(WIDEST);
      const radius = Math.min(LARGEST, (width - 2 * reach - 16 - count * between) / (2 * count));
      const pitch = 2 * radius + between;
      const pivots = swings.velocities[0]!.map((_, k) => width / 2 + (k - (count - 1) / 2) * pitch);
      const half = (count * pitch) / 2 + 14;
      outAt(swings, time).forEach((out, k) => {
        const angle = (WIDEST * out) / fastest;
        const place: Place = [pivots[k]! + length * Math.sin(angle), TOP + length * Math.cos(angle)];
        trace(context, [[pivots[k]!, TOP], place], theme.muted, 1.2);
        drawBall(context, place, radius, String(k + 1), theme, k < lift);
      });
      box(context, theme.text, width / 2 - half, TOP - 4, 2 * half, 4);
    },
  };
}

/** The film of a small ball on a large one, which fall on a floor. @param radii of the upper and the lower one */
export function dropFilm(fall: Fall, radii: readonly [number, number]): Film {
  const { from, to } = fallSpan(fall);
  const said = (time: number): string => withUnit(time, 's', 2, 0.5);
  const most = Math.max(...[from, 0, to].concat(Array.from({ length: 40 }, (_, k) => from + ((to - from) * k) / 39))
    .flatMap((time) => heightsAt(fall, time)));
  return {
    from, to, still: to, said,
    describe: (time) => say(time < 0 ? 'cradle.said_fall' : 'cradle.said_rise',
      { time: said(time), velocities: inWords(fall.after.map((each) => each / fall.speed)) }),
    note: (seconds) => say('cradle.note_drop', { slowed: slowness(to - from, 's', seconds), height: withUnit(most, 'm', 2) }),
    height: () => HEIGHT,
    draw(canvas, width, density, time, theme) {
      const context = cleared(canvas, density, width, HEIGHT, theme.background);
      const floor = HEIGHT - GROUND;
      box(context, theme.panel, 0, floor, width, GROUND);
      box(context, theme.text, 0, floor, width, 1.6);
      const [larger, share] = [Math.max(...radii), LARGEST];
      const [upper, lower] = radii.map((radius) => Math.max(5, (share * radius) / larger)) as [number, number];
      const scale = (floor - 2 * upper - 2 * lower - 8) / most;
      const [above, below] = heightsAt(fall, time) as [number, number];
      const ground = Math.max(0, below);
      drawBall(context, [width / 2, floor - lower - scale * ground], lower, '2', theme, false);
      drawBall(context, [width / 2, floor - 2 * lower - upper - scale * Math.max(ground, above)], upper, '1', theme, true);
    },
  };
}
