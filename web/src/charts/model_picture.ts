// What is drawn of a coefficient of restitution, and the curve of a model in a chart of it against the speed: its spread,
// and a line that is dashed as no other.
import type { Markish } from '@observablehq/plot';
import type { Prediction } from '../core/protocol';
import { Plot } from '../drawing/library';
import { bandInWords, withError, written } from '../drawing/numbers';
import type { Scale } from '../drawing/plot';
import type { Theme } from '../drawing/theme';
import { say } from '../drawing/words';

/** What is drawn of a speed: ε, or the lost share of the energy 1 − ε². */
export type Ordinate = 'restitution' | 'loss';

/** A value with the ends of its error bar; they are missing where the error is unknown. */
export interface Bar {
  value: number;
  low?: number;
  high?: number;
}

/** What a point is on the vertical axis: of 1 − ε² the error is 2 ε times that of ε. */
export function barOf(ordinate: Ordinate, restitution: number, error: number): Bar {
  const ratio = ordinate === 'restitution';
  const value = ratio ? restitution : 1 - restitution * restitution;
  const reach = ratio ? error : 2 * Math.abs(restitution) * error;
  return { value, ...(Number.isFinite(error) && { low: value - reach, high: value + reach }) };
}

/** What is drawn of a prediction. */
export interface ModelPoint {
  speed: number;
  restitution: number;
  error: number;
  /** of the models */
  low: number;
  high: number;
}

/** Of predictions, those that have a number, from slow to fast. */
export function modelPoints(predictions: readonly Prediction[]): ModelPoint[] {
  return predictions.map(({ speed, quantities }): ModelPoint => {
    const [restitution = NaN, low = NaN, high = NaN] =
      (['restitution', 'models_low', 'models_high'] as const).map((name) => quantities[name]?.value);
    return { speed, restitution, error: quantities.restitution?.error ?? 0, low, high };
  }).filter(({ restitution }) => Number.isFinite(restitution)).sort((a, b) => a.speed - b.speed);
}

/** Its line, and that of the legend. */
export function modelLook(theme: Theme): { label: string; color: string; dash: number[] } {
  return { label: say('model.legend'), color: theme.text, dash: [9, 4] };
}

/** The ends of the spread, as values that the vertical axis must hold. */
export function endsOfSpread(points: readonly ModelPoint[]): { restitution: number; error: number }[] {
  return points.flatMap(({ low, high }) => [low, high].map((restitution) => ({ restitution, error: 0 })));
}

/** The spread and the line. */
export function modelMarks(
  points: readonly ModelPoint[], y: Scale, ordinate: Ordinate, theme: Theme,
): Markish[] {
  const { color, dash } = modelLook(theme);
  const place = (restitution: number): number => Math.max(y.low, barOf(ordinate, restitution, 0).value);
  const x = 'speed';
  return [
    Plot.areaY(points, {
      x, y1: ({ low }: ModelPoint) => place(low), y2: ({ high }: ModelPoint) => place(high),
      fill: color, fillOpacity: 0.13, clip: true,
    }),
    Plot.line(points, {
      x, y: (each: ModelPoint) => place(each.restitution), stroke: color, strokeWidth: 1.8,
      strokeDasharray: dash.join(' '), clip: true,
    }),
  ];
}

export function modelInWords({ speed, restitution, error, low, high }: ModelPoint): string {
  const at = written(speed, 3);
  if (!(high > low)) return say('model.point', { speed: at, epsilon: withError(restitution, error) });
  const { value, band } = bandInWords(restitution, low, high);
  return say('model.spread', { speed: at, epsilon: value, band });
}
