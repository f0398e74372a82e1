// One picture of a film: bodies, what it says about itself, and its legend.

import { unitsOf } from '../core/local';
import type { Frame } from '../core/protocol';
import type { Theme } from '../drawing/theme';
import { drawBodies, type Scratch } from './bodies';
import { shadeOf, type Quantity } from './colors';
import { drawLegend, LEGEND } from './legend';
import { phaseAt, timeInWords } from './phases';
import type { Show } from './show';
import { HEAD, layoutOf } from './view';

/** Height of a picture of some width, in CSS pixels. */
export function pictureHeight(show: Show, width: number): number {
  return Math.round(layoutOf(show.view, width, 1).height + LEGEND);
}

/** Draws a picture. */
export function drawPicture(
  canvas: HTMLCanvasElement, width: number, density: number, show: Show, frame: Frame, time: number,
  quantity: Quantity, theme: Theme, scratch: Scratch,
): void {
  const context = canvas.getContext('2d')!;
  const layout = layoutOf(show.view, width, density);
  const rods = show.encounter.kind === 'rod';
  const shown = rods ? 'vonMises' : quantity; // bands tell little of a stress that is the same across a rod
  const shade = shadeOf(shown, show.units[shown], theme.dark);
  context.setTransform(density, 0, 0, density, 0, 0);
  context.fillStyle = theme.background;
  context.fillRect(0, 0, width, layout.height + LEGEND);
  context.save();
  context.beginPath();
  context.rect(0, HEAD - 4, width, layout.height - HEAD + 4);
  context.clip();
  const to = { context, layout, density, width, theme, shade };
  drawBodies(to, frame, show.parts, show.magnification, show.encounter.against, scratch);
  context.restore();
  context.fillStyle = theme.text;
  context.font = '13px system-ui, sans-serif';
  context.textAlign = 'left';
  context.fillText(`t = ${timeInWords(show.collision, time)}, ${phaseAt(show.collision, time)}`, 4, 16);
  context.textAlign = 'right';
  context.fillStyle = theme.muted;
  const { magnification } = show;
  context.fillText(magnification === 1 ? 'true displacements' : `displacements × ${magnification}`, width - 4, 16);
  drawLegend(context, 8, layout.height + 2, width - 16, theme, shade, unitsOf(show.encounter).modulus,
    rods ? 'stress |σ|' : 'von Mises stress');
}
