// Elements of the page: those of index.html, and what is made of templates.
import { html, type TemplateResult } from 'lit-html';

/** The element of the page with this id; index.html has it. */
export function find<Type extends HTMLElement>(id: string, type: new () => Type): Type {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`index.html has no ${type.name} with the id ${id}`);
  return found;
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

/** A scale along which keys move, in its own numbers. */
export interface KeyScale {
  at: number;
  first: number;
  last: number;
  step: number;
}

/** Where a key leads along a scale; undefined for a key that does not. */
export function keyed(event: KeyboardEvent, { at, first, last, step }: KeyScale): number | undefined {
  const places: Record<string, number> = {
    ArrowRight: at + step, ArrowUp: at + step, ArrowLeft: at - step, ArrowDown: at - step,
    PageUp: at + 10 * step, PageDown: at - 10 * step, Home: first, End: last,
  };
  const to = places[event.key];
  if (to === undefined) return undefined;
  event.preventDefault();
  return Math.min(last, Math.max(first, to));
}
