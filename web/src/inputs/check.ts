// What was typed, checked: the core says what is wrong with a number, the page at which field.
import { numberOf, requireSpeed, unitsOf } from '../core/local';
import { CoreError, type Encounter } from '../core/protocol';
import { displayed, significant } from '../drawing/numbers';
import { type Field, fieldsOf, ofSecond, owner, valueOf, withValue, wordsOf } from './fields';
import { type Inputs, ball, unitBody } from './inputs';
import { type BodyField, sizeOf } from './kinds';

/** A number, or in one line what is wrong with the text. */
export type Parsed = { value: number } | { problem: string };

/** Read one decimal number, as in 0.33 or 1e-4; everything else gives a reason. */
export function parseNumber(name: string, text: string): Parsed {
  const typed = text.trim().replaceAll('\u2212', '-');
  if (/^[+-]?\d*,\d+(e[+-]?\d+)?$/i.test(typed)) {
    return { problem: `${name}: got “${typed}”, write it with a point: ${typed.replace(',', '.')}` };
  }
  let value = 0;
  const problem = refusal(() => (value = numberOf(name, typed) || 0)); // not −0
  return problem === '' ? { value } : { problem };
}

/** The new inputs, or for every wrong field one line that says what is wrong. */
export type Checked = { inputs: Inputs } | { problems: Map<Field, string> };

/** Read all fields that count; a field whose text is missing keeps its number. */
export function check(inputs: Inputs, texts: ReadonlyMap<Field, string>): Checked {
  const problems = new Map<Field, string>();
  let { encounter, speed } = inputs;
  for (const field of fieldsOf(encounter)) {
    const text = texts.get(field);
    if (text === undefined || text === displayed(valueOf(encounter, speed, field))) continue;
    const parsed = parseNumber(fullName(encounter, field), text);
    if ('problem' in parsed) problems.set(field, parsed.problem);
    else if (field === 'speed') speed = parsed.value;
    else encounter = withValue(encounter, field, parsed.value);
  }
  const next = { ...inputs, encounter, speed };
  for (const [field, problem] of problemsOf(next)) if (!problems.has(field)) problems.set(field, problem);
  return problems.size > 0 ? { problems } : { inputs: next };
}

/** What the core refuses, by field. */
export function problemsOf({ encounter, speed }: Inputs): Map<Field, string> {
  const right = repaired(encounter);
  // Of a material that is wrong, c is not known.
  const line = right.problems.size === 0 || !encounter.si ? speedProblem(right.encounter, speed) : '';
  return line === '' ? right.problems : right.problems.set('speed', line);
}

/** What is wrong with a speed; '' if nothing. */
export function speedProblem(encounter: Encounter, speed: number): string {
  const line = refusal(() => requireSpeed(encounter, speed));
  return line && problemOf(encounter, 'speed', line);
}

/** An encounter that the core takes, and what of the given one it refuses, by field. It names one number at a time: the
 *  next is found with a default in its place, or in place of all of a body whose numbers do not go together. */
export function repaired(encounter: Encounter): { encounter: Encounter; problems: Map<Field, string> } {
  const problems = new Map<Field, string>();
  const usual = standard(encounter);
  let right = encounter;
  for (let line = refusal(() => unitsOf(right)); line !== ''; line = refusal(() => unitsOf(right))) {
    const field = fieldOf(right, line);
    if (field !== undefined && !problems.has(field)) {
      problems.set(field, problemOf(right, field, line));
      right = withValue(right, field, valueOf(usual, 0, field));
      continue;
    }
    if (field === undefined) problems.set('speed', line);
    right = right.second === usual.second ? usual : { ...right, second: usual.second };
  }
  return { encounter: right, problems };
}

/** The same encounter with default numbers; what it meets is an identical body. */
function standard(encounter: Encounter): Encounter {
  const body = encounter.si ? ball : unitBody;
  return { ...encounter, first: body, second: encounter.si ? encounter.first : unitBody };
}

/** The line with which the core refuses what it is asked; '' if it does not. */
function refusal(ask: () => unknown): string {
  try {
    ask();
    return '';
  } catch (error) {
    if (error instanceof CoreError) return error.message;
    throw error;
  }
}

/** What a refusal is about: the number that it names, or the size of a second body that does not go with the first. */
function fieldOf(encounter: Encounter, line: string): Exclude<Field, 'speed'> | undefined {
  const [, second, name] = /^(against )?(\w+)/.exec(line) ?? [];
  const own = name === 'loss' ? 'loss_time' : name;
  const size = sizeOf(encounter.kind);
  const aliases: Record<string, BodyField> = { transit: size, impedance: 'area', against: size };
  const field = aliases[own ?? ''] ?? (own as BodyField);
  const ratio = /^[\w ]+ ratio:/.test(line) || line.startsWith('against');
  const wanted = second || ratio ? ofSecond(field) : field;
  return fieldsOf(encounter).includes(wanted) ? wanted : undefined;
}

/** A refusal with the page's name for the number, and no more digits than a reader needs. */
function problemOf(encounter: Encounter, field: Field, line: string): string {
  const [subject = '', ...rest] = line.split(':');
  const hint = subject.endsWith('ratio') ? `, ${subject}` : '';
  const short = rest.join(':').replace(/\d+\.\d{6,}(e-?\d+)?|\d+e-0\d/g, (number) => significant(Number(number), 6));
  return `${fullName(encounter, field)}${hint}:${short}`;
}

function fullName(encounter: Encounter, field: Field): string {
  return `${wordsOf(encounter, field).name}${owner(field)?.second ? ' of what it meets' : ''}`;
}
