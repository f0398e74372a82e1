// Force, velocity and energies of one collision in time, above each other, with one cursor.

import 'uplot/dist/uPlot.min.css';
import type { Collision } from '../core/protocol';
import { onResize } from '../drawing/sized';
import { pngOf } from '../drawing/svg';
import { look, readTheme } from '../drawing/theme';
import { unitInWords } from '../drawing/ticks';
import { readable } from './readable';
import { panelLabel, panelsOf, type Panel } from './series';
import { createTimePlot, type TimePlot } from './time_plot';
import { timeSvg } from './time_svg';
import { cursorWords, summaryOf, valueWords } from './words';
import './charts.css';

export interface TimeCharts {
  show(collision: Collision): void;
  /** Puts the cursor to a time, in the collision's units. */
  setCursor(time: number): void;
  /** Calls back when a reader moves the cursor. */
  onCursor(callback: (time: number) => void): void;
  toPng(): Promise<Blob>;
  toSvg(): string;
  destroy(): void;
}

const HEIGHTS = [120, 120, 200];
const STEPS = 100;

/** Makes empty charts in an element. */
export function createTimeCharts(host: HTMLElement): TimeCharts {
  const place = document.createElement('div');
  place.className = 'chart time-charts';
  place.tabIndex = 0;
  place.setAttribute('role', 'slider');
  place.setAttribute('aria-label', 'Time in the charts of force, velocity and energies');
  const words = Object.assign(document.createElement('p'), { className: 'chart-words' });
  host.append(place, words);
  let collision: Collision | undefined;
  let plots: TimePlot[] = [];
  let panels: Panel[] = [];
  let values: HTMLElement[] = [];
  let cursor = 0; // in the readable unit, as all times inside
  let second = 1;
  let callback: (time: number) => void = () => undefined;
  const stopWatching = onResize(place, draw);
  place.addEventListener('keydown', onKey);

  function draw(): void {
    const width = place.clientWidth;
    if (!collision || !width) return;
    for (const each of plots) each.destroy();
    plots = [];
    values = [];
    place.replaceChildren();
    const theme = readTheme(place);
    const { time, units } = collision;
    panels.forEach((panel, n) => {
      place.append(heading(panel));
      const last = n === panels.length - 1;
      const label = `time since first contact (${unitInWords(units.time)})`;
      const plot = createTimePlot(place, time, label, panel, HEIGHTS[n]!, width, last, theme);
      listen(plot);
      plots.push(plot);
    });
    put(cursor);
  }

  function heading(panel: Panel): HTMLElement {
    const head = document.createElement('div');
    head.className = 'chart-head';
    head.setAttribute('aria-hidden', 'true');
    head.append(Object.assign(document.createElement('b'), { textContent: panelLabel(panel) }));
    const theme = readTheme(place);
    panel.series.forEach(({ label }, k) => {
      const { color, dash } = look(k, theme);
      const item = document.createElement('span');
      if (panel.series.length > 1) {
        item.innerHTML = `<svg width="26" height="8"><line y1="4" x2="26" y2="4" stroke="${color}" stroke-width="2" ` +
          `stroke-dasharray="${dash.join(' ')}"/></svg>`;
        item.append(`${label} `);
      }
      const value = document.createElement('span');
      value.className = 'chart-value';
      item.append(value);
      values.push(value);
      head.append(item);
    });
    return head;
  }

  function listen(plot: TimePlot): void {
    const move = (event: PointerEvent): void => {
      if (event.type === 'pointermove' && !(event.buttons & 1)) return;
      if (event.type === 'pointerdown') plot.over.setPointerCapture(event.pointerId);
      choose(plot.timeAt(event.clientX));
    };
    plot.over.addEventListener('pointerdown', move);
    plot.over.addEventListener('pointermove', move);
  }

  function choose(time: number): void {
    put(time);
    callback(time * second);
  }

  function onKey(event: KeyboardEvent): void {
    if (!collision) return;
    const { time } = collision;
    const [first, last] = [time[0]!, time[time.length - 1]!];
    const step = (last - first) / STEPS;
    const places: Record<string, number> = {
      ArrowRight: cursor + step, ArrowUp: cursor + step, ArrowLeft: cursor - step, ArrowDown: cursor - step,
      PageUp: cursor + 10 * step, PageDown: cursor - 10 * step, Home: first, End: last,
    };
    const to = places[event.key];
    if (to === undefined) return;
    event.preventDefault();
    choose(Math.min(last, Math.max(first, to)));
  }

  function put(time: number): void {
    cursor = time;
    if (!collision) return;
    for (const plot of plots) plot.setCursor(time);
    const inside = time >= collision.time[0]! && time <= collision.time[collision.time.length - 1]!;
    const shown = panels.flatMap((panel) =>
      panel.series.map((each) => (inside ? valueWords(collision!, panel, each, time) : '')));
    shown.forEach((each, k) => values[k] && (values[k].textContent = each));
    place.setAttribute('aria-valuenow', String(time));
    place.setAttribute('aria-valuetext', cursorWords(collision, panels, time));
  }

  return {
    show(next) {
      const shown = readable(next);
      cursor *= second / shown.second;
      second = shown.second;
      collision = shown.collision;
      const { time } = collision;
      panels = panelsOf(collision);
      words.textContent = summaryOf(collision);
      place.setAttribute('aria-valuemin', String(time[0]));
      place.setAttribute('aria-valuemax', String(time[time.length - 1]));
      draw();
    },
    setCursor: (time) => put(time / second),
    onCursor(next) {
      callback = next;
    },
    toPng() {
      return pngOf(this.toSvg());
    },
    toSvg() {
      if (!collision) throw new Error('there is no collision to draw yet');
      return timeSvg(collision, Math.max(480, place.clientWidth), readTheme(place));
    },
    destroy() {
      stopWatching();
      for (const each of plots) each.destroy();
      place.remove();
      words.remove();
    },
  };
}
