// The axes of a chart as SVG: frame, grid, ticks, numbers, labels; markers, error bars, a legend.

import { placeOf, type Scale } from './scale';
import { element, line, text } from './svg';
import type { Look, Marker, Theme } from './theme';
import { linearTicks, logTicks, type Tick } from './ticks';

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

export interface Axis {
  scale: Scale;
  label: string;
  /** where they are not those of the scale */
  ticks?: Tick[];
}

const PITCH = 64; // pixels for the number of a tick along x
const RISE = 30; // and along y

/** Where x is in a box, in pixels. */
export function across(box: Box, scale: Scale, value: number): number {
  return box.left + box.width * placeOf(scale, value);
}

/** Where y is in a box, in pixels. */
export function up(box: Box, scale: Scale, value: number): number {
  return box.top + box.height * (1 - placeOf(scale, value));
}

/** The ticks of an axis of some length in pixels. */
export function ticksOf(axis: Axis, length: number, pitch: number): Tick[] {
  if (axis.ticks) return axis.ticks;
  const { low, high, log } = axis.scale;
  const count = Math.max(2, Math.floor(length / pitch));
  if (!log) return linearTicks(low, high, count);
  const ticks = logTicks(low, high, count);
  return ticks.filter((each) => each.label).length >= 2 ? ticks : linearTicks(low, high, count);
}

/** Grid, frame, numbers and labels of a chart. `bottom`: whether x has numbers and its label. */
export function axes(box: Box, x: Axis, y: Axis, theme: Theme, bottom = true): string {
  const parts: string[] = [];
  const ground = box.top + box.height;
  for (const tick of ticksOf(x, box.width, PITCH)) {
    const at = across(box, x.scale, tick.value);
    const named = tick.label !== '';
    if (named) parts.push(line(at, box.top, at, ground, { stroke: theme.line, 'stroke-width': 0.7 }));
    parts.push(line(at, ground, at, ground + (named ? 5 : 3), { stroke: theme.muted, 'stroke-width': 0.8 }));
    if (named && bottom) parts.push(text(at, ground + 17, tick.label, { 'text-anchor': 'middle', fill: theme.muted }));
  }
  for (const tick of ticksOf(y, box.height, RISE)) {
    const at = up(box, y.scale, tick.value);
    const named = tick.label !== '';
    if (named) parts.push(line(box.left, at, box.left + box.width, at, { stroke: theme.line, 'stroke-width': 0.7 }));
    parts.push(line(box.left - (named ? 5 : 3), at, box.left, at, { stroke: theme.muted, 'stroke-width': 0.8 }));
    if (named) parts.push(text(box.left - 8, at + 4, tick.label, { 'text-anchor': 'end', fill: theme.muted }));
  }
  parts.push(element('path', {
    d: `M${box.left} ${box.top}V${ground}H${box.left + box.width}`, fill: 'none', stroke: theme.muted,
  }));
  if (bottom) {
    const at = { 'text-anchor': 'middle', fill: theme.text };
    parts.push(text(box.left + box.width / 2, ground + 35, x.label, at));
  }
  parts.push(text(box.left, box.top - 9, y.label, { fill: theme.text, 'text-anchor': 'start' }));
  return parts.join('');
}

/** The outline of a marker of some half size around a point. */
export function markerPath(marker: Marker, x: number, y: number, s: number): string {
  switch (marker) {
    case 'circle': return `M${x - s} ${y}a${s} ${s} 0 1 0 ${2 * s} 0a${s} ${s} 0 1 0 ${-2 * s} 0Z`;
    case 'square': return `M${x - s} ${y - s}h${2 * s}v${2 * s}h${-2 * s}Z`;
    case 'triangle': return `M${x} ${y - 1.2 * s}l${1.15 * s} ${2 * s}h${-2.3 * s}Z`;
    case 'down': return `M${x} ${y + 1.2 * s}l${1.15 * s} ${-2 * s}h${-2.3 * s}Z`;
    case 'diamond': {
      const d = 1.35 * s;
      return `M${x} ${y - d}l${d} ${d}l${-d} ${d}l${-d} ${-d}Z`;
    }
    case 'cross': return `M${x - s} ${y - s}l${2 * s} ${2 * s}M${x - s} ${y + s}l${2 * s} ${-2 * s}`;
  }
}

export interface LegendEntry {
  label: string;
  look: Look;
  /** a line, a marker, or both */
  line: boolean;
  marker: boolean;
}

const KEY = 34; // pixels of a line or marker before its label
const LETTER = 6.7;
const ROW = 18;

/** Words in rows of at most so many letters, as far as single words allow. */
function wrapped(words: string, letters: number): string[] {
  const rows: string[] = [];
  for (const word of words.split(' ')) {
    const last = rows.at(-1);
    if (last !== undefined && last.length + 1 + word.length <= letters) rows[rows.length - 1] = `${last} ${word}`;
    else rows.push(word);
  }
  return rows;
}

/** A legend in rows that are not wider than `width`, from a corner; its height is what the second value says. */
export function legend(entries: LegendEntry[], left: number, top: number, width: number, theme: Theme):
    [string, number] {
  const parts: string[] = [];
  const letters = Math.floor((width - KEY) / LETTER);
  let x = left;
  let y = top;
  for (const { label, look, line: lined, marker } of entries) {
    const rows = wrapped(label, letters);
    const wide = KEY + LETTER * Math.max(...rows.map((row) => row.length)) + 12;
    if (x > left && x + wide > left + width) {
      x = left;
      y += ROW;
    }
    if (lined) parts.push(line(x, y, x + 26, y, {
      stroke: look.color, 'stroke-width': 2, 'stroke-dasharray': look.dash.join(' ') || undefined,
    }));
    if (marker) parts.push(element('path', {
      d: markerPath(look.marker, x + 13, y, 4), fill: look.color, stroke: look.color,
    }));
    rows.forEach((row, n) => parts.push(text(x + KEY - 2, y + 4 + n * ROW, row, { fill: theme.text })));
    x += wide;
    if (rows.length > 1) {
      x = left + width;
      y += ROW * (rows.length - 1);
    }
  }
  return [parts.join(''), entries.length ? y - top + 24 : 0];
}
