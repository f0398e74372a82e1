// The controls below a film: play, step, time, speed, colours.

import type { Quantity } from './colors';

export interface Controls {
  element: HTMLElement;
  /** shows whether it plays */
  setPlaying(playing: boolean): void;
  /** shows a time: its share of the film and what it is in words */
  setTime(share: number, words: string): void;
  setEnabled(enabled: boolean): void;
  /** whether there is a choice of colours */
  setColored(colored: boolean): void;
}

export interface Actions {
  toggle(): void;
  step(direction: 1 | -1): void;
  scrub(share: number): void;
  speed(factor: number): void;
  color(quantity: Quantity): void;
}

/** Pieces of the scrubber. */
export const PIECES = 400;

const SPEEDS: [number, string][] = [[0.1, '⅒ ×'], [0.25, '¼ ×'], [0.5, '½ ×'], [1, '1 ×'], [2, '2 ×'], [4, '4 ×']];
const COLORS: [Quantity, string][] = [['fringes', 'Fringes'], ['vonMises', 'von Mises stress']];

const PLAY = 'M4 2.5v11l9.5-5.5z';
const PAUSE = 'M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z';
const BACK = 'M12 2.5v11L5 8zM3 2.5h1.8v11H3z';
const NEXT = 'M4 2.5v11L11 8zM11.2 2.5H13v11h-1.8z';

function icon(path: string): string {
  return '<svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">' +
    `<path fill="currentColor" d="${path}"/></svg>`;
}

function button(name: string, path: string, action: () => void): HTMLButtonElement {
  const element = document.createElement('button');
  element.type = 'button';
  element.title = name;
  element.setAttribute('aria-label', name);
  element.innerHTML = icon(path);
  element.addEventListener('click', action);
  return element;
}

function choice<T>(name: string, options: [T, string][], chosen: T, action: (value: T) => void): HTMLLabelElement {
  const label = document.createElement('label');
  const select = document.createElement('select');
  options.forEach(([value, words], k) => select.add(new Option(words, String(k), value === chosen, value === chosen)));
  select.addEventListener('change', () => action(options[select.selectedIndex]![0]));
  label.append(Object.assign(document.createElement('span'), { textContent: name }), select);
  return label;
}

/** Makes the controls. */
export function createControls(actions: Actions): Controls {
  const element = document.createElement('div');
  element.className = 'scene-controls';
  element.setAttribute('role', 'group');
  element.setAttribute('aria-label', 'Film of the collision');
  const play = button('Play', PLAY, actions.toggle);
  play.classList.add('scene-play');
  const scrub = Object.assign(document.createElement('input'), {
    type: 'range', min: '0', max: String(PIECES), step: '1', value: '0', className: 'scene-time',
  });
  scrub.setAttribute('aria-label', 'Time in the film');
  scrub.addEventListener('input', () => actions.scrub(Number(scrub.value) / PIECES));
  const colors = choice('Colours', COLORS, 'fringes', actions.color);
  element.append(
    play,
    button('Step back', BACK, () => actions.step(-1)),
    button('Step forward', NEXT, () => actions.step(1)),
    scrub,
    choice('Playback', SPEEDS, 1, actions.speed),
    colors,
  );
  const all = Array.from(element.querySelectorAll<HTMLButtonElement | HTMLInputElement>('button, input'));
  return {
    element,
    setPlaying(playing) {
      const name = playing ? 'Pause' : 'Play';
      if (play.title === name) return;
      play.title = name;
      play.setAttribute('aria-label', name);
      play.innerHTML = icon(playing ? PAUSE : PLAY);
    },
    setTime(share, words) {
      scrub.value = String(Math.round(share * PIECES));
      scrub.setAttribute('aria-valuetext', words);
    },
    setColored(colored) {
      colors.hidden = !colored;
    },
    setEnabled(enabled) {
      for (const each of all) each.disabled = !enabled;
    },
  };
}
