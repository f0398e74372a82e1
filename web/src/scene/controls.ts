// The controls below a film: play, step, time, speed, colours.

import { html, type TemplateResult } from 'lit-html';
import { choice } from '../drawing/dom';
import type { Quantity } from './colors';

export interface State {
  playing: boolean;
  /** share of the film that has passed, and the time in words */
  share: number;
  words: string;
  /** whether there is a film, and of which colours there is a choice */
  ready: boolean;
  colored: boolean;
  speed: number;
  quantity: Quantity;
}

export interface Actions {
  toggle(): void;
  step(direction: 1 | -1): void;
  scrub(share: number): void;
  speed(factor: number): void;
  color(quantity: Quantity): void;
}

const PIECES = 400; // of the scrubber

const SPEEDS: [number, string][] = [[0.1, '⅒ ×'], [0.25, '¼ ×'], [0.5, '½ ×'], [1, '1 ×'], [2, '2 ×'], [4, '4 ×']];
const COLORS: [Quantity, string][] = [['fringes', 'Fringes'], ['vonMises', 'von Mises stress']];

const PLAY = 'M4 2.5v11l9.5-5.5z';
const PAUSE = 'M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z';
const BACK = 'M12 2.5v11L5 8zM3 2.5h1.8v11H3z';
const NEXT = 'M4 2.5v11L11 8zM11.2 2.5H13v11h-1.8z';

export function controlsOf(state: State, actions: Actions): TemplateResult {
  const button = (name: string, path: string, action: () => void, kind = ''): TemplateResult => html`
    <button type="button" class=${kind} title=${name} aria-label=${name} ?disabled=${!state.ready} @click=${action}>
      <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
        <path fill="currentColor" d=${path}></path>
      </svg>
    </button>`;
  const scrub = (event: Event): void => actions.scrub(Number((event.target as HTMLInputElement).value) / PIECES);
  return html`
    <div class="scene-controls" role="group" aria-label="Film of the collision">
      ${button(state.playing ? 'Pause' : 'Play', state.playing ? PAUSE : PLAY, actions.toggle, 'scene-play')}
      ${button('Step back', BACK, () => actions.step(-1))} ${button('Step forward', NEXT, () => actions.step(1))}
      <input type="range" class="scene-time" min="0" max=${PIECES} step="1" aria-label="Time in the film"
        aria-valuetext=${state.words} .value=${String(Math.round(state.share * PIECES))} ?disabled=${!state.ready}
        @input=${scrub} />
      ${choice('Playback', SPEEDS, state.speed, actions.speed)}
      ${choice('Colours', COLORS, state.quantity, actions.color, !state.colored)}
    </div>`;
}
