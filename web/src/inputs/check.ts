// What was typed, checked: the core says what is wrong with a number, the page at which field.
import { requireSpeed, unitsOf } from '../core/local';
import { CoreError, type Encounter } from '../core/protocol';
import { type Field, fieldsOf, nameOf, ofSecond, owner, valueOf, withValue } from './fields';
import { type Inputs, ball, unitBody, withSecond } from './inputs';
import { type BodyField, sizeOf } from './kinds';
import { displayed, parseNumber } from './number';

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

/** What the core refuses, by field. It names one number at a time: the next is found with a default in its place. */
export function problemsOf({ encounter, speed }: Inputs): Map<Field, string> {
  const problems = new Map<Field, string>();
  const repaired = standard(encounter);
  let tried = encounter;
  for (let left = fieldsOf(encounter).length; left > 0; --left) {
    const line = refusal(() => unitsOf(tried));
    if (line === '') break;
    const field = fieldOf(tried, line);
    if (field === undefined || field === 'speed' || problems.has(field)) {
      tried = repaired;
      if (field === undefined) problems.set('speed', line);
    } else {
      problems.set(field, problemOf(tried, field, line));
      tried = withValue(tried, field, valueOf(repaired, 0, field));
    }
  }
  // Of a material that is wrong, c is not known.
  const line = problems.size === 0 || !encounter.si ? refusal(() => requireSpeed(tried, speed)) : '';
  if (line !== '') problems.set('speed', problemOf(tried, 'speed', line));
  return problems;
}

/** The same encounter with default numbers; what it meets is an identical body. */
export function standard(encounter: Encounter): Encounter {
  const body = encounter.si ? ball : unitBody;
  return withSecond({ ...encounter, first: body }, () => (encounter.si ? encounter.first : unitBody));
}

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
function fieldOf(encounter: Encounter, line: string): Field | undefined {
  const [, second, name] = /^(against )?(\w+)/.exec(line) ?? [];
  const own = name === 'loss' ? 'loss_time' : name;
  const size = sizeOf(encounter.kind);
  const aliases: Record<string, BodyField> = { transit: size, impedance: 'area', against: size };
  const field = aliases[own ?? ''] ?? (own as BodyField);
  const ratio = /^[\w ]+ ratio:/.test(line) || line.startsWith('against');
  const wanted = second || ratio ? ofSecond(field) : field;
  return fieldsOf(encounter).find((each) => each === wanted);
}

/** A refusal with the page's name for the number. */
export function problemOf(encounter: Encounter, field: Field, line: string): string {
  const [subject = '', ...rest] = line.split(':');
  const hint = subject.endsWith('ratio') ? `, ${subject}` : '';
  return `${fullName(encounter, field)}${hint}:${rest.join(':')}`;
}

function fullName(encounter: Encounter, field: Field): string {
  return `${nameOf(encounter, field)}${owner(field)?.second ? ' of what it meets' : ''}`;
}
