// Energies of the modes as bars: their description.

import * as Plot from '@observablehq/plot';
import { BESIDE, type Drawn, draw, drawLegend } from '../drawing/plot';
import { look, type Theme } from '../drawing/theme';
import type { Scale } from './curve_scales';
import type { ModeBar, ModeGroup, ModeLayout, When } from './mode_layout';

export const MODE_LABELS: Record<When, string> = {
  after: 'after the impact', average: 'mean during contact',
};

const HEIGHT = 210;
const COLORED = 6; // overtones with a colour of their own
const DECADES = 5; // below the maximum bar, at most

/** The axis of energies. */
export function energyScale(layout: ModeLayout, log: boolean): Scale {
  const energies = layout.bars.map((each) => each.energy);
  const greatest = energies.reduce((most, each) => Math.max(most, each), 0);
  if (!(greatest > 0)) return { low: log ? 1e-6 : 0, high: 1, log };
  if (!log) return { low: 0, high: 1.06 * greatest, log };
  const least = Math.max(energies.reduce((few, each) => Math.min(few, each), greatest), greatest / 10 ** DECADES);
  return { low: least / 2, high: 2 * greatest, log };
}

/** Draws the bars; and a legend of the overtones l. */
export function drawModes(layout: ModeLayout, log: boolean, when: When, width: number, theme: Theme): [Drawn, Drawn] {
  const y = energyScale(layout, log);
  const alone = layout.groups.length === 1;
  const label = alone ? `overtone l of the order n = ${layout.groups[0]!.order}` : 'order n';
  const color = (index: number): string => (index < COLORED ? look(index, theme).color : theme.muted);
  const names = spaced(alone
    ? layout.bars.map(({ mode, left, width: wide }) => ({ order: mode.index, center: left + 0.5 * wide }))
    : layout.groups, width - BESIDE);
  const chart = draw({
    width, height: HEIGHT,
    x: { low: 0, high: 1, log: false, label },
    y: { ...y, label: `share of the energy, ${MODE_LABELS[when]}` },
    ticks: {
      places: names.map(({ center }) => center),
      words: (place) => String(names.find(({ center }) => center === place)?.order ?? ''),
    },
    marks: [Plot.rect(layout.bars, {
      x1: ({ left, width: wide }: ModeBar) => left + 0.08 * wide,
      x2: ({ left, width: wide }: ModeBar) => left + 0.92 * wide,
      y1: y.low, y2: ({ energy }: ModeBar) => Math.max(y.low, energy),
      fill: ({ mode }: ModeBar) => color(alone ? 0 : mode.index),
    })],
  }, theme);
  const overtones = [...new Set(layout.bars.map((each) => Math.min(each.mode.index, COLORED)))].sort((a, b) => a - b);
  const entries = alone ? [] : overtones.map((l) => ({
    label: l < COLORED ? `l = ${l}` : `l ≥ ${COLORED}`,
    look: { color: color(l), dash: [], marker: 'square' as const }, line: false, marker: true,
  }));
  return [chart, drawLegend(entries, width, theme)];
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
