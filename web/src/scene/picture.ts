// One picture of a film: bodies, what it says about itself, and its legend.
import { scaleLinear } from 'd3-scale';
import { unitsOf } from '../core/local';
import type { Frame } from '../core/protocol';
import { box, cleared, write } from '../drawing/canvas';
import { prefixFor, withUnit, written } from '../drawing/numbers';
import type { Theme } from '../drawing/theme';
import { say } from '../drawing/words';
import { drawBodies } from './bodies';
import { phaseAt, timeInWords } from './film';
import { type Quantity, type Shade, cssOf, pixelOf, shadeOf } from './raster';
import type { Show } from './scene';
import { HEAD, layoutOf } from './view';

const LEGEND = 46; // height, CSS pixels
const ORDERS = 5; // of fringes in a legend

/** Height of a picture of some width, in CSS pixels. */
export function pictureHeight(show: Show, width: number): number {
  return Math.round(layoutOf(show.view, width, 1).height + LEGEND);
}

/** Draws a picture. */
export function drawPicture(
  canvas: HTMLCanvasElement, width: number, density: number, show: Show, frame: Frame, time: number,
  quantity: Quantity, theme: Theme,
): void {
  const layout = layoutOf(show.view, width, density);
  const rods = show.meeting.kind === 'rod';
  const shown = rods ? 'vonMises' : quantity; // bands tell little of a stress that is the same across a rod
  const shade = shadeOf(shown, show.units[shown], theme.dark);
  const context = cleared(canvas, density, width, layout.height + LEGEND, theme.background);
  context.save();
  context.beginPath();
  context.rect(0, HEAD - 4, width, layout.height - HEAD + 4);
  context.clip();
  const to = { context, layout, density, width, theme, shade };
  drawBodies(to, frame, show.parts, show.magnification, show.meeting.against);
  context.restore();
  write(context, `t = ${timeInWords(show.collision, time)}, ${say(`phase.${phaseAt(show.collision, time)}`)}`, 4, 16, theme.text);
  const { magnification } = show;
  const words = magnification === 1 ? say('film.true') : say('film.magnified', { magnification });
  write(context, words, width - 4, 16, theme.muted, 'right');
  drawLegend(context, 8, layout.height + 2, width - 16, theme, shade, unitsOf(show.encounter).modulus,
    say(rods ? 'film.rod_stress' : 'film.mises'));
}

/** Draws what the colours mean at the foot of a picture. `modulus`: that of the first body in Pa, where units are SI.
 *  `name`: of a stress that is not shown as fringes. */
function drawLegend(
  context: CanvasRenderingContext2D, left: number, top: number, width: number, theme: Theme, shade: Shade,
  modulus: number | undefined, name: string,
): void {
  const wide = Math.min(280, width);
  const start = left + (width - wide) / 2;
  const fringes = shade.quantity === 'fringes';
  const end = fringes ? ORDERS * shade.unit : shade.unit;
  for (let k = 0; k < wide; ++k) {
    box(context, cssOf(pixelOf(shade, (end * (k + 0.5)) / wide)), start + k, top, 1.5, 10);
  }
  context.strokeStyle = theme.muted;
  context.lineWidth = 1;
  context.strokeRect(start - 0.5, top - 0.5, wide + 1, 11);
  const { size, unit } = prefixFor(end * (modulus ?? 1), modulus === undefined ? 'E' : 'Pa');
  const last = fringes ? ORDERS : (end * (modulus ?? 1)) / size;
  const scale = scaleLinear([0, last], [start, start + wide]);
  const put = (text: string, x: number, y: number, color: string): void =>
    write(context, text, x, y, color, 'center', 11);
  for (const tick of scale.ticks(5)) put(written(tick), scale(tick), top + 23, theme.muted);
  const every = say('film.order', { stress: stressInWords(shade.unit, modulus) });
  put(fringes ? every : `${name} / ${unit}`, start + wide / 2, top + 39, theme.text);
}

/** A stress in words: in SI with a prefix, else in the modulus of the first body. */
export function stressInWords(stress: number, modulus: number | undefined): string {
  return modulus === undefined ? withUnit(stress, 'E') : withUnit(stress * modulus, 'Pa');
}
