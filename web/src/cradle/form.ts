// The form of the cradle: it shows the inputs, and tells what the user makes of them.
import { html, nothing, render, type TemplateResult } from 'lit-html';
import { range } from 'd3-array';
import { find } from '../drawing/dom';
import { displayed, rounded, withUnit } from '../drawing/numbers';
import { type Word, say } from '../drawing/words';
import { parseNumber, standsFor } from '../inputs/check';
import { materials } from '../inputs/kinds';
import {
  type CradleInputs, type NumberName, examples, fewestBalls, leaves, mostBalls, namesOf, scenes, speedAt, startOf,
  toAddress, withBalls,
} from './inputs';

/** What a field shows of a number in m: its name, and how much larger its number is in mm. */
const fields: Record<NumberName, { factor: number; cradle: Word; drop: Word }> = {
  radius: { factor: 2000, cradle: 'ball.diameter', drop: 'cradle.diameter_upper' },
  radius2: { factor: 2000, cradle: 'ball.diameter', drop: 'cradle.diameter_lower' },
  drop: { factor: 1000, cradle: 'ball.height', drop: 'ball.height' },
  gap: { factor: 1000, cradle: 'cradle.gap', drop: 'cradle.gap' },
};

/** In which they are shown. */
const unit = 'mm';

const sceneWords = { cradle: 'cradle.title', drop: 'cradle.drop_title' } as const;
const leaveWords = { fades: 'cradle.fades', stays: 'cradle.stays' } as const;

/** What the form reports: inputs that can be asked for, while typing goes on or at its end; or that some are wrong. */
export interface Listener {
  changed(inputs: CradleInputs, settled: boolean): void;
  wrong(): void;
}

/** Wire the form of cradle.html. */
export function createForm(initial: CradleInputs, listener: Listener) {
  const form = find('cradle-inputs', HTMLFormElement);
  let inputs = initial;
  /** What is typed and is no number that counts. */
  const problems = new Map<NumberName, string>();

  const shownOf = (name: NumberName): number => rounded(inputs[name] * fields[name].factor, 12);
  const label = (name: NumberName): string => say(fields[name][inputs.scene]);

  function take(next: CradleInputs, settled = true): void {
    inputs = next;
    draw();
    if (problems.size > 0) listener.wrong();
    else listener.changed(inputs, settled);
  }

  function typed(name: NumberName, text: string, settled: boolean): void {
    problems.delete(name);
    const parsed = parseNumber(label(name), text);
    let next = inputs;
    if ('problem' in parsed) problems.set(name, parsed.problem);
    else if (!(parsed.value >= 0)) problems.set(name, say('cradle.negative', { key: label(name), got: text }));
    else if (parsed.value !== shownOf(name)) next = { ...inputs, [name]: parsed.value / fields[name].factor };
    take(next, settled);
  }

  /** Choices beside each other, of which one is chosen. */
  function segments<Value extends string | number>(
    name: string, title: string, options: readonly (readonly [Value, string])[], chosen: Value, choose: (value: Value) => void,
  ): TemplateResult {
    return html`<div class="segments" role="radiogroup" aria-label=${title}>${options.map(([value, words]) => html`
      <label><input type="radio" name=${name} value=${value} .checked=${value === chosen}
        @change=${() => choose(value)} /><span>${words}</span></label>`)}</div>`;
  }

  function number(name: NumberName): TemplateResult {
    const [id, problem] = [`field-${name}`, problems.get(name) ?? ''];
    return html`
      <div class="field">
        <label for=${id}>${label(name)}</label>
        <input id=${id} type="text" inputmode="decimal" autocomplete="off" spellcheck="false"
          aria-describedby="${id}-unit ${id}-problem" aria-invalid=${problem === '' ? nothing : 'true'}
          @input=${(event: Event) => typed(name, (event.target as HTMLInputElement).value, false)}
          @change=${(event: Event) => typed(name, (event.target as HTMLInputElement).value, true)} />
        <span id="${id}-unit" class="unit">${unit}</span>
        <p id="${id}-problem" class="problem" ?hidden=${problem === ''}>${problem}</p>
      </div>`;
  }

  function select(id: string, words: Word, options: readonly (readonly [string, string])[], chosen: string, choose: (value: string) => void) {
    return html`<div class="field choice"><label for=${id}>${say(words)}</label>
      <select id=${id} @change=${(event: Event) => choose((event.target as HTMLSelectElement).value)}>${options.map(([value, its]) =>
        html`<option value=${value} .selected=${value === chosen}>${its}</option>`)}</select></div>`;
  }

  function draw(): void {
    const { scene, material, balls, lift, vibration } = inputs;
    const counts = (from: number, to: number) => range(from, to + 1).map((count) => [count, String(count)] as const);
    const example = examples.find(([, its]) => toAddress(its) === toAddress(inputs))?.[0] ?? '';
    const reset = (next: CradleInputs): void => {
      problems.clear();
      take(next);
    };
    render(html`
      ${select('example', 'form.example', [['', say('form.own')], ...examples.map(([word]) => [word, say(word)] as const)], example,
        (word) => reset(examples.find(([each]) => each === word)?.[1] ?? inputs))}
      ${segments('scene', say('cradle.scene'), scenes.map((each) => [each, say(sceneWords[each])] as const), scene,
        (next) => reset(startOf(next)))}
      ${scene === 'cradle' ? html`
        <fieldset><legend>${say('cradle.count')}</legend>
          ${segments('balls', say('cradle.count'), counts(fewestBalls, mostBalls), balls, (next) => take(withBalls(inputs, next)))}
        </fieldset>
        <fieldset><legend>${say('cradle.lift')}</legend>
          ${segments('lift', say('cradle.lift'), counts(1, balls - 1), lift, (next) => take(withBalls(inputs, balls, next)))}
        </fieldset>` : nothing}
      <fieldset><legend>${say(scene === 'drop' ? 'form.drop' : 'form.ball')}</legend>
        ${select('material', 'form.material', materials.map(({ name }) => [name, name] as const), material,
          (name) => take({ ...inputs, material: name }))}
        ${namesOf(inputs).map(number)}
        <p class="note">${say('cradle.speed', { speed: withUnit(speedAt(inputs), 'm/s') })}</p>
        ${scene === 'cradle' ? select('vibration', 'cradle.vibration', leaves.map((each) => [each, say(leaveWords[each])] as const),
          vibration, (each) => take({ ...inputs, vibration: each as CradleInputs['vibration'] })) : nothing}
      </fieldset>`, form);
    // What is being typed stays as it is.
    for (const name of namesOf(inputs)) {
      const input = find(`field-${name}`, HTMLInputElement);
      if (!problems.has(name) && !standsFor(input.value, 'speed', shownOf(name))) input.value = displayed(shownOf(name));
    }
  }

  form.addEventListener('submit', (event) => event.preventDefault());
  draw();
  return {
    /** Show inputs that come from the address. */
    show(next: CradleInputs): void {
      problems.clear();
      inputs = next;
      draw();
    },
  };
}
