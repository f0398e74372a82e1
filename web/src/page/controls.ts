// The form: it shows the inputs, and tells what the user makes of them.
import { html, render } from 'lit-html';
import type { Against, Body } from '../core/protocol';
import { find, optionsOf } from '../drawing/dom';
import { check } from '../inputs/check';
import { description } from '../inputs/description';
import { significant } from '../inputs/digits';
import { madeOf, sidesOf } from '../inputs/document';
import { type Field, fieldsOf } from '../inputs/fields';
import { type Inputs, withAgainst, withKind, withSecond } from '../inputs/inputs';
import { type BodyKind, blockOf, bodyKinds, kindNamed, materials, sizeOf } from '../inputs/kinds';
import { presetOf, presets } from '../inputs/presets';
import { placeOf, speedAt, steps } from '../inputs/speeds';
import { barSpeed, withSi, withoutSi } from '../inputs/units';
import { showFields, showNumbers, textOf } from './fields_view';

export interface Controls {
  /** Show inputs that come from elsewhere: the address, the curve. */
  show(inputs: Inputs): void;
  /** What the core says is wrong with a field. */
  refuse(field: Field, problem: string): void;
}

/** What the form reports: inputs that hold, while a drag or typing goes on or at its end; or that some are wrong. */
export interface Listener {
  changed(inputs: Inputs, settled: boolean): void;
  wrong(): void;
}

const own = 'own numbers';

/** Wire the form of index.html. */
export function createControls(initial: Inputs, listener: Listener): Controls {
  let inputs = initial;
  const form = find('inputs', HTMLFormElement);
  const slider = find('speed-slider', HTMLInputElement);
  const partner = find('against', HTMLSelectElement);
  const selects = { first: find('material', HTMLSelectElement), second: find('material2', HTMLSelectElement) };
  const preset = find('preset', HTMLSelectElement);
  const simple = find('simple', HTMLInputElement);
  slider.max = String(steps);
  render(bodyKinds.map((kind) => html`<label title=${kindNamed(kind).help}>
    <input type="radio" name="body" value=${kind} /><span>${kind.charAt(0).toUpperCase() + kind.slice(1)}</span>
  </label>`), find('bodies', HTMLElement));
  const named = (all: readonly { name: string }[]): unknown =>
    optionsOf([own, ...all.map(({ name }) => name)].map((name) => [name, name]));
  render(named(presets), preset);
  for (const select of Object.values(selects)) render(named(materials), select);

  function show(next: Inputs): void {
    inputs = next;
    const { encounter } = inputs;
    const { kind, si, against } = encounter;
    choose('body', kind);
    choose('units', si ? 'SI' : 'c');
    choose('plane', encounter.plane);
    simple.checked = inputs.simple;
    document.body.dataset.view = inputs.simple ? 'simple' : 'full';
    find('plane-row', HTMLElement).hidden = !(si && kindNamed(kind).hasPlane);
    find('material-row', HTMLElement).hidden = !si;
    find('material2-row', HTMLElement).hidden = !si || sidesOf(encounter)[1] === undefined;
    showPartners(kind, against.kind);
    showNames();
    find('units-note', HTMLElement).textContent = note();
    showFields(inputs, new Map());
    showNumbers(inputs);
    showSlider();
  }

  function showSlider(): void {
    slider.value = String(placeOf(inputs.encounter, inputs.speed));
    slider.setAttribute('aria-valuetext', `${significant(inputs.speed, 3)} ${inputs.encounter.si ? 'm/s' : 'c'}`);
  }

  function showNames(): void {
    const { encounter } = inputs;
    preset.value = presetOf(inputs)?.name ?? own;
    find('who', HTMLElement).textContent = description(encounter);
    const [first, second] = sidesOf(encounter);
    for (const [select, side] of [[selects.first, first], [selects.second, second]] as const) {
      select.value = side?.material?.name ?? own;
      select.title = side?.material?.source ?? '';
    }
  }

  function note(): string {
    const { si, kind } = inputs.encounter;
    const size = sizeOf(kind);
    return si
      ? `c = √(E/ρ) = ${significant(barSpeed(inputs.encounter), 4)} m/s`
      : `Units: ${size}, bar speed c = √(E/ρ) and mass of the first body`;
  }

  /** Take over inputs that a choice or a slider made; they are in range unless a field already was not. */
  function take(next: Inputs, settled: boolean): void {
    show(next);
    read(settled);
  }

  /** Check all fields, and report. */
  function read(settled: boolean): void {
    const texts = new Map(fieldsOf(inputs.encounter).map((field) => [field, textOf(field)]));
    const result = check(inputs, texts);
    const problems = 'problems' in result ? result.problems : new Map<Field, string>();
    showFields(inputs, problems);
    if ('problems' in result) {
      listener.wrong();
      return;
    }
    inputs = result.inputs;
    find('units-note', HTMLElement).textContent = note();
    showSlider();
    showNames();
    listener.changed(inputs, settled);
  }

  form.addEventListener('submit', (event) => event.preventDefault());
  form.addEventListener('input', (event) => {
    const target = event.target;
    if (target === slider) {
      const speed = speedAt(inputs.encounter, Number(slider.value));
      take({ ...inputs, speed }, false);
    } else if (target instanceof HTMLInputElement && target.dataset.field !== undefined) {
      read(false);
    }
  });
  form.addEventListener('change', (event) => {
    const target = event.target;
    const { encounter } = inputs;
    if (target === slider || (target instanceof HTMLInputElement && target.dataset.field !== undefined)) {
      read(true);
    } else if (target === preset) {
      const { encounter: met, speed } = presets.find(({ name }) => name === preset.value) ?? inputs;
      take({ ...inputs, encounter: met, speed }, true);
    } else if (target === partner) {
      take({ ...inputs, encounter: withAgainst(encounter, partner.value as Against['kind']) }, true);
    } else if (target === selects.first || target === selects.second) {
      const material = materials.find(({ name }) => name === (target as HTMLSelectElement).value);
      const made = (body: Body): Body => (material === undefined ? body : madeOf(material, body));
      const next =
        target === selects.first ? { ...encounter, first: made(encounter.first) } : withSecond(encounter, made);
      take({ ...inputs, encounter: next }, true);
    } else if (target instanceof HTMLInputElement && target.name === 'body') {
      take({ ...inputs, encounter: withKind(encounter, target.value as BodyKind) }, true);
    } else if (target instanceof HTMLInputElement && target.name === 'units') {
      take(target.value === 'SI' ? withSi(inputs) : withoutSi(inputs), true);
    } else if (target instanceof HTMLInputElement && target.name === 'plane') {
      take({ ...inputs, encounter: { ...encounter, plane: target.value as 'stress' | 'strain' } }, true);
    }
  });

  simple.addEventListener('change', () => take({ ...inputs, simple: simple.checked }, true));

  function choose(name: string, value: string): void {
    for (const radio of form.querySelectorAll<HTMLInputElement>(`input[name="${name}"]`)) {
      radio.checked = radio.value === value;
    }
  }

  function showPartners(kind: BodyKind, chosen: Against['kind']): void {
    const names: [string, string][] = [
      ['wall', 'a rigid wall'], ['same', 'an identical body'], ['body', `another ${kind}`],
    ];
    const block = blockOf(kind);
    if (block) names.push(['half-space', `an elastic ${block.name}`]);
    render(optionsOf(names), partner);
    partner.value = chosen;
  }

  show(inputs);
  return {
    show,
    refuse: (field, problem) => showFields(inputs, new Map([[field, problem]])),
  };
}
