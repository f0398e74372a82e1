// Energies of the modes as bars, as SVG.

import { axes, legend, up, type Box } from '../drawing/axes';
import type { Scale } from '../drawing/scale';
import { element, svgDocument, text } from '../drawing/svg';
import { look, type Theme } from '../drawing/theme';
import type { ModeGroup, ModeLayout, When } from './mode_layout';

export const MODE_LABELS: Record<When, string> = {
  after: 'after the impact', average: 'mean during contact',
};

const LEFT = 62;
const RIGHT = 8;
const TOP = 30;
const HEIGHT = 210;
const FOOT = 46;
const COLORED = 6; // overtones with a colour of their own
const DECADES = 5; // below the maximum bar, at most

/** The area of the axes in a chart of some width. */
export function modeBox(width: number): Box {
  return { left: LEFT, top: TOP, width: width - LEFT - RIGHT, height: HEIGHT };
}

/** The axis of energies. */
export function energyScale(layout: ModeLayout, log: boolean): Scale {
  const energies = layout.bars.map((each) => each.energy);
  const greatest = energies.reduce((most, each) => Math.max(most, each), 0);
  if (!(greatest > 0)) return { low: log ? 1e-6 : 0, high: 1, log };
  if (!log) return { low: 0, high: 1.06 * greatest, log };
  const least = Math.max(energies.reduce((few, each) => Math.min(few, each), greatest), greatest / 10 ** DECADES);
  return { low: least / 2, high: 2 * greatest, log };
}

/** Draws the bars with axes and a legend of the overtones l. */
export function modeSvg(layout: ModeLayout, log: boolean, when: When, width: number, theme: Theme): string {
  const box = modeBox(width);
  const y = energyScale(layout, log);
  const alone = layout.groups.length === 1;
  const names = spaced(alone
    ? layout.bars.map(({ mode, left, width: wide }) => ({ order: mode.index, center: left + 0.5 * wide }))
    : layout.groups, box.width);
  const label = alone ? `overtone l of the order n = ${layout.groups[0]!.order}` : 'order n';
  const parts = [axes(
    box, { scale: { low: 0, high: 1, log: false }, label, ticks: [] },
    { scale: y, label: `share of the energy, ${MODE_LABELS[when]}` }, theme,
  )];
  const ground = box.top + box.height;
  for (const { center, order } of names) {
    const at = box.left + center * box.width;
    parts.push(text(at, ground + 17, String(order), { 'text-anchor': 'middle', fill: theme.muted }));
  }
  for (const { mode, energy, left, width: wide } of layout.bars) {
    const top = Math.min(ground, Math.max(box.top, up(box, y, energy)));
    parts.push(element('rect', {
      x: box.left + (left + 0.08 * wide) * box.width, y: top, width: 0.84 * wide * box.width, height: ground - top,
      fill: alone ? look(0, theme).color : colorOf(mode.index, theme),
    }));
  }
  const overtones = [...new Set(layout.bars.map((each) => Math.min(each.mode.index, COLORED)))].sort((a, b) => a - b);
  const entries = alone ? [] : overtones.map((l) => ({
    label: l < COLORED ? `l = ${l}` : `l ≥ ${COLORED}`,
    look: { color: colorOf(l, theme), dash: [], marker: 'square' as const }, line: false, marker: true,
  }));
  const [key, height] = legend(entries, LEFT - 8, ground + FOOT + 10, box.width, theme);
  parts.push(key);
  return svgDocument(width, ground + FOOT + height, 'Energy of the modes', theme.background, parts.join(''));
}

function colorOf(index: number, theme: Theme): string {
  return index < COLORED ? look(index, theme).color : theme.muted;
}

/** Of the groups every one, every second, fifth, …: as many as can be written without touching each other. */
function spaced(groups: ModeGroup[], width: number): ModeGroup[] {
  const half = ({ order }: ModeGroup): number => 3.4 * String(order).length + 1.5;
  for (const every of [1, 2, 5, 10, 20, 50, 100]) {
    const some = groups.filter(({ order }) => order % every === 0);
    const apart = some.every((each, k) => k === 0 ||
      (each.center - some[k - 1]!.center) * width >= half(each) + half(some[k - 1]!));
    if (apart) return some;
  }
  return groups.slice(0, 1);
}
