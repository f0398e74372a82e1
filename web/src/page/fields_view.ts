// The number fields of the form: label, text field, unit, and the line that says what is wrong.
import { html, nothing, render } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import { find } from '../drawing/dom';
import { type Field, fieldsOf, owner, valueOf, wordsOf } from '../inputs/fields';
import type { Inputs } from '../inputs/inputs';
import { displayed } from '../drawing/numbers';

const homes = ['first-fields', 'second-fields', 'speed-field', 'motion-fields'] as const;

function homeOf(field: Field): (typeof homes)[number] {
  const place = owner(field);
  if (place === undefined) return field === 'speed' ? 'speed-field' : 'motion-fields';
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
    const { label, help, unit } = wordsOf(encounter, field);
    const [id, problem] = [`field-${field}`, problems.get(field) ?? ''];
    return html`
      <div class="field" title=${help}>
        <label for=${id}>${label}</label>
        <input id=${id} type="text" inputmode="decimal" autocomplete="off" spellcheck="false" data-field=${field}
          aria-describedby="${id}-unit ${id}-problem" aria-invalid=${problem === '' ? nothing : 'true'}
          aria-label=${owner(field)?.second ? `${label}, of what it meets` : nothing} />
        <span id="${id}-unit" class="unit">${unit}</span>
        <p id="${id}-problem" class="problem" ?hidden=${problem === ''}>${problem}</p>
      </div>`;
  };
  for (const home of homes) {
    const fields = fieldsOf(inputs).filter((field) => homeOf(field) === home);
    render(repeat(fields, (field) => field, rowOf), find(home, HTMLElement));
  }
}

/** Bring the numbers up to date; one just being typed stays as it is. */
export function showNumbers(inputs: Inputs): void {
  for (const field of fieldsOf(inputs)) {
    const value = valueOf(inputs, field);
    const input = inputOf(field);
    const typed = input.value.trim() !== '' && (Number(input.value) === value || input.value === displayed(value));
    if (!typed) input.value = displayed(value);
  }
}
