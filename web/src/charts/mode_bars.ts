// Energies of the modes on the page: each bar is a button that shows its mode.
import { greatest } from 'd3-array';
import { html, render } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import { unitsOf } from '../core/local';
import type { Collision, Core, Encounter, Shape } from '../core/protocol';
import { choice, keyed } from '../drawing/dom';
import { withUnit, written } from '../drawing/numbers';
import { chartIn } from '../drawing/pictures';
import { type Drawn, BESIDE, stacked } from '../drawing/plot';
import { readTheme } from '../drawing/theme';
import { say } from '../drawing/words';
import { equal, meetingOf, meetsBody } from '../inputs/document';
import { isBlock } from '../inputs/kinds';
import { evenGrid } from '../scene/grid';
import { partsOf } from '../scene/parts';
import {
  type ModeBar, type ModeLayout, type When, drawModes, energyOfWaves, layoutModes, swingShape,
} from './mode_picture';

const PITCH = 17; // pixels of a bar, at least
const SMALLEST = 24; // height of what is pressed
const MOST = 40;
const SHAPE = 168;

const WHEN: [When, string][] = [['after', say('modes.after')], ['average', say('modes.average')]];
const AXES: [boolean, string][] = [[true, say('modes.logarithmic')], [false, say('modes.linear')]];
const BODIES: [0 | 1, string][] = [[0, say('modes.first')], [1, say('modes.second')]];

/** Makes an empty chart in an element. */
export function createModeBars(host: HTMLElement, core: Core) {
  const chosen = { when: 'after' as When, log: true, body: 0 as 0 | 1 };
  let now: { encounter: Encounter; collision: Collision } | undefined;
  let layout: ModeLayout = { bars: [], groups: [], omitted: 0, rest: 0 };
  let axes: Drawn | undefined;
  let shown: SVGSVGElement | undefined;
  let mode = ''; // the one whose shape is shown
  let swinging = ''; // the one that the canvas shows, or will
  let shapes = new Map<string, Promise<Shape>>();
  let stop = (): void => undefined;
  tell();
  const chart = host.querySelector<HTMLElement>('.mode-bars-chart')!;
  const canvas = host.querySelector('canvas')!;
  const { update, picture } = chartIn(chart, say('modes.picture'), (width, theme, leaving) => {
    if (!now) return [];
    const count = Math.max(6, Math.min(MOST, Math.floor((width - BESIDE) / PITCH)));
    const its = layoutModes(now.collision.modes, chosen.body, chosen.when, count);
    if (!leaving) layout = its;
    return drawModes(its, chosen.log, chosen.when, width, theme);
  }, (parts) => {
    axes = parts[0];
    shown = stacked(parts, say('modes.picture'));
    swinging = '';
    choose(bar() ?? greatest(layout.bars, (each) => each.energy));
  });

  function isPair(): boolean {
    return now !== undefined && meetsBody(now.encounter);
  }

  function bar(): ModeBar | undefined {
    return layout.bars.find((each) => nameOf(each) === mode);
  }

  /** Brings all but the picture up to date. */
  function tell(): void {
    const set = (change: Partial<typeof chosen>): void => {
      Object.assign(chosen, change);
      update();
    };
    const its = bar();
    render(html`
      <div class="chart">
        <div class="chart-options">
          ${choice(say('modes.energy'), WHEN, chosen.when, (when) => set({ when }))}
          ${choice(say('modes.axis'), AXES, chosen.log, (log) => set({ log }))}
          ${choice(say('form.body'), BODIES, chosen.body, (body) => set({ body }), !isPair())}
        </div>
        <div class="mode-bars">
          <div class="mode-bars-chart">
            <div class="chart-area" aria-hidden="true">${shown}</div>
            <div role="group" aria-label=${say('modes.arrows')} @keydown=${onKey}>
              ${repeat(layout.bars, nameOf, (each) => html`
                <button type="button" class="mode-bar" aria-label=${wordsOf(each)} aria-pressed=${each === its}
                  tabindex=${each === its ? 0 : -1} style=${boxOf(each)} @click=${() => choose(each)}
                  @focus=${() => choose(each)}
                  @pointerenter=${(event: PointerEvent) => event.pointerType === 'mouse' && choose(each)}></button>`)}
            </div>
            <p class="chart-note">${now && noteOf(now)}</p>
          </div>
          <figure class="mode-shape" ?hidden=${!its}>
            <canvas aria-hidden="true"></canvas>
            <figcaption aria-live="polite">${its && wordsOf(its)}</figcaption>
          </figure>
        </div>
      </div>`, host);
  }

  function boxOf({ left, width, energy }: ModeBar): string {
    const [x, y] = [axes!.scale('x')!, axes!.scale('y')!];
    const [ground = 0, ceiling = 0] = y.range as number[];
    const top = Math.max(ceiling, Math.min(ground - SMALLEST, y.apply(energy) - 4));
    const [from, to] = [x.apply(left), x.apply(left + width)];
    return `left: ${from}px; top: ${top}px; width: ${to - from}px; height: ${ground - top}px`;
  }

  function noteOf({ encounter, collision }: NonNullable<typeof now>): string {
    return [
      layout.bars.length ? '' : say('modes.none'),
      layout.omitted ? say('modes.more', { count: layout.omitted, share: percent(layout.rest) }) : '',
      isBlock(meetingOf(encounter).against) && chosen.when === 'after'
        ? say('modes.waves', { share: percent(energyOfWaves(collision)) }) : '',
    ].filter(Boolean).join(' ');
  }

  function choose(next: ModeBar | undefined): void {
    mode = next ? nameOf(next) : '';
    tell();
    if (next && swinging !== mode) void swingMode(next);
  }

  async function swingMode({ mode: its }: ModeBar): Promise<void> {
    const { encounter } = now!;
    const name = (swinging = mode);
    const grid = evenGrid(meetingOf(encounter).kind);
    try {
      const asked = shapes.get(name) ?? core('shape', encounter, { ...its, grid });
      shapes.set(name, asked);
      const shape = await asked;
      if (swinging !== name) return;
      stop();
      const part = partsOf(encounter, [1, 1].slice(0, its.body + 1), grid)[its.body]!;
      stop = swingShape(canvas, SHAPE, part, shape, () => readTheme(host));
      canvas.hidden = false;
    } catch {
      shapes.delete(name);
      if (swinging !== name) return;
      stop();
      canvas.hidden = true;
    }
  }

  function wordsOf({ mode: { order, index, omega }, energy }: ModeBar): string {
    const frequency = frequencyInWords(omega, now!.encounter);
    return say('modes.mode', { order, index, frequency, share: percent(energy), when: say(`modes.${chosen.when}`) });
  }

  function onKey(event: KeyboardEvent): void {
    const all = host.querySelectorAll<HTMLElement>('.mode-bar');
    const at = Array.from(all).indexOf(document.activeElement as HTMLElement);
    const to = keyed(event, { at, first: 0, last: all.length - 1, step: 1 });
    if (to !== undefined) all[to]?.focus();
  }

  return {
    show(encounter: Encounter, collision: Collision): void {
      if (!now || !equal(now.encounter, encounter)) shapes = new Map();
      now = { encounter, collision };
      if (!isPair()) chosen.body = 0;
      update();
    },
    picture,
  };
}

function nameOf({ mode }: ModeBar): string {
  return `${mode.body} ${mode.order} ${mode.index}`;
}

function percent(share: number): string {
  return `${written(100 * share, 3)} %`;
}

/** A frequency in words: ω in c/R, or in SI ω/2π in Hz. */
export function frequencyInWords(omega: number, encounter: Encounter): string {
  const { si, first } = meetingOf(encounter);
  if (!si) return `ω = ${written(omega)} c/${first.kind.length}`;
  return withUnit((omega * unitsOf(encounter).frequency) / (2 * Math.PI), 'Hz', 4);
}
