// What was typed, checked: the core says what is wrong with a number, the page at which field.
import { numberOf, relaxationOf, requireMotion, requireSpeed, unitsOf } from '../core/local';
import { CoreError, type Encounter, type Motion } from '../core/protocol';
import { significant } from '../drawing/numbers';
import { say } from '../drawing/words';
import { ball, encounterOf, meetingOf, unitBody } from './document';
import {
  type Field, type PlacedField, type Value, fieldsOf, measureOf, ofSecond, owner, placedFieldsOf, shownOf, textOf, valueOf,
  withValue, wordsOf,
} from './fields';
import { type Impact, type Inputs, defaults, isOblique, motionOf } from './inputs';
import { type Relaxation, sizeOf } from './kinds';

/** What a text stands for, or in one line what is wrong with it. */
export type Parsed<Its = number> = { value: Its } | { problem: string };

/** Read one decimal number, as in 0.33 or 1e-4; everything else gives a reason. */
export function parseNumber(name: string, text: string): Parsed {
  const typed = text.trim().replaceAll('\u2212', '-');
  if (/^[+-]?\d*,\d+(e[+-]?\d+)?$/i.test(typed)) {
    return { problem: say('check.comma', { name, got: brief(typed), point: brief(typed.replace(',', '.')) }) };
  }
  let value = 0;
  const refused = refusal(() => (value = numberOf(name, typed) || 0)); // not −0
  return refused ? { problem: refused.message } : { value };
}

/** Read a relaxation as the command has it: 0.5:1+0.2:10; none of an empty text. */
export function parseRelaxation(name: string, text: string): Parsed<Relaxation> {
  let value: Relaxation = [];
  const refused = text.trim() === '' ? undefined : refusal(() => (value = relaxationOf(name, text.trim())));
  return refused ? { problem: refused.message } : { value };
}

/** Whether a text, which somebody types, stands for what a field has. */
export function standsFor(text: string, field: Field, value: Value): boolean {
  if (typeof value === 'number') return text.trim() !== '' && (Number(text) === value || text === textOf(value));
  const parsed = parseRelaxation(field, text);
  return 'value' in parsed && textOf(parsed.value) === textOf(value);
}

/** The beginning of what may be long. */
export function brief(text: string): string {
  return text.length > 24 ? `${text.slice(0, 24)}…` : text;
}

/** The inputs that all fields which count stand for, and one line for every field that is wrong. A field whose text is
 *  missing, or not a number, keeps its number. */
export function check(inputs: Inputs, texts: ReadonlyMap<Field, string>) {
  const problems = new Map<Field, string>();
  let next = inputs;
  for (const field of fieldsOf(inputs)) {
    const text = texts.get(field);
    if (text === undefined || text === textOf(shownOf(inputs, field))) continue;
    const measure = measureOf(inputs, field);
    const name = measure ? say(measure.words) : fullName(inputs.encounter, field);
    const parsed: Parsed<Value> = owner(field)?.name === 'relaxation' ? parseRelaxation(name, text) : parseNumber(name, text);
    if ('problem' in parsed) {
      problems.set(field, parsed.problem);
      continue;
    }
    const value = measure ? measure.meant(parsed.value as number) : parsed.value;
    if (owner(field) === undefined) next = { ...next, [field]: value };
    else next = { ...next, encounter: withValue(next.encounter, field as PlacedField, value) };
  }
  for (const [field, problem] of problemsOf(next)) if (!problems.has(field)) problems.set(field, problem);
  return { inputs: next, problems };
}

/** What the core refuses, by field. */
export function problemsOf(inputs: Inputs): Map<Field, string> {
  const { encounter, problems } = repaired(inputs.encounter);
  // Of a material that is wrong, c is not known.
  const wrong = problems.size === 0 || !meetingOf(encounter).si ? motionProblem({ ...inputs, encounter }) : undefined;
  return wrong === undefined ? problems : problems.set(...wrong);
}

/** What is wrong first with how they meet; undefined if nothing. */
export function motionProblem(inputs: Impact): [keyof Motion, string] | undefined {
  const { encounter, speed } = inputs;
  const refused = refusal(() => requireSpeed(encounter, speed)) ??
    (isOblique(inputs) ? refusal(() => requireMotion(encounter, motionOf(inputs))) : undefined);
  if (refused === undefined) return undefined;
  const name = nameIn(refused);
  const field = name === 'tangential' ? 'angle' : (name as keyof Motion); // of which it is made
  return [field, problemOf(encounter, field, refused)];
}

/** An encounter that the core takes, and what of the given one it refuses, by field. It names one number at a time: the
 *  next is found with a default in its place, or in place of all of a body whose numbers do not go together. */
export function repaired(encounter: Encounter): { encounter: Encounter; problems: Map<Field, string> } {
  const problems = new Map<Field, string>();
  const usual = standard(encounter);
  let right = encounter;
  for (let refused = refusal(() => unitsOf(right)); refused; refused = refusal(() => unitsOf(right))) {
    const field = fieldOf(right, refused);
    if (field !== undefined && !problems.has(field)) {
      problems.set(field, problemOf(right, field, refused));
      right = withValue(right, field, valueOf({ ...defaults, encounter: usual }, field));
      continue;
    }
    if (field === undefined) problems.set('speed', refused.message);
    right = right.against === usual.against ? usual : { ...right, against: usual.against! };
  }
  return { encounter: right, problems };
}

/** The same encounter with default numbers; what it meets is an identical body. */
function standard(encounter: Encounter): Encounter {
  const its = meetingOf(encounter);
  return encounterOf(its, its.si ? ball : unitBody, its.si ? its.first.body : unitBody);
}

/** With what the core refuses what it is asked; undefined if it does not. */
export function refusal(ask: () => unknown): CoreError | undefined {
  try {
    ask();
    return undefined;
  } catch (error) {
    if (error instanceof CoreError) return error;
    throw error;
  }
}

/** The name of the input that is refused; '' of what failed otherwise. */
const nameIn = (refused: CoreError): string => refused.refusal?.name ?? '';

/** What a refusal is about: the number that it names, or the size of a second body that does not go with the first. */
function fieldOf(encounter: Encounter, refused: CoreError): PlacedField | undefined {
  const name = nameIn(refused);
  const own = name.replace(/^against ?| ratio$/g, '');
  const size = own === 'impedance' ? 'area' : sizeOf(meetingOf(encounter).kind);
  const fields = placedFieldsOf(encounter);
  const wanted = own === name ? [own] : [`${own}2`, ofSecond(size)];
  return (wanted as PlacedField[]).find((field) => fields.includes(field));
}

/** A refusal with the page's name for the number, and no more digits than a reader needs. */
function problemOf(encounter: Encounter, field: Field, refused: CoreError): string {
  const name = nameIn(refused);
  const hint = name.endsWith('ratio') ? `, ${name}` : '';
  const short = refused.message.slice(name.length + 1)
    .replace(/\d+\.\d{6,}(e-?\d+)?|\d+(\.\d+)?e-0\d/g, (number) => significant(Number(number), 6));
  return `${fullName(encounter, field)}${hint}:${short}`;
}

function fullName(encounter: Encounter, field: Field): string {
  const { name } = wordsOf(encounter, field);
  return owner(field)?.second ? say('check.second', { name }) : name;
}
