// A chart of ε against the speed as SVG.

import type { CurvePoint, Encounter } from '../core/protocol';
import { across, axes, legend, markerPath, up, type Box } from '../drawing/axes';
import { placeOf, type Scale } from '../drawing/scale';
import { element, line, pathThrough, svgDocument } from '../drawing/svg';
import { look, type Look, type Theme } from '../drawing/theme';
import { barOf, ordinateScale, speedScale, type Current, type Ordinate } from './curve_scales';

export interface Curve {
  label: string;
  encounter: Encounter;
  points: CurvePoint[];
  /** speeds that are or will be computed */
  planned: number[];
}

export interface CurveChartContent {
  curves: Curve[];
  current: Current | undefined;
  ordinate: Ordinate;
}

const LEFT = 62;
const RIGHT = 14;
const TOP = 30;
const FOOT = 46;

/** The area of the axes in a chart of some width; its height for as many rows of legend as there are. */
export function curveBox(width: number): Box {
  return { left: LEFT, top: TOP, width: width - LEFT - RIGHT, height: Math.min(340, Math.max(220, 0.5 * width)) };
}

/** The axis of speeds of a chart. */
export function curveSpeeds({ curves, current }: CurveChartContent): Scale {
  return speedScale([
    ...curves.flatMap((each) => [...each.planned, ...each.points.map((point) => point.speed)]),
    ...(current ? [current.speed] : []),
  ]);
}

/** Draws all curves, the current point, and a legend. */
export function curveSvg(content: CurveChartContent, width: number, theme: Theme): string {
  const { curves, current, ordinate } = content;
  const box = curveBox(width);
  const x = curveSpeeds(content);
  const y = ordinateScale(ordinate, [...curves.flatMap((each) => each.points), ...(current ? [current] : [])]);
  const unit = curves[0]?.encounter.si ? 'm/s' : 'c';
  const parts = [axes(
    box, { scale: x, label: `speed of the impact v (${unit})` },
    { scale: y, label: ordinate === 'restitution' ? 'coefficient of restitution ε' : 'lost share of energy 1 − ε²' },
    theme,
  )];
  const inside: string[] = [];
  curves.forEach((curve, n) => inside.push(curveParts(curve, look(n, theme), box, x, y, ordinate, theme)));
  if (current) inside.push(currentParts(current, box, x, y, ordinate, theme));
  parts.push(element('clipPath', { id: 'curve-area' }, element('rect', {
    x: box.left - 6, y: box.top - 6, width: box.width + 12, height: box.height + 6,
  })));
  parts.push(element('g', { 'clip-path': 'url(#curve-area)' }, inside.join('')));
  const entries = curves.map(({ label }, n) => ({ label, look: look(n, theme), line: true, marker: true }));
  const [key, height] = legend(entries, LEFT, box.top + box.height + FOOT + 12, box.width, theme);
  parts.push(key);
  const high = box.top + box.height + FOOT + height;
  return svgDocument(width, high, 'ε against the speed', theme.background, parts.join(''));
}

function curveParts(
  curve: Curve, { color, dash, marker }: Look, box: Box, x: Scale, y: Scale, ordinate: Ordinate, theme: Theme,
): string {
  const points = curve.points.filter((each) => ordinate === 'restitution' || each.restitution ** 2 < 1)
    .sort((a, b) => a.speed - b.speed);
  const ground = box.top + box.height;
  const parts: string[] = [];
  const there = new Set(curve.points.map((each) => each.speed));
  for (const speed of curve.planned) {
    if (there.has(speed)) continue;
    const at = across(box, x, speed);
    parts.push(line(at, ground, at, ground - 6, { stroke: color, 'stroke-width': 1.5, opacity: 0.6 }));
  }
  const places = points.map((each) => across(box, x, each.speed));
  const heights = points.map((each) => up(box, y, barOf(ordinate, each.restitution, each.error).value));
  parts.push(element('path', {
    d: pathThrough(places, heights), fill: 'none', stroke: color, 'stroke-width': 1.6,
    'stroke-dasharray': dash.join(' ') || undefined,
  }));
  const size = points.length > 80 ? 2.2 : points.length > 40 ? 2.8 : 3.4;
  points.forEach((point, k) => {
    parts.push(errorBar(places[k]!, barOf(ordinate, point.restitution, point.error), box, y, color, 2.5, 1.1));
    parts.push(element('path', {
      d: markerPath(marker, places[k]!, heights[k]!, size), stroke: color, 'stroke-width': 1.2,
      fill: point.converged ? color : theme.background,
    }));
  });
  return parts.join('');
}

function errorBar(at: number, bar: { low?: number; high?: number }, box: Box, y: Scale, color: string, half: number,
  width: number): string {
  if (bar.low === undefined || bar.high === undefined) return '';
  const bottom = y.log && bar.low <= y.low ? box.top + box.height : Math.min(box.top + box.height, up(box, y, bar.low));
  const top = up(box, y, bar.high);
  if (bottom - top < 2) return '';
  const style = { stroke: color, 'stroke-width': width };
  return line(at, bottom, at, top, style) + line(at - half, top, at + half, top, style) +
    line(at - half, bottom, at + half, bottom, style);
}

function currentParts(current: Current, box: Box, x: Scale, y: Scale, ordinate: Ordinate, theme: Theme): string {
  const at = across(box, x, current.speed);
  const guide = line(at, box.top, at, box.top + box.height, {
    stroke: theme.text, 'stroke-width': 1, 'stroke-dasharray': '3 3', opacity: 0.6,
  });
  const bar = barOf(ordinate, current.restitution, current.error);
  if (!Number.isFinite(current.restitution) || (y.log && !(placeOf(y, bar.value) >= 0))) return guide;
  return guide + errorBar(at, bar, box, y, theme.text, 6, 1.6) + element('circle', {
    cx: at, cy: up(box, y, bar.value), r: 6, fill: theme.background, 'fill-opacity': 0.6, stroke: theme.text,
    'stroke-width': 2,
  });
}
