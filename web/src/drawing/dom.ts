// Elements of the page: those of index.html, what is made of templates, and their sizes.
import { html, type TemplateResult } from 'lit-html';

/** The element of the page with this id; index.html has it. */
export function find<Type extends HTMLElement>(id: string, type: new () => Type): Type {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`index.html has no ${type.name} with the id ${id}`);
  return found;
}

/** What an error says. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

export type Options<Value> = readonly (readonly [Value, string])[];

/** Options of a select element. */
export function optionsOf(options: Options<string>): TemplateResult[] {
  return options.map(([value, words]) => html`<option value=${value}>${words}</option>`);
}

/** A select element with its name. */
export function choice<Value>(
  name: string, options: Options<Value>, chosen: Value, choose: (value: Value) => void, hidden = false,
): TemplateResult {
  const changed = (event: Event): void => choose(options[(event.target as HTMLSelectElement).selectedIndex]![0]);
  return html`<label ?hidden=${hidden}><span>${name}</span><select @change=${changed}>${options.map(([value, words]) =>
    html`<option .selected=${value === chosen}>${words}</option>`)}</select></label>`;
}

/** Where a key leads along a scale, in its own numbers; undefined for a key that does not. */
export function keyed(
  event: KeyboardEvent, { at, first, last, step }: Record<'at' | 'first' | 'last' | 'step', number>,
): number | undefined {
  const places: Record<string, number> = {
    ArrowRight: at + step, ArrowUp: at + step, ArrowLeft: at - step, ArrowDown: at - step,
    PageUp: at + 10 * step, PageDown: at - 10 * step, Home: first, End: last,
  };
  const to = places[event.key];
  if (to === undefined) return undefined;
  event.preventDefault();
  return Math.min(last, Math.max(first, to));
}

/** Calls back whenever the width of an element or the theme changes, once a frame; returns what asks for it too. */
export function onResize(host: HTMLElement, callback: () => void): () => void {
  let asked = 0;
  let width = -1;
  const ask = (): void => {
    cancelAnimationFrame(asked);
    asked = requestAnimationFrame(callback);
  };
  new ResizeObserver(() => {
    if (host.clientWidth === width) return; // a picture that sets its own height must not ask for itself again
    width = host.clientWidth;
    ask();
  }).observe(host);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', ask);
  return ask;
}
