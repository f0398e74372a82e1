// A chart of ε against the speed: its axes, and its description.
import type { Markish } from '@observablehq/plot';
import { extent } from 'd3-array';
import type { CurvePoint, Encounter } from '../core/protocol';
import { Plot } from '../drawing/library';
import { type Drawn, type Scale, draw, drawLegend } from '../drawing/plot';
import { type Look, type Theme, look } from '../drawing/theme';
import { say } from '../drawing/words';
import { meetingOf } from '../inputs/document';
import { description } from '../inputs/lines';
import { type Bar, type ModelPoint, type Ordinate, barOf, endsOfSpread, modelLook, modelMarks } from './model_picture';

const LEAST = 1e-7; // of 1 − ε² on a logarithmic axis

/** A logarithmic axis for all speeds, those computed and those planned. */
export function speedScale(speeds: number[]): Scale {
  const [low, high] = extent(speeds.filter((each) => each > 0 && Number.isFinite(each)));
  if (low === undefined || high === undefined) return { low: 1e-4, high: 0.3, log: true };
  const margin = high > low ? (high / low) ** 0.025 : 3;
  return { low: low / margin, high: high * margin, log: true };
}

/** An axis for all values with their errors: linear for ε, logarithmic for 1 − ε². */
export function ordinateScale(ordinate: Ordinate, all: { restitution: number; error: number }[]): Scale {
  const log = ordinate === 'loss';
  const [low, high] = extent(all.flatMap(({ restitution, error }) => {
    const bar = barOf(ordinate, restitution, error);
    if (!Number.isFinite(bar.value) || (log && !(bar.value > LEAST))) return [];
    const floor = log ? Math.max(LEAST, 0.2 * bar.value) : -Infinity; // an error bar down to 0 would have no end
    return [bar.value, Math.max(floor, bar.low ?? bar.value), bar.high ?? bar.value];
  }));
  if (low === undefined || high === undefined) return { low: log ? 1e-4 : 0, high: 1, log };
  if (log) {
    const margin = Math.max(1.15, (high / low) ** 0.06);
    return { low: low / margin, high: high * margin, log };
  }
  const pad = Math.max(0.06 * (high - low), 0.005);
  const top = high <= 1 ? Math.min(1.002, high + pad) : high + pad;
  return { low: Math.max(Math.min(low, 0), low - pad), high: top, log };
}

/** ε of an encounter against the speed, as far as it is known. */
export interface Curve {
  readonly encounter: Encounter;
  /** in the order in which they are computed */
  readonly points: readonly CurvePoint[];
  /** speeds that are or will be computed */
  readonly planned: readonly number[];
}

export interface CurveContent {
  curves: Curve[];
  /** that of the inputs */
  current: Pick<CurvePoint, 'speed' | 'restitution' | 'error'> | undefined;
  ordinate: Ordinate;
  /** of the current inputs with what a model adds; none of what is not predicted */
  model: readonly ModelPoint[];
}

/** The axis of speeds of a chart. */
export function speedsOf({ curves, current }: CurveContent): Scale {
  return speedScale([
    ...curves.flatMap((each) => [...each.planned, ...each.points.map((point) => point.speed)]),
    ...(current ? [current.speed] : []),
  ]);
}

/** The unit of its speeds. */
export function speedUnitOf({ curves: [first] }: CurveContent): string {
  return first && meetingOf(first.encounter).si ? 'm/s' : 'c';
}

/** Draws all curves and the current point; and a legend. */
export function drawCurves(content: CurveContent, width: number, theme: Theme): [Drawn, Drawn] {
  const { curves, current, ordinate, model } = content;
  const x = speedsOf(content);
  const y = ordinateScale(ordinate,
    [...curves.flatMap((each) => each.points), ...(current ? [current] : []), ...endsOfSpread(model)]);
  const unit = speedUnitOf(content);
  const height = Math.min(340, Math.max(220, 0.5 * width));
  const chart = draw({
    width, height,
    x: { ...x, label: say('curve.speed'), unit },
    y: { ...y, label: say(ordinate === 'restitution' ? 'curve.restitution' : 'curve.lost') },
    marks: [
      ...modelMarks(model, y, ordinate, theme),
      ...curves.flatMap(({ points, planned }, n) => {
        const its = look(n, theme);
        const there = new Set(points.map(({ speed }) => speed));
        const toCome = planned.filter((speed) => !there.has(speed));
        const places = points.map((each): Place =>
          ({ ...each, ...barOf(ordinate, each.restitution, each.error), at: each.speed }));
        return [
          Plot.ruleX(toCome, { stroke: its.color, strokeWidth: 1.5, opacity: 0.6, insetTop: height - 6 }),
          ...pointMarks(places, y, its, theme),
        ];
      }),
      ...(current ? currentMarks(current.speed, [barOf(ordinate, current.restitution, current.error)], y, theme) : []),
    ],
  }, theme);
  const entries = curves.map(({ encounter }, n) => ({ label: description(encounter), ...look(n, theme) }));
  const ofModel = model.length > 0 ? [modelLook(theme)] : [];
  return [chart, drawLegend([...entries, ...ofModel], width, theme)];
}

/** A point in a chart. */
export type Place = Bar & { at: number; converged: boolean };

/** Error bars, as far as the chart goes. */
function errorBars(places: Place[], y: Scale, color: string, width: number): Markish {
  const known = places.filter(({ low, high }) => low !== undefined && high !== undefined);
  return Plot.ruleX(known, {
    x: 'at', y1: ({ low }: Place) => Math.max(low!, y.low), y2: 'high', stroke: color, strokeWidth: width,
    marker: 'tick', clip: true,
  });
}

/** Points in any order with their error bars, and a line through them. */
export function pointMarks(points: Place[], y: Scale, { color, dash, marker }: Look, theme: Theme): Markish[] {
  const places = points.filter(({ value }) => !y.log || value > 0).sort((a, b) => a.at - b.at);
  const [r, x] = [places.length > 80 ? 2.2 : places.length > 40 ? 2.8 : 3.4, 'at'];
  return [
    Plot.line(places, { x, y: 'value', stroke: color, strokeWidth: 1.6, strokeDasharray: dash.join(' '), clip: true }),
    errorBars(places, y, color, 1.1),
    Plot.dot(places, {
      x, y: 'value', symbol: marker, r, stroke: color, strokeWidth: 1.2,
      fill: ({ converged }: Place) => (converged ? color : theme.background), clip: true,
    }),
  ];
}

/** What the inputs stand for: a guide, and points on it. */
export function currentMarks(at: number, bars: Bar[], y: Scale, theme: Theme): Markish[] {
  const places = bars.filter(({ value }) => Number.isFinite(value) && (!y.log || value >= y.low))
    .map((bar): Place => ({ ...bar, at, converged: true }));
  return [
    Plot.ruleX([at], { stroke: theme.text, strokeDasharray: '3 3', opacity: 0.6 }),
    errorBars(places, y, theme.text, 1.6),
    Plot.dot(places, {
      x: 'at', y: 'value', r: 6, fill: theme.background, fillOpacity: 0.6, stroke: theme.text, strokeWidth: 2,
    }),
  ];
}
