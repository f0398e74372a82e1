// Energies of the modes on the page: each bar is a button that shows its mode.

import { unitsOf } from '../core/local';
import type { Collision, Core, Encounter, Shape } from '../core/protocol';
import { pngOf, textOf } from '../drawing/files';
import { withUnit, written } from '../drawing/numbers';
import { stacked } from '../drawing/plot';
import { onResize } from '../drawing/sized';
import { readTheme } from '../drawing/theme';
import { kindNamed } from '../inputs/kinds';
import { evenGrid } from '../scene/grid';
import { placedBodies } from '../scene/view';
import { energyOfWaves, layoutModes, type ModeBar, type ModeLayout, type When } from './mode_layout';
import { createShapeView } from './mode_shape';
import { drawModes, MODE_LABELS } from './mode_picture';
import './charts.css';

export interface ModeBars {
  show(encounter: Encounter, collision: Collision): void;
  toPng(): Promise<Blob>;
  toSvg(): string;
}

const PITCH = 17; // pixels of a bar, at least
const AXIS = 76; // and of what stands beside them
const SMALLEST = 24; // height of what is pressed
const MOST = 40;
const SHAPE = 168;

type Choice<T extends string> = [T, string][];

function select<T extends string>(name: string, options: Choice<T>, changed: () => void):
    { label: HTMLLabelElement; chosen: () => T; set: (value: T) => void } {
  const label = document.createElement('label');
  const box = document.createElement('select');
  for (const [value, words] of options) box.add(new Option(words, value));
  box.addEventListener('change', changed);
  label.append(Object.assign(document.createElement('span'), { textContent: name }), box);
  return { label, chosen: () => box.value as T, set: (value) => (box.value = value) };
}

/** Makes an empty chart in an element. */
export function createModeBars(host: HTMLElement, core: Core): ModeBars {
  const place = document.createElement('div');
  place.className = 'chart';
  const options = document.createElement('div');
  options.className = 'chart-options';
  const when = select<When>('Energy', [['after', MODE_LABELS.after], ['average', MODE_LABELS.average]], draw);
  const axis = select<'log' | 'linear'>('Axis', [['log', 'logarithmic'], ['linear', 'linear']], draw);
  const body = select<'0' | '1'>('Body', [['0', 'first'], ['1', 'second']], draw);
  options.append(when.label, axis.label, body.label);
  const both = Object.assign(document.createElement('div'), { className: 'mode-bars' });
  const chart = Object.assign(document.createElement('div'), { className: 'mode-bars-chart' });
  const picture = Object.assign(document.createElement('div'), { className: 'chart-area' });
  picture.setAttribute('aria-hidden', 'true');
  const buttons = document.createElement('div');
  buttons.setAttribute('role', 'group');
  buttons.setAttribute('aria-label', 'Modes with the most energy: arrows move between them');
  const note = Object.assign(document.createElement('p'), { className: 'chart-note' });
  chart.append(picture, buttons, note);
  const figure = Object.assign(document.createElement('figure'), { className: 'mode-shape' });
  const caption = document.createElement('figcaption');
  caption.setAttribute('aria-live', 'polite');
  const view = createShapeView(SHAPE, () => readTheme(place));
  figure.append(view.canvas, caption);
  both.append(chart, figure);
  place.append(options, both);
  host.append(place);
  let now: { encounter: Encounter; collision: Collision } | undefined;
  let layout: ModeLayout | undefined;
  let chosen = ''; // the mode whose shape is shown
  let shapes = new Map<string, Promise<Shape>>();
  let asked = 0;
  onResize(chart, draw);
  buttons.addEventListener('keydown', onKey);

  function laidOut(width: number): ModeLayout {
    const count = Math.max(6, Math.min(MOST, Math.floor((width - AXIS) / PITCH)));
    return layoutModes(now!.collision.modes, body.chosen() === '1' ? 1 : 0, when.chosen(), count);
  }

  function draw(): void {
    const width = chart.clientWidth;
    if (!now || !width) return;
    layout = laidOut(width);
    const [drawn, legend] = drawModes(layout, axis.chosen() === 'log', when.chosen(), width, readTheme(place));
    picture.replaceChildren(stacked([drawn, legend], 'Energy of the modes'));
    const [x, y] = [drawn.scale('x')!, drawn.scale('y')!];
    const [ground = 0, ceiling = 0] = y.range as number[];
    const focused = buttons.contains(document.activeElement);
    buttons.replaceChildren(...layout.bars.map((bar) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.className = 'mode-bar';
      button.dataset['mode'] = nameOf(bar);
      button.setAttribute('aria-label', wordsOf(bar));
      const top = Math.max(ceiling, Math.min(ground - SMALLEST, y.apply(bar.energy) - 4));
      const [left, right] = [x.apply(bar.left), x.apply(bar.left + bar.width)];
      const box = { left, top, width: right - left, height: ground - top };
      for (const [side, pixels] of Object.entries(box)) button.style.setProperty(side, `${pixels}px`);
      button.addEventListener('click', () => choose(bar));
      button.addEventListener('pointerenter', (event) => event.pointerType === 'mouse' && choose(bar));
      button.addEventListener('focus', () => choose(bar));
      return button;
    }));
    note.textContent = [
      layout.bars.length ? '' : 'No mode of this body has energy.',
      layout.omitted ? `${layout.omitted} more modes hold ${percent(layout.rest)} together.` : '',
      now.collision.bodies[1]?.kind === 'half-space' && when.chosen() === 'after'
        ? `The waves in the body it meets hold ${percent(energyOfWaves(now.collision))}.` : '',
    ].filter(Boolean).join(' ');
    const bar = layout.bars.find((each) => nameOf(each) === chosen)
      ?? [...layout.bars].sort((a, b) => b.energy - a.energy)[0];
    figure.hidden = !bar;
    if (bar) choose(bar, true);
    if (focused) buttons.querySelector<HTMLElement>('[tabindex="0"]')?.focus();
  }

  function choose(bar: ModeBar, again = false): void {
    const name = nameOf(bar);
    for (const each of buttons.querySelectorAll<HTMLElement>('.mode-bar')) {
      const mine = each.dataset['mode'] === name;
      each.setAttribute('aria-pressed', String(mine));
      each.tabIndex = mine ? 0 : -1;
    }
    const words = wordsOf(bar);
    if (caption.textContent !== words) caption.textContent = words;
    if (name === chosen && !again) return;
    chosen = name;
    void swingMode(bar);
  }

  async function swingMode({ mode }: ModeBar): Promise<void> {
    const { encounter, collision } = now!;
    const mine = ++asked;
    const grid = evenGrid(encounter.kind);
    const name = `${mode.body} ${mode.order} ${mode.index}`;
    try {
      const shape = shapes.get(name) ?? core.shape(encounter, mode.body, mode.order, mode.index, grid);
      shapes.set(name, shape);
      const bodies = collision.bodies.filter((each) => each.kind !== 'half-space');
      const placed = placedBodies(encounter, bodies.map((each) => each.radius));
      const shown = await shape;
      view.canvas.hidden = false;
      if (mine === asked && placed[mode.body]) view.show({ ...placed[mode.body]!, radius: 1 }, shown, grid);
    } catch {
      shapes.delete(name);
      if (mine !== asked) return;
      view.stop();
      view.canvas.hidden = true;
    }
  }

  function wordsOf({ mode, energy }: ModeBar): string {
    const { encounter } = now!;
    const frequency = frequencyInWords(mode.omega, encounter);
    return `Mode (n, l) = (${mode.order}, ${mode.index}), ${frequency}: ${percent(energy)} of the energy, ` +
      `${MODE_LABELS[when.chosen()]}`;
  }

  function onKey(event: KeyboardEvent): void {
    const all = Array.from(buttons.querySelectorAll<HTMLElement>('.mode-bar'));
    const at = all.indexOf(document.activeElement as HTMLElement);
    const places: Record<string, number> = {
      ArrowRight: at + 1, ArrowDown: at + 1, ArrowLeft: at - 1, ArrowUp: at - 1, Home: 0, End: all.length - 1,
    };
    const to = places[event.key];
    if (to === undefined) return;
    event.preventDefault();
    all[Math.min(all.length - 1, Math.max(0, to))]?.focus();
  }

  return {
    show(encounter, collision) {
      const same = now && JSON.stringify(now.encounter) === JSON.stringify(encounter);
      if (!same) shapes = new Map();
      now = { encounter, collision };
      const pair = collision.bodies.length === 2 && collision.bodies[1]!.kind !== 'half-space';
      body.label.hidden = !pair;
      if (!pair) body.set('0');
      draw();
    },
    toPng() {
      return pngOf(this.toSvg());
    },
    toSvg() {
      if (!now) throw new Error('there are no modes to draw yet');
      const width = Math.max(480, chart.clientWidth);
      const theme = readTheme(place);
      const parts = drawModes(laidOut(width), axis.chosen() === 'log', when.chosen(), width, theme);
      return textOf(stacked(parts, 'Energy of the modes', theme.background));
    },
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
  if (!encounter.si) return `ω = ${written(omega)} c/${kindNamed(encounter.kind).length}`;
  return withUnit((omega * unitsOf(encounter).frequency) / (2 * Math.PI), 'Hz', 4);
}
