// Force, velocity and energies of one collision in time, above each other, with one cursor.

import type { Collision } from '../core/protocol';
import { pngOf, textOf } from '../drawing/files';
import { type Drawn, drawLegend, stacked } from '../drawing/plot';
import { onResize } from '../drawing/sized';
import { look, readTheme } from '../drawing/theme';
import { drawPanel, panelLabel, panelsOf, type Panel } from './series';
import { cursorWords, readable, summaryOf, valueWords } from './words';
import './charts.css';

export interface TimeCharts {
  show(collision: Collision): void;
  /** Puts the cursor to a time, in the collision's units. */
  setCursor(time: number): void;
  /** Calls back when a reader moves the cursor. */
  onCursor(callback: (time: number) => void): void;
  toPng(): Promise<Blob>;
  toSvg(): string;
}

const HEIGHTS = [90, 90, 160];
const STEPS = 100;

/** A chart on the page, with the line of the cursor. */
interface Shown {
  drawn: Drawn;
  line: HTMLElement;
}

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
  let charts: Shown[] = [];
  let panels: Panel[] = [];
  let values: HTMLElement[] = [];
  let cursor = 0; // in the readable unit, as all times inside
  let second = 1;
  let callback: (time: number) => void = () => undefined;
  onResize(place, draw);
  place.addEventListener('keydown', onKey);

  function ends({ time }: Collision): [number, number] {
    return [time[0]!, time[time.length - 1]!];
  }

  function panelsAs(width: number, named: boolean): Drawn[] {
    const theme = readTheme(place);
    return panels.map((panel, n) =>
      drawPanel(collision!, panel, width, HEIGHTS[n]!, n === panels.length - 1, named, theme));
  }

  function draw(): void {
    const width = place.clientWidth;
    if (!collision || !width) return;
    values = [];
    charts = panelsAs(width, false).map((drawn) => {
      const line = Object.assign(document.createElement('div'), { className: 'chart-cursor' });
      const [low = 0, high = 0] = drawn.scale('y')!.range as number[];
      Object.assign(line.style, { top: `${high}px`, height: `${low - high}px` });
      return { drawn, line };
    });
    place.replaceChildren(...charts.flatMap(({ drawn, line }, n) => {
      const area = Object.assign(document.createElement('div'), { className: 'chart-time' });
      area.setAttribute('aria-hidden', 'true');
      area.append(drawn, line);
      listen(area, drawn);
      return [heading(panels[n]!), area];
    }));
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
      const value = Object.assign(document.createElement('span'), { className: 'chart-value' });
      item.append(value);
      values.push(value);
      head.append(item);
    });
    return head;
  }

  function listen(area: HTMLElement, drawn: Drawn): void {
    const move = (event: PointerEvent): void => {
      if (event.type === 'pointermove' && !(event.buttons & 1)) return;
      if (event.type === 'pointerdown') area.setPointerCapture(event.pointerId);
      choose(drawn.scale('x')!.invert!(event.clientX - area.getBoundingClientRect().left));
    };
    area.addEventListener('pointerdown', move);
    area.addEventListener('pointermove', move);
  }

  function choose(time: number): void {
    const [first, last] = ends(collision!);
    const inside = Math.min(last, Math.max(first, time));
    put(inside);
    callback(inside * second);
  }

  function onKey(event: KeyboardEvent): void {
    if (!collision) return;
    const [first, last] = ends(collision);
    const step = (last - first) / STEPS;
    const places: Record<string, number> = {
      ArrowRight: cursor + step, ArrowUp: cursor + step, ArrowLeft: cursor - step, ArrowDown: cursor - step,
      PageUp: cursor + 10 * step, PageDown: cursor - 10 * step, Home: first, End: last,
    };
    const to = places[event.key];
    if (to === undefined) return;
    event.preventDefault();
    choose(to);
  }

  function put(time: number): void {
    cursor = time;
    if (!collision) return;
    const [first, last] = ends(collision);
    const inside = time >= first && time <= last;
    for (const { drawn, line } of charts) {
      line.hidden = !inside;
      line.style.transform = `translateX(${drawn.scale('x')!.apply(time)}px)`;
    }
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
      const [first, last] = ends(collision);
      panels = panelsOf(collision);
      words.textContent = summaryOf(collision);
      place.setAttribute('aria-valuemin', String(first));
      place.setAttribute('aria-valuemax', String(last));
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
      const width = Math.max(480, place.clientWidth);
      const theme = readTheme(place);
      const entries = panels.at(-1)!.series.map(({ label }, k) => ({ label, look: look(k, theme), line: true, marker: false }));
      const parts = [...panelsAs(width, true), drawLegend(entries, width, theme)];
      return textOf(stacked(parts, 'Force, velocity and energies in time', theme.background));
    },
  };
}
