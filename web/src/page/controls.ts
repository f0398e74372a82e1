// The form: it shows the inputs, and tells what the user makes of them.
import { html, render } from 'lit-html';
import { find, optionsOf } from '../drawing/dom';
import { significant, withUnit } from '../drawing/numbers';
import { check, refusal } from '../inputs/check';
import { say } from '../drawing/words';
import { type Choice, encounterOf, madeOf, meetingOf, withBody } from '../inputs/document';
import { type Field, fieldsOf, hasLossOrFace } from '../inputs/fields';
import { openFile, titleOf, withFile } from '../inputs/files';
import {
  type Inputs, dropOf, isBall, presetOf, presets, withAgainst, withKind, withPreset,
} from '../inputs/inputs';
import { type BodyKind, blockOf, blocks, bodyKinds, fileKind, kindNamed, materials, sizeOf, wordOf } from '../inputs/kinds';
import { description } from '../inputs/lines';
import { barSpeed, placeOf, speedAt, steps, withoutSi, withSi } from '../inputs/units';
import { showFields, showNumbers, textOf } from './form_fields';
import { createTabs, showView } from './tabs';

/** What the form reports: inputs that hold, while a drag or typing goes on or at its end; or that some are wrong. */
export interface Listener {
  changed(inputs: Inputs, settled: boolean): void;
  wrong(): void;
}

const own = '';

/** Wire the form of index.html. */
export function createControls(initial: Inputs, listener: Listener) {
  let inputs = initial;
  const form = find('inputs', HTMLFormElement);
  const slider = find('speed-slider', HTMLInputElement);
  const partner = find('against', HTMLSelectElement);
  const selects = { first: find('material', HTMLSelectElement), second: find('material2', HTMLSelectElement) };
  const preset = find('preset', HTMLSelectElement);
  const simple = find('simple', HTMLInputElement);
  slider.max = String(steps);
  render(bodyKinds.map((kind) => html`<label title=${kindNamed(kind).help}>
    <input type="radio" name="body" value=${kind} /><span>${kind.charAt(0).toUpperCase() + wordOf(kind).slice(1)}</span>
  </label>`).concat(html`<label title=${fileKind.help}>
    <input type="file" id="file" accept=".json" aria-label=${say('form.file1')} data-waits disabled /><span>${say('form.file')}</span>
  </label>`), find('bodies', HTMLElement));
  const ownNumbers = [own, say('form.own')] as const;

  function show(next: Inputs): void {
    inputs = next;
    const { encounter } = inputs;
    const { kind, si, plane, against, first, second } = meetingOf(encounter);
    const [file, file2, asBall] = [first.file, second?.file, inputs.view === 'ball'];
    render(optionsOf([ownNumbers, ...presets.filter((each) => !asBall || isBall(each.encounter))
      .map(({ name }) => [name, say(name)] as const)]), preset);
    for (const select of Object.values(selects)) {
      render(optionsOf([...(asBall ? [] : [ownNumbers]), ...materials.map(({ name }) => [name, name] as const)]), select);
    }
    choose('body', file ? '' : kind);
    for (const [id, its] of [['file', file], ['file2', file2]] as const) {
      find(id, HTMLInputElement).parentElement!.classList.toggle('chosen', its !== undefined);
    }
    find('file-problem', HTMLElement).hidden = true;
    choose('units', si ? 'SI' : 'c');
    choose('plane', plane);
    simple.checked = inputs.view === 'simple';
    showView(inputs.view);
    if ((asBall && inputs.friction !== 0) || hasLossOrFace(encounter)) find('more', HTMLDetailsElement).open = true;
    find('plane-row', HTMLElement).hidden = !(si && kindNamed(kind).hasPlane);
    find('material-row', HTMLElement).hidden = !si || file !== undefined;
    find('material2-row', HTMLElement).hidden = !si || second === undefined || file2 !== undefined;
    render(optionsOf(asBall
      ? [['half-space', say('form.thick')], ['plate', say('form.plate')], ['same', say('form.same_ball')]]
      : [
        ['wall', say('form.wall')], ['same', say('form.same')],
        ['body', file2 ? `“${titleOf(file2)}”` : say('form.other', { kind: wordOf(kind) })],
        ...blocks.flatMap((name): [string, string][] => {
          const block = blockOf(kind, name);
          return block ? [[name, say('form.block', { name: block.name })]] : [];
        }),
      ]), partner);
    partner.value = against;
    showFields(inputs, new Map());
    showNumbers(inputs);
    showDerived();
  }

  /** Show what follows from the numbers. */
  function showDerived(): void {
    const { encounter, speed, view } = inputs;
    const { si, kind, first, second } = meetingOf(encounter);
    const asBall = view === 'ball';
    preset.value = presetOf(inputs)?.name ?? own;
    find('who', HTMLElement).textContent = description(encounter);
    for (const [select, side] of [[selects.first, first], [selects.second, second]] as const) {
      select.value = (asBall ? side?.solid : side?.material)?.name ?? own;
      select.title = side?.material?.source ?? '';
    }
    const title = first.file ? `“${titleOf(first.file)}”, ` : '';
    find('units-note', HTMLElement).textContent = si ? `${title}c = √(E/ρ) = ${significant(barSpeed(encounter), 4)} m/s`
      : say('form.units_note', { size: sizeOf(kind) });
    slider.value = String(placeOf(encounter, speed, view));
    slider.ariaLabel = say(asBall ? 'form.drop_slider' : 'form.slider');
    slider.ariaValueText = asBall ? withUnit(dropOf(speed), 'm') : `${significant(speed, 3)} ${si ? 'm/s' : 'c'}`;
  }

  /** Take over inputs that a choice or a slider made; they are in range unless a field already was not. */
  function take(next: Inputs, settled: boolean): void {
    show(next);
    read(settled);
  }

  /** Check all fields, and report. */
  function read(settled: boolean): void {
    const texts = new Map(fieldsOf(inputs).map((field) => [field, textOf(field)]));
    const { inputs: next, problems } = check(inputs, texts);
    showFields(inputs, problems);
    if (problems.size > 0) {
      listener.wrong();
      return;
    }
    inputs = next;
    showFields(inputs, problems); // friction brings more of them
    showNumbers(inputs);
    showDerived();
    listener.changed(inputs, settled);
  }

  const withMaterial = (name: string, second: boolean): Inputs => {
    const material = materials.find((each) => each.name === name);
    const side = meetingOf(inputs.encounter)[second ? 'second' : 'first']!;
    return material === undefined ? inputs
      : { ...inputs, encounter: withBody(inputs.encounter, second, madeOf(material, side.body)) };
  };
  /** What a choice makes of the inputs, by the ids and names of index.html. */
  const choices: Record<string, (value: string) => Inputs> = {
    preset: (value) => withPreset(inputs, value),
    against: (value) => ({ ...inputs, encounter: withAgainst(inputs.encounter, value as Choice['against']) }),
    material: (value) => withMaterial(value, false),
    material2: (value) => withMaterial(value, true),
    body: (value) => ({ ...inputs, encounter: withKind(inputs.encounter, value as BodyKind) }),
    units: (value) => (value === 'SI' ? withSi(inputs) : withoutSi(inputs)),
    plane(value) {
      const { first, second, ...choice } = meetingOf(inputs.encounter);
      const changed = { ...choice, plane: value as Choice['plane'] };
      return { ...inputs, encounter: encounterOf(changed, first.body, second?.body) };
    },
  };
  async function open({ id, files }: HTMLInputElement): Promise<void> {
    const chosen = files?.[0];
    if (!chosen) return;
    const problem = find('file-problem', HTMLElement);
    const text = await chosen.text();
    problem.textContent = refusal(() => take(withFile(inputs, id === 'file2', openFile(chosen.name, text)), true))?.message ?? '';
    problem.hidden = problem.textContent === '';
  }

  const isNumber = (target: EventTarget | null): boolean =>
    target === slider || (target instanceof HTMLInputElement && target.dataset.field !== undefined);

  form.addEventListener('submit', (event) => event.preventDefault());
  form.addEventListener('input', ({ target }) => {
    if (target === slider) take({ ...inputs, speed: speedAt(inputs.encounter, Number(slider.value), inputs.view) }, false);
    else if (isNumber(target)) read(false);
  });
  form.addEventListener('change', ({ target }) => {
    if (isNumber(target)) {
      read(true);
      return;
    }
    if (target instanceof HTMLInputElement && target.type === 'file') {
      void open(target).finally(() => (target.value = '')); // so that the same file can be opened again
      return;
    }
    const { id, name, value } = target as HTMLInputElement | HTMLSelectElement;
    const change = choices[name || id];
    if (change) take(change(value), true);
  });
  simple.addEventListener('change', () => take({ ...inputs, view: simple.checked ? 'simple' : 'full' }, true));
  createTabs(() => inputs, (next) => take(next, true));

  function choose(name: string, value: string): void {
    for (const radio of form.querySelectorAll<HTMLInputElement>(`input[name="${name}"]`)) {
      radio.checked = radio.value === value;
    }
  }

  show(inputs);
  return {
    /** Show inputs that come from elsewhere: the address, the curve. */
    show,
    /** Check all that is typed. */
    check: (): void => read(true),
    /** What the core says is wrong with a field. */
    refuse: (field: Field, problem: string): void => showFields(inputs, new Map([[field, problem]])),
  };
}
