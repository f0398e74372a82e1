// The fields of the form: where each is, its number and what is wrong with it.
import { html, nothing, render } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import { find } from '../drawing/dom';
import { say } from '../drawing/words';
import { standsFor } from '../inputs/check';
import { type Field, fieldsOf, isLossOrFace, measureOf, owner, shownOf, textOf as written, wordsOf } from '../inputs/fields';
import type { Inputs, View } from '../inputs/inputs';

const homes = [
  'first-fields', 'second-fields', 'speed-field', 'motion-fields', 'more-motion', 'more-first', 'more-second',
] as const;

function homeOf(field: Field, view: View): (typeof homes)[number] {
  const place = owner(field);
  if (place === undefined) return field === 'speed' ? 'speed-field' : view === 'ball' ? 'more-motion' : 'motion-fields';
  if (isLossOrFace(field)) return place.second ? 'more-second' : 'more-first';
  return place.second ? 'second-fields' : 'first-fields';
}

function inputOf(field: Field): HTMLInputElement {
  return find(`field-${field}`, HTMLInputElement);
}

/** The text of a field that is shown. */
export function textOf(field: Field): string {
  return inputOf(field).value;
}

/** Show the fields of inputs with what is wrong: screen readers hear the unit and the problem with a field. */
export function showFields(inputs: Inputs, problems: ReadonlyMap<Field, string>): void {
  const { encounter } = inputs;
  const rowOf = (field: Field): unknown => {
    const measure = measureOf(inputs, field);
    const words = wordsOf(encounter, field);
    const { help } = words;
    const [named, unit] = measure ? [say(measure.words), measure.unit] : [words.label, words.unit];
    const spoken = owner(field)?.second ? say('form.of_second', { label: named }) : named;
    const mode = owner(field)?.name === 'relaxation' ? 'text' : 'decimal';
    const [id, problem] = [`field-${field}`, problems.get(field) ?? ''];
    return html`
      <div class="field" title=${help}>
        <label for=${id}>${named}</label>
        <input id=${id} type="text" inputmode=${mode} autocomplete="off" spellcheck="false" data-field=${field}
          aria-describedby="${id}-unit ${id}-problem" aria-invalid=${problem === '' ? nothing : 'true'}
          aria-label=${spoken === named ? nothing : spoken} />
        <span id="${id}-unit" class="unit">${unit}</span>
        <p id="${id}-problem" class="problem" ?hidden=${problem === ''}>${problem}</p>
      </div>`;
  };
  for (const home of homes) {
    const fields = fieldsOf(inputs).filter((field) => homeOf(field, inputs.view) === home);
    render(repeat(fields, (field) => field, rowOf), find(home, HTMLElement));
    if (home.startsWith('more')) find(home, HTMLElement).parentElement!.hidden = fields.length === 0;
    if (home.startsWith('more') && fields.some((field) => problems.has(field))) find('more', HTMLDetailsElement).open = true;
  }
}

/** Bring the numbers up to date; one just being typed stays as it is. */
export function showNumbers(inputs: Inputs): void {
  for (const field of fieldsOf(inputs)) {
    const value = shownOf(inputs, field);
    const input = inputOf(field);
    if (!standsFor(input.value, field, value)) input.value = written(value);
  }
}
