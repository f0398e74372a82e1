// A chart along whose axis a reader picks a place, by pointer or by keys.

import { html, nothing, render, type TemplateResult } from 'lit-html';
import { keyed } from '../drawing/dom';
import { chartIn } from '../drawing/pictures';
import { type Drawn, stacked } from '../drawing/plot';
import type { Theme } from '../drawing/theme';
import { say } from '../drawing/words';

const STEPS = 100; // of the keyboard along the axis

/** What is picked from. */
export interface Pickable {
  title: string;
  /** what is picked, for screen readers, and what it is now */
  label: string;
  words(): string;
  draw(width: number, theme: Theme): Drawn[];
  /** ends of the axis, where the inputs are on it, and what a key moves them, without it a hundredth */
  axis(): { low: number; high: number; log: boolean; at: number | undefined; step?: number };
  /** a place as it is picked */
  rounded(place: number): number;
  /** what is below the chart, while the pointer is at some place */
  note(pointed: number | undefined): unknown;
  /** controls above the chart; `update` draws it anew */
  options?(update: () => void): TemplateResult;
}

/** Makes a chart in an element; `pick` gets a place that a reader has picked. */
export function createPicker(host: HTMLElement, of: Pickable, pick: (place: number) => void) {
  let chart: Drawn | undefined;
  let shown: SVGSVGElement | undefined;
  let pointed: number | undefined;
  const { update, updateSoon, picture } = chartIn(host, of.title, (width, theme) => of.draw(width, theme), (parts) => {
    chart = parts[0];
    shown = stacked(parts, of.title);
    tell();
  });
  tell();

  /** Brings all but the picture up to date. */
  function tell(): void {
    const { at, first, last } = along();
    const point = (event?: MouseEvent): void => {
      pointed = event && placeOf(event);
      tell();
    };
    render(html`
      <div class="chart curve-chart">
        ${of.options ? html`<div class="chart-options">${of.options(update)}</div>` : nothing}
        <div class="chart-area" tabindex="0" role="slider" aria-label=${of.label} aria-valuemin="0"
          aria-valuemax=${STEPS} aria-valuenow=${Math.round((STEPS * (at - first)) / (last - first))} aria-valuetext=${of.words() || say('curve.none')}
          @click=${(event: MouseEvent) => pick(placeOf(event))} @pointermove=${point}
          @pointerleave=${() => point()} @keydown=${onKey}>${shown}</div>
        <p class="chart-note">${of.note(pointed)}</p>
      </div>`, host);
  }

  function placeOf({ clientX, currentTarget }: MouseEvent): number {
    const { low, high } = of.axis();
    const place = clientX - (currentTarget as HTMLElement).getBoundingClientRect().left;
    return of.rounded(Math.min(high, Math.max(low, chart?.scale('x')?.invert?.(place) ?? low)));
  }

  /** The axis as it is drawn, with its middle for a place that is not on it; and what makes a place of one along it. */
  function along() {
    const { low, high, log, at, step } = of.axis();
    const [on, off] = log ? [Math.log, Math.exp] : [Number, Number];
    const [first, last] = [on(low), on(high)];
    return { at: at === undefined ? 0.5 * (first + last) : on(at), first, last, step: step ?? (last - first) / STEPS, off };
  }

  function onKey(event: KeyboardEvent): void {
    const to = keyed(event, along());
    if (to !== undefined) pick(of.rounded(along().off(to)));
  }

  return { update: updateSoon, picture };
}
