// Force, velocity and energies of one collision in time, above each other, with one cursor.

import { html, nothing, render, type TemplateResult } from 'lit-html';
import type { Collision, ObliqueCollision } from '../core/protocol';
import { keyed } from '../drawing/dom';
import { chartIn } from '../drawing/pictures';
import { type Drawn, drawLegend, labelOf } from '../drawing/plot';
import { look, readTheme } from '../drawing/theme';
import { say } from '../drawing/words';
import { cursorWords, drawPanel, panelsOf, summaryOf, valueWords, type Panel } from './series';

const HEIGHTS = [90, 90, 160];
const STEPS = 100;

/** Makes empty charts in an element; `choose` gets a time to which a reader moves the cursor. */
export function createTimeCharts(host: HTMLElement, choose: (time: number) => void) {
  let collision: Collision | ObliqueCollision | undefined;
  let panels: Panel[] = [];
  let charts: Drawn[] = [];
  let cursor = 0;
  const { update, picture } = chartIn(host, say('time.title'), (width, theme, leaving) => {
    if (!collision) return [];
    const drawn = panels.map((panel, n) =>
      drawPanel(collision!, panel, width, HEIGHTS[n]!, n === panels.length - 1, leaving, theme));
    const entries = panels.at(-1)!.series.map(({ label }, k) => {
      const { color, dash } = look(k, theme);
      return { label, color, dash };
    });
    return leaving ? [...drawn, drawLegend(entries, width, theme)] : drawn;
  }, (parts) => {
    charts = parts;
    tell();
  });

  function ends(): { first: number; last: number } {
    const { time } = collision!;
    return { first: time[0]!, last: time.at(-1)! };
  }

  /** Brings all but the curves up to date. */
  function tell(): void {
    if (!collision) return;
    const { first, last } = ends();
    render(html`
      <div class="chart time-charts" tabindex="0" role="slider"
        aria-label=${say('time.pick')} aria-valuemin="0"
        aria-valuemax=${STEPS} aria-valuenow=${Math.round((STEPS * (cursor - first)) / (last - first))} aria-valuetext=${cursorWords(collision, panels, cursor)} @keydown=${onKey}>
        ${charts.map((drawn, n) => [headOf(panels[n]!), chartOf(drawn)])}
      </div>
      <p class="unseen">${summaryOf(collision)}</p>`, host);
  }

  function isInside(): boolean {
    const { first, last } = ends();
    return cursor >= first && cursor <= last;
  }

  function headOf(panel: Panel): TemplateResult {
    const theme = readTheme(host);
    return html`<div class="chart-head" aria-hidden="true"><b>${labelOf(panel)}</b>${panel.series.map((each, k) => {
      const { color, dash } = look(k, theme);
      const key = html`<svg width="26" height="8"><line y1="4" x2="26" y2="4" stroke=${color} stroke-width="2"
        stroke-dasharray=${dash.join(' ')}></line></svg>${each.label} `;
      const value = isInside() ? valueWords(collision!, panel, each, cursor) : '';
      return html`<span>${panel.series.length > 1 ? key : nothing}<span class="chart-value">${value}</span></span>`;
    })}</div>`;
  }

  function chartOf(drawn: Drawn): TemplateResult {
    const move = (event: PointerEvent): void => {
      if (event.type === 'pointermove' && !(event.buttons & 1)) return;
      const area = event.currentTarget as HTMLElement;
      if (event.type === 'pointerdown') area.setPointerCapture(event.pointerId);
      const { first, last } = ends();
      const time = drawn.scale('x')!.invert!(event.clientX - area.getBoundingClientRect().left);
      go(Math.min(last, Math.max(first, time)));
    };
    const [low = 0, high = 0] = drawn.scale('y')!.range as number[];
    const line = `top: ${high}px; height: ${low - high}px; transform: translateX(${drawn.scale('x')!.apply(cursor)}px)`;
    return html`<div class="chart-time" aria-hidden="true" @pointerdown=${move} @pointermove=${move}>
      ${drawn}<div class="chart-cursor" ?hidden=${!isInside()} style=${line}></div></div>`;
  }

  function go(time: number): void {
    cursor = time;
    tell();
    choose(time);
  }

  function onKey(event: KeyboardEvent): void {
    const { first, last } = ends();
    const to = keyed(event, { at: cursor, first, last, step: (last - first) / STEPS });
    if (to !== undefined) go(to);
  }

  return {
    show(next: Collision | ObliqueCollision): void {
      collision = next;
      panels = panelsOf(collision);
      update();
    },
    /** Puts the cursor to a time, in the collision's units. */
    setCursor(time: number): void {
      cursor = time;
      tell();
    },
    picture,
  };
}
