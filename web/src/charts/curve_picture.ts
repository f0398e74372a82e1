// A chart of ε against the speed: its description.
import * as Plot from '@observablehq/plot';
import type { CurvePoint, Encounter } from '../core/protocol';
import { type Drawn, draw, drawLegend } from '../drawing/plot';
import { look, type Look, type Theme } from '../drawing/theme';
import { barOf, ordinateScale, speedScale, type Bar, type Current, type Ordinate, type Scale } from './curve_scales';

export interface Curve {
  label: string;
  encounter: Encounter;
  points: CurvePoint[];
  /** speeds that are or will be computed */
  planned: number[];
}

export interface CurveContent {
  curves: Curve[];
  current: Current | undefined;
  ordinate: Ordinate;
}

/** The axis of speeds of a chart. */
export function speedsOf({ curves, current }: CurveContent): Scale {
  return speedScale([
    ...curves.flatMap((each) => [...each.planned, ...each.points.map((point) => point.speed)]),
    ...(current ? [current.speed] : []),
  ]);
}

/** Draws all curves and the current point; and a legend. */
export function drawCurves(content: CurveContent, width: number, theme: Theme): [Drawn, Drawn] {
  const { curves, current, ordinate } = content;
  const x = speedsOf(content);
  const y = ordinateScale(ordinate, [...curves.flatMap((each) => each.points), ...(current ? [current] : [])]);
  const unit = curves[0]?.encounter.si ? 'm/s' : 'c';
  const height = Math.min(340, Math.max(220, 0.5 * width));
  const chart = draw({
    width, height,
    x: { ...x, label: `speed of the impact v (${unit})` },
    y: { ...y, label: ordinate === 'restitution' ? 'coefficient of restitution ε' : 'lost share of energy 1 − ε²' },
    marks: [
      ...curves.flatMap((curve, n) => marksOf(curve, look(n, theme), y, ordinate, theme, height)),
      ...(current ? currentMarks(current, y, ordinate, theme) : []),
    ],
  }, theme);
  const entries = curves.map(({ label }, n) => ({ label, look: look(n, theme), line: true, marker: true }));
  return [chart, drawLegend(entries, width, theme)];
}

type Place = Bar & { speed: number; converged: boolean };

/** Error bars with ends of some half width, as far as the chart goes. */
function errorBars(places: Place[], y: Scale, color: string, half: number, width: number): Plot.Markish {
  const known = places.filter(({ low, high }) => low !== undefined && high !== undefined);
  const end: Plot.MarkerFunction = (stroke, { document }) => {
    const marker = document.createElementNS('http://www.w3.org/2000/svg', 'marker');
    marker.innerHTML = `<path d="M0 ${-half}V${half}" stroke="${stroke}" stroke-width="${width}"/>`;
    for (const [key, value] of Object.entries({
      viewBox: `${-half} ${-half} ${2 * half} ${2 * half}`, markerWidth: 2 * half, markerHeight: 2 * half,
      markerUnits: 'userSpaceOnUse', orient: 'auto',
    })) marker.setAttribute(key, String(value));
    return marker;
  };
  return Plot.ruleX(known, {
    x: 'speed', y1: ({ low }: Place) => Math.max(low!, y.low), y2: 'high', stroke: color, strokeWidth: width,
    marker: end, clip: true,
  });
}

function marksOf(curve: Curve, { color, dash, marker }: Look, y: Scale, ordinate: Ordinate, theme: Theme,
  ground: number): Plot.Markish[] {
  const places: Place[] = curve.points
    .map((each) => ({ ...each, ...barOf(ordinate, each.restitution, each.error) }))
    .filter(({ value }) => !y.log || value > 0)
    .sort((a, b) => a.speed - b.speed);
  const there = new Set(curve.points.map(({ speed }) => speed));
  const toCome = curve.planned.filter((speed) => !there.has(speed));
  const r = places.length > 80 ? 2.2 : places.length > 40 ? 2.8 : 3.4;
  return [
    Plot.ruleX(toCome, { stroke: color, strokeWidth: 1.5, opacity: 0.6, insetTop: ground - 6 }),
    Plot.line(places, {
      x: 'speed', y: 'value', stroke: color, strokeWidth: 1.6, strokeDasharray: dash.join(' '), clip: true,
    }),
    errorBars(places, y, color, 2.5, 1.1),
    Plot.dot(places, {
      x: 'speed', y: 'value', symbol: marker, r, stroke: color, strokeWidth: 1.2,
      fill: ({ converged }: Place) => (converged ? color : theme.background), clip: true,
    }),
  ];
}

function currentMarks(current: Current, y: Scale, ordinate: Ordinate, theme: Theme): Plot.Markish[] {
  const bar = barOf(ordinate, current.restitution, current.error);
  const place: Place = { ...bar, speed: current.speed, converged: true };
  const guide = Plot.ruleX([current.speed], { stroke: theme.text, strokeDasharray: '3 3', opacity: 0.6 });
  if (!Number.isFinite(bar.value) || (y.log && !(bar.value >= y.low))) return [guide];
  return [
    guide,
    errorBars([place], y, theme.text, 6, 1.6),
    Plot.dot([place], {
      x: 'speed', y: 'value', r: 6, fill: theme.background, fillOpacity: 0.6, stroke: theme.text, strokeWidth: 2,
    }),
  ];
}
