// The number fields of the form: label, text field, unit, and the line that says what is wrong.
import { type Field, helpOf, labelOf, owner, unitOf, valueOf } from '../inputs/fields';
import type { Inputs } from '../inputs/inputs';
import { displayed } from '../inputs/number';
import { make } from './dom';

export interface FieldView {
  readonly row: HTMLElement;
  readonly input: HTMLInputElement;
  readonly label: HTMLElement;
  readonly unit: HTMLElement;
  readonly problem: HTMLElement;
}

/** A field with its label; screen readers hear the unit and the problem with it. */
export function makeField(field: Field): FieldView {
  const id = `field-${field}`;
  const input = make('input', {
    id, type: 'text', inputmode: 'decimal', autocomplete: 'off', spellcheck: 'false', 'data-field': field,
    'aria-describedby': `${id}-unit ${id}-problem`,
  });
  const label = make('label', { for: id });
  const unit = make('span', { id: `${id}-unit`, class: 'unit' });
  const problem = make('p', { id: `${id}-problem`, class: 'problem', hidden: '' });
  const row = make('div', { class: 'field' }, label, input, unit, problem);
  return { row, input, label, unit, problem };
}

/** Bring label, unit and number of a field up to date; a number just being typed stays as it is. */
export function showField(view: FieldView, field: Field, inputs: Inputs): void {
  const label = labelOf(inputs.encounter, field);
  if (view.label.textContent !== label) view.label.textContent = label;
  view.row.title = helpOf(inputs.encounter, field);
  view.unit.textContent = unitOf(inputs.encounter, field);
  const value = valueOf(inputs.encounter, inputs.speed, field);
  const { value: text } = view.input;
  if (text.trim() === '' || (Number(text) !== value && text !== displayed(value))) view.input.value = displayed(value);
  const place = owner(field);
  if (place?.second === true) view.input.setAttribute('aria-label', `${label}, of what it meets`);
}

/** Show, or with '' take away, the line that says what is wrong with a field. */
export function showProblem(view: FieldView, problem: string): void {
  view.problem.textContent = problem;
  view.problem.hidden = problem === '';
  if (problem === '') view.input.removeAttribute('aria-invalid');
  else view.input.setAttribute('aria-invalid', 'true');
}
