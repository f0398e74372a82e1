// The chart of ε_t and ε against the angle: points fill in, a reader picks an angle.

import * as Plot from '@observablehq/plot';
import { least } from 'd3-array';
import { html, render } from 'lit-html';
import type { AnglePoint } from '../core/protocol';
import { keyed } from '../drawing/dom';
import { withError, written } from '../drawing/numbers';
import { chartIn } from '../drawing/pictures';
import { type Drawn, draw, drawLegend, stacked } from '../drawing/plot';
import { look, type Theme } from '../drawing/theme';

const TITLE = 'ε and εₜ against the angle';
const [FIRST, LAST] = [-89, 89];

/** What is drawn of a point, with its error. */
const CURVES: { label: string; of: (point: AnglePoint) => [value: number, error: number] }[] = [
  { label: 'εₜ along the surface', of: (point) => [point.tangential, point.tangentialError] },
  { label: 'ε along the normal', of: (point) => [point.restitution, point.error] },
];

function inWords(point: AnglePoint): string {
  return `${written(point.angle, 3)}°: εₜ = ${withError(point.tangential, point.tangentialError)}, ` +
    `ε = ${withError(point.restitution, point.error)}`;
}

function drawAngles(points: readonly AnglePoint[], current: AnglePoint | undefined, width: number, theme: Theme): Drawn[] {
  const marks = CURVES.flatMap(({ of }, n) => {
    const { color, dash, marker } = look(n, theme);
    const known = points.filter((point) => of(point).every(Number.isFinite));
    const x = ({ angle }: AnglePoint): number => angle;
    return [
      Plot.line(known, { x, y: (each: AnglePoint) => of(each)[0], stroke: color, strokeWidth: 1.6,
        strokeDasharray: dash.join(' '), clip: true }),
      Plot.ruleX(known, { x, y1: (each: AnglePoint) => of(each)[0] - of(each)[1],
        y2: (each: AnglePoint) => of(each)[0] + of(each)[1], stroke: color, strokeWidth: 1.1, marker: 'tick', clip: true }),
      Plot.dot(known, { x, y: (each: AnglePoint) => of(each)[0], symbol: marker, r: 2.8, stroke: color,
        fill: ({ converged }: AnglePoint) => (converged ? color : theme.background), clip: true }),
      ...(current ? [Plot.dot([current], { x, y: of(current)[0], r: 6, stroke: theme.text, strokeWidth: 2 })] : []),
    ];
  });
  const low = current && current.angle < 0 ? -90 : 0;
  const chart = draw({
    width, height: Math.min(340, Math.max(220, 0.5 * width)),
    x: { low, high: 90, log: false, label: 'angle from the normal, degrees' },
    y: { low: -1.05, high: 1.05, log: false, label: 'coefficients of restitution' },
    marks: [Plot.ruleX(current ? [current.angle] : [], { stroke: theme.text, strokeDasharray: '3 3', opacity: 0.6 }),
      Plot.ruleY([0], { stroke: theme.muted }), ...marks],
  }, theme);
  return [chart, drawLegend(CURVES.map(({ label }, n) => ({ label, ...look(n, theme) })), width, theme)];
}

/** Makes an empty chart in an element; `pick` gets an angle that a reader has picked. */
export function createAngleChart(host: HTMLElement, pick: (angle: number) => void) {
  let points: readonly AnglePoint[] = [];
  let current: AnglePoint | undefined;
  let pointed: number | undefined;
  let chart: Drawn | undefined;
  let shown: SVGSVGElement | undefined;
  const { updateSoon, picture } = chartIn(host, TITLE, (width, theme) => drawAngles(points, current, width, theme),
    (parts) => {
      chart = parts[0];
      shown = stacked(parts, TITLE);
      tell();
    });
  tell();

  /** Brings all but the picture up to date. */
  function tell(): void {
    const near = pointed === undefined ? current : least(points, ({ angle }) => Math.abs(angle - pointed!));
    const point = (event?: MouseEvent): void => {
      pointed = event && angleAt(event);
      tell();
    };
    render(html`
      <div class="chart curve-chart">
        <div class="chart-area" tabindex="0" role="slider" aria-label="Angle, picked on the chart of the restitution"
          aria-valuemin=${FIRST} aria-valuemax=${LAST} aria-valuenow=${current?.angle ?? 0}
          aria-valuetext=${current ? inWords(current) : 'none'} @click=${(event: MouseEvent) => pick(angleAt(event))}
          @pointermove=${point} @pointerleave=${() => point()} @keydown=${onKey}>${shown}</div>
        <p class="chart-note">${near && inWords(near)}</p>
      </div>`, host);
  }

  function angleAt({ clientX, currentTarget }: MouseEvent): number {
    const place = clientX - (currentTarget as HTMLElement).getBoundingClientRect().left;
    return Math.min(LAST, Math.max(FIRST, Math.round(chart?.scale('x')?.invert?.(place) ?? 0)));
  }

  function onKey(event: KeyboardEvent): void {
    const to = keyed(event, { at: Math.round(current?.angle ?? 0), first: FIRST, last: LAST, step: 1 });
    if (to !== undefined) pick(to);
  }

  return {
    /** Shows points in any order. */
    setPoints(next: readonly AnglePoint[]): void {
      points = [...next].sort((a, b) => a.angle - b.angle);
      updateSoon();
    },
    /** Shows the point that the inputs stand for. */
    setCurrent(next: AnglePoint): void {
      current = next;
      updateSoon();
    },
    picture,
  };
}
