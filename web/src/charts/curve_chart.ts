// The chart of ε against the speed on the page: points fill in, the current one moves, a reader picks a speed.

import { least } from 'd3-array';
import { html, render } from 'lit-html';
import { keyed, onResize } from '../drawing/dom';
import { pictureOf } from '../drawing/files';
import { rounded, withError, written } from '../drawing/numbers';
import { type Drawn, stacked } from '../drawing/plot';
import { readTheme } from '../drawing/theme';
import { drawCurves, speedsOf, type Curve, type CurveContent } from './curve_picture';

type Current = NonNullable<CurveContent['current']>;

const STEPS = 100; // of the keyboard along the axis
const TITLE = 'ε against the speed';

/** Makes an empty chart in an element; `pick` gets a speed that a reader has picked. */
export function createCurveChart(host: HTMLElement, pick: (speed: number) => void) {
  const content: CurveContent = { curves: [], current: undefined, ordinate: 'restitution' };
  let chart: Drawn | undefined;
  let shown: SVGSVGElement | undefined;
  let pointed: number | undefined; // the speed that the pointer is at
  const drawSoon = onResize(host, draw);
  tell();

  function draw(): void {
    if (!host.clientWidth) return;
    const parts = drawCurves(content, host.clientWidth, readTheme(host));
    chart = parts[0];
    shown = stacked(parts, TITLE);
    tell();
  }

  /** Brings all but the picture up to date. */
  function tell(): void {
    const { low, high } = speedsOf(content);
    const choose = (event: Event): void => {
      content.ordinate = (event.target as HTMLInputElement).checked ? 'loss' : 'restitution';
      draw();
    };
    const point = (event?: MouseEvent): void => {
      pointed = event && speedAt(event);
      tell();
    };
    const now = content.current ? inWords(content.current) : '';
    render(html`
      <div class="chart curve-chart">
        <div class="chart-options">
          <label><input type="checkbox" @change=${choose} />Show the loss 1 − ε², logarithmic</label>
        </div>
        <div class="chart-area" tabindex="0" role="slider" aria-label="Speed, picked on the chart of ε"
          aria-valuemin=${low} aria-valuemax=${high} aria-valuenow=${content.current?.speed ?? low}
          aria-valuetext=${now || 'none'} @click=${(event: MouseEvent) => pick(speedAt(event))}
          @pointermove=${point} @pointerleave=${() => point()} @keydown=${onKey}>${shown}</div>
        <p class="chart-note">
          ${pointed === undefined ? [now, toCome()].filter(Boolean).join('; ') : nearTo(pointed)}
        </p>
      </div>`, host);
  }

  function inWords({ speed, restitution, error }: Current): string {
    const unit = content.curves[0]?.encounter.si ? 'm/s' : 'c';
    return `v = ${written(speed, 3)} ${unit}: ε = ${withError(restitution, error)}`;
  }

  function toCome(): string {
    const left = content.curves.reduce((sum, { planned, points }) => sum + planned.length - points.length, 0);
    return left > 0 ? `${left} ${left === 1 ? 'speed is' : 'speeds are'} still to come` : '';
  }

  /** The points nearest to a speed, by the logarithm. */
  function nearTo(speed: number): string {
    const { curves } = content;
    return curves.flatMap(({ label, points }) => {
      const point = least(points, (each) => Math.abs(Math.log(each.speed / speed)));
      return point ? [`${curves.length > 1 ? `${label}, ` : ''}${inWords(point)}`] : [];
    }).join('; ');
  }

  /** A speed with three digits, which is what a place on a chart is good for. */
  function speedAt({ clientX, currentTarget }: MouseEvent): number {
    const { low, high } = speedsOf(content);
    const place = clientX - (currentTarget as HTMLElement).getBoundingClientRect().left;
    return rounded(Math.min(high, Math.max(low, chart?.scale('x')?.invert?.(place) ?? low)), 3);
  }

  function onKey(event: KeyboardEvent): void {
    const { low, high } = speedsOf(content);
    const [first, last] = [Math.log(low), Math.log(high)];
    const at = content.current ? Math.log(content.current.speed) : 0.5 * (first + last);
    const to = keyed(event, { at, first, last, step: (last - first) / STEPS });
    if (to !== undefined) pick(rounded(Math.exp(to), 3));
  }

  return {
    setCurves(curves: Curve[]): void {
      content.curves = curves;
      drawSoon();
    },
    /** Shows the point that the inputs stand for. */
    setCurrent(current: Current): void {
      content.current = current;
      drawSoon();
    },
    picture: pictureOf(host, TITLE, (width, theme) => drawCurves(content, width, theme)),
  };
}
