// Modes in pictures: their energies as bars, and the shape of one, swinging.
import { max, min, range, sum } from 'd3-array';
import type { Collision, ModeEnergy, Shape } from '../core/protocol';
import { fitCanvas } from '../drawing/canvas';
import { Plot } from '../drawing/library';
import { type Drawn, type Scale, BESIDE, draw, drawLegend } from '../drawing/plot';
import { type Theme, look, motionIsReduced } from '../drawing/theme';
import { say } from '../drawing/words';
import { follow } from '../scene/bodies';
import { type Line, type Part, edgeOf, meshOf } from '../scene/parts';

const AMPLITUDE = 0.16; // maximum displacement, in radii
const PERIOD = 1.2; // s
const PERIODS = 4; // then it is still: what moves for long must be stoppable

/** How far a shape is out at a time, s: it ends where it is farthest. */
export function swing(seconds: number): number {
  return seconds >= PERIOD * PERIODS ? 1 : Math.cos((2 * Math.PI * seconds) / PERIOD);
}

/** Shows a shape that swings; returns what ends that. `theme` is asked at every picture. */
export function swingShape(
  canvas: HTMLCanvasElement, size: number, part: Part, shape: Shape, theme: () => Theme,
): () => void {
  let turn = 0;
  const begin = performance.now();
  const tick = (now: number): void => {
    const seconds = (now - begin) / 1000;
    const still = motionIsReduced();
    drawShape(canvas, size, part, shape, still ? 1 : swing(Math.max(0, seconds)), theme());
    if (!still && seconds < PERIOD * PERIODS) turn = requestAnimationFrame(tick);
  };
  turn = requestAnimationFrame(tick);
  return () => cancelAnimationFrame(turn);
}

function drawShape(canvas: HTMLCanvasElement, size: number, part: Part, shape: Shape, out: number, theme: Theme): void {
  const rod = part.curvature === 0;
  const density = fitCanvas(canvas, size, rod ? 0.45 * size : size);
  const context = canvas.getContext('2d')!;
  const none = new Float32Array(0);
  const mesh = meshOf(part, { center: part.center, ...shape, vonMises: none, fringes: none }, AMPLITUDE * out);
  const scale = (rod ? 0.7 : 0.41) * size;
  const place = { scale, x: size / 2 - scale * part.center, y: canvas.height / density / 2 };
  context.setTransform(density, 0, 0, density, 0, 0);
  context.clearRect(0, 0, size, size);
  context.lineJoin = 'round';
  const stroke = (edge: Line): void => {
    for (const sign of [1, -1] as const) {
      context.beginPath();
      follow(context, place, edge, sign);
      context.stroke();
    }
  };
  const line = (count: number, first: number, step: number): void =>
    stroke(edgeOf({ ...part, edge: Array.from({ length: count }, (_, k) => first + k * step) }, mesh));
  context.strokeStyle = theme.muted;
  context.lineWidth = 0.8;
  const { rows, columns } = part;
  const [across, along] = rod ? [24, -1] : [6, 12];
  for (let k = 1; k < across; ++k) line(columns, Math.round((k * (rows - 1)) / across) * columns, 1);
  for (let k = 0; k <= along; ++k) line(rows, Math.round((k * (columns - 1)) / along), columns);
  context.strokeStyle = theme.accent;
  context.lineWidth = 2;
  stroke(edgeOf(part, mesh));
}

export type When = 'after' | 'average';

export interface ModeBar {
  mode: ModeEnergy;
  energy: number;
  /** place and width along the axis, as shares of it */
  left: number;
  width: number;
}

interface ModeGroup {
  order: number;
  center: number;
}

export interface ModeLayout {
  bars: ModeBar[];
  groups: ModeGroup[];
  /** modes without a bar, and what they hold together */
  omitted: number;
  rest: number;
}

const GAP = 0.7; // between groups, in bars

/** The modes of a body with the most energy, at most `count`, in groups of their orders n. */
export function layoutModes(modes: ModeEnergy[], body: 0 | 1, when: When, count: number): ModeLayout {
  const all = modes.filter((each) => each.body === body && each[when] > 0).sort((a, b) => b[when] - a[when]);
  const shown = all.slice(0, count).sort((a, b) => a.order - b.order || a.index - b.index);
  const omitted = all.slice(count);
  const orders = [...new Set(shown.map((each) => each.order))];
  const width = 1 / Math.max(1, shown.length + GAP * orders.length);
  const bars = shown.map((mode, k): ModeBar =>
    ({ mode, energy: mode[when], left: width * (k + GAP * (orders.indexOf(mode.order) + 0.5)), width }));
  const groups = orders.map((order): ModeGroup => {
    const its = bars.filter(({ mode }) => mode.order === order);
    return { order, center: 0.5 * (its[0]!.left + its.at(-1)!.left + width) };
  });
  return { bars, groups, omitted: omitted.length, rest: sum(omitted, (each) => each[when]) };
}

/** The vibration after the impact that is in no mode of a body: of a half-space its waves. */
export function energyOfWaves({ vibration, modes }: Pick<Collision, 'vibration' | 'modes'>): number {
  return Math.max(0, vibration.at(-1)! - sum(modes, (each) => each.after));
}

const HEIGHT = 210;
const COLORED = 6; // overtones with a colour of their own
const DECADES = 5; // below the maximum bar, at most

/** The axis of energies. */
export function energyScale(layout: ModeLayout, log: boolean): Scale {
  const energies = layout.bars.map((each) => each.energy);
  const greatest = max(energies) ?? 0;
  if (!(greatest > 0)) return { low: log ? 1e-6 : 0, high: 1, log };
  if (!log) return { low: 0, high: 1.06 * greatest, log };
  return { low: Math.max(min(energies)!, greatest / 10 ** DECADES) / 2, high: 2 * greatest, log };
}

/** Draws the bars; and a legend of the overtones l. */
export function drawModes(layout: ModeLayout, log: boolean, when: When, width: number, theme: Theme): [Drawn, Drawn] {
  const y = energyScale(layout, log);
  const alone = layout.groups.length === 1;
  const label = alone ? say('modes.overtone', { order: layout.groups[0]!.order }) : say('modes.order');
  const color = (index: number): string => (index < COLORED ? look(index, theme).color : theme.muted);
  const names = spaced(alone
    ? layout.bars.map(({ mode, left, width: wide }) => ({ order: mode.index, center: left + 0.5 * wide }))
    : layout.groups, width - BESIDE);
  const chart = draw({
    width, height: HEIGHT,
    x: { low: 0, high: 1, log: false, label },
    y: { ...y, label: say('modes.share', { when: say(`modes.${when}`) }) },
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
  const there = new Set(layout.bars.map((each) => Math.min(each.mode.index, COLORED)));
  const entries = alone ? [] : range(COLORED + 1).filter((l) => there.has(l)).map((l) =>
    ({ label: l < COLORED ? `l = ${l}` : `l ≥ ${COLORED}`, color: color(l), marker: 'square' as const }));
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
