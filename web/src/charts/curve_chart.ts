// The chart of ε against the speed on the page: points fill in, the current one moves, a reader picks a speed.

import { pngOf, textOf } from '../drawing/files';
import { written } from '../drawing/numbers';
import { type Drawn, stacked } from '../drawing/plot';
import { onResize } from '../drawing/sized';
import { readTheme } from '../drawing/theme';
import { withError } from '../inputs/digits';
import { drawCurves, speedsOf, type Curve, type CurveContent } from './curve_picture';
import { nearestPoint, type Current } from './curve_scales';
import './charts.css';

export interface CurveChart {
  setCurves(curves: Curve[]): void;
  /** Shows the point that the inputs stand for. */
  setCurrent(speed: number, restitution: number, error: number): void;
  /** Calls back with a speed that a reader has picked. */
  onPick(callback: (speed: number) => void): void;
  toPng(): Promise<Blob>;
  toSvg(): string;
}

const STEPS = 100; // of the keyboard along the axis

/** Makes an empty chart in an element. */
export function createCurveChart(host: HTMLElement): CurveChart {
  const place = document.createElement('div');
  place.className = 'chart curve-chart';
  const options = document.createElement('div');
  options.className = 'chart-options';
  const label = document.createElement('label');
  const loss = Object.assign(document.createElement('input'), { type: 'checkbox' });
  label.append(loss, 'Show the loss 1 − ε², logarithmic');
  options.append(label);
  const area = document.createElement('div');
  area.className = 'chart-area';
  area.tabIndex = 0;
  area.setAttribute('role', 'slider');
  area.setAttribute('aria-label', 'Speed, picked on the chart of ε');
  const note = Object.assign(document.createElement('p'), { className: 'chart-note' });
  place.append(options, area, note);
  host.append(place);
  let curves: Curve[] = [];
  let current: Current | undefined;
  let callback: (speed: number) => void = () => undefined;
  let asked = 0;
  let chart: Drawn | undefined;
  onResize(area, draw);
  loss.addEventListener('change', draw);
  area.addEventListener('click', (event) => callback(rounded(speedAt(event.clientX))));
  area.addEventListener('pointermove', (event) => tell(speedAt(event.clientX)));
  area.addEventListener('pointerleave', () => tell());
  area.addEventListener('keydown', onKey);

  function content(): CurveContent {
    return { curves, current, ordinate: loss.checked ? 'loss' : 'restitution' };
  }

  function draw(): void {
    cancelAnimationFrame(asked);
    const width = area.clientWidth;
    if (!width) return;
    area.replaceChildren(picture(width));
    tell();
  }

  function picture(width: number, ground?: string): SVGSVGElement {
    const [all, legend] = drawCurves(content(), width, readTheme(area));
    if (!ground) chart = all;
    return stacked([all, legend], 'ε against the speed', ground);
  }

  function drawSoon(): void {
    cancelAnimationFrame(asked);
    asked = requestAnimationFrame(draw);
  }

  function speedAt(clientX: number): number {
    const { low, high } = speedsOf(content());
    const at = chart?.scale('x')?.invert?.(clientX - area.getBoundingClientRect().left) ?? low;
    return Math.min(high, Math.max(low, at));
  }

  /** Says the points nearest to a speed, or the current one. */
  function tell(speed?: number): void {
    const unit = curves[0]?.encounter.si ? 'm/s' : 'c';
    const at = (each: Current): string =>
      `v = ${written(each.speed, 3)} ${unit}: ε = ${withError(each.restitution, each.error)}`;
    const now = current ? at(current) : '';
    area.setAttribute('aria-valuetext', now || 'none');
    if (speed === undefined) {
      const left = curves.reduce((sum, each) => sum + each.planned.length - each.points.length, 0);
      const toCome = left > 0 ? `${left} ${left === 1 ? 'speed is' : 'speeds are'} still to come` : '';
      note.textContent = [now, toCome].filter(Boolean).join('; ');
      return;
    }
    const near = curves.flatMap((each) => {
      const point = nearestPoint(each.points, speed);
      return point ? [`${curves.length > 1 ? `${each.label}, ` : ''}${at(point)}`] : [];
    });
    note.textContent = near.join('; ');
  }

  function onKey(event: KeyboardEvent): void {
    const scale = speedsOf(content());
    const step = (scale.high / scale.low) ** (1 / STEPS);
    const from = current?.speed ?? Math.sqrt(scale.low * scale.high);
    const places: Record<string, number> = {
      ArrowRight: from * step, ArrowUp: from * step, ArrowLeft: from / step, ArrowDown: from / step,
      PageUp: from * step ** 10, PageDown: from / step ** 10, Home: scale.low, End: scale.high,
    };
    const to = places[event.key];
    if (to === undefined) return;
    event.preventDefault();
    callback(rounded(Math.min(scale.high, Math.max(scale.low, to))));
  }

  return {
    setCurves(next) {
      curves = next;
      const scale = speedsOf(content());
      area.setAttribute('aria-valuemin', String(scale.low));
      area.setAttribute('aria-valuemax', String(scale.high));
      drawSoon();
    },
    setCurrent(speed, restitution, error) {
      current = { speed, restitution, error };
      area.setAttribute('aria-valuenow', String(speed));
      drawSoon();
    },
    onPick(next) {
      callback = next;
    },
    toPng() {
      return pngOf(this.toSvg());
    },
    toSvg: () => textOf(picture(Math.max(480, area.clientWidth), readTheme(area).background)),
  };
}

/** A speed with three digits, which is what a place on a chart is good for. */
function rounded(speed: number): number {
  return Number(speed.toPrecision(3));
}
