// All inputs in the address of the page, in short readable keys: ?body=sphere&nu=0.3&v=0.01&against=half-space&nu2=0.2
import type { Against, Body, Encounter } from '../core/protocol';
import { repaired, speedProblem } from './check';
import { type Side, fieldsOfBody, sidesOf } from './document';
import { names } from './fields';
import { type Inputs, ball, defaults, mostKept, siSpeed, unitBody, withSecond } from './inputs';
import { type BodyField, type BodyKind, type Kind, blockOf, bodyKinds, kindNamed } from './kinds';
import { parseNumber, shortest } from './number';
import { barSpeed } from './units';

const keyOf = (field: BodyField, second: boolean): string => names[field][2] + (second ? '2' : '');
const fields = Object.keys(names) as BodyField[];
const known = new Set(['body', 'units', 'plane', 'v', ...fields.map((field) => keyOf(field, false)), 'against',
  ...fields.map((field) => keyOf(field, true)), 'view']);

/** The inputs as text after ? in the address. */
export function toAddress(inputs: Inputs): string {
  const kept = inputs.kept.map((encounter) => `keep=${pairsOf(encounter).map((pair) => pair.join(':')).join(',')}`);
  const own = [...pairsOf(inputs.encounter), ['v', shortest(inputs.speed)]].map((pair) => pair.join('='));
  return [...own, ...(inputs.simple ? ['view=simple'] : []), ...kept].join('&');
}

/** The inputs that an address holds, and in one line what of it was left out ('' if nothing): what is right counts,
 *  and what is not is that of the default. */
export function fromAddress(text: string): { inputs: Inputs; problem: string } {
  const body = text.replace(/^[#?]/, '');
  if (body === '') return { inputs: defaults, problem: '' };
  const problems: string[] = [];
  const parts = body.split('&').filter((part) => part !== '');
  const reader = readerOf(parts.filter((part) => !part.startsWith('keep=')), '=', problems);
  const encounter = inRange(encounterFrom(reader), problems);
  const typed = reader.number('v', normalSpeed(encounter));
  const wrong = speedProblem(encounter, typed);
  if (wrong !== '') problems.push(wrong);
  const speed = wrong === '' ? typed : normalSpeed(encounter);
  const simple = reader.word('view', ['full', 'simple']) === 'simple';
  reader.finish();
  const kept = parts.filter((part) => part.startsWith('keep='));
  if (kept.length > mostKept) problems.push(`keep: got ${kept.length} curves, allowed ${mostKept}`);
  const others = kept.slice(0, mostKept).flatMap((part) => keptFrom(part.slice('keep='.length), problems));
  return { inputs: { encounter, speed, kept: others, simple }, problem: lineOf(problems) };
}

/** Problems that are told; more of them do not help. */
const mostTold = 3;

function lineOf(problems: readonly string[]): string {
  if (problems.length === 0) return '';
  const more = problems.length - mostTold;
  const told = problems.slice(0, mostTold).join('; ');
  return `The link is used except for this, where the default applies: ${told}${more > 0 ? `; and ${more} more` : ''}.`;
}

/** A curve for comparison; one that is not right as a whole is not shown. */
function keptFrom(text: string, problems: string[]): Encounter[] {
  const wrong: string[] = [];
  const reader = readerOf(decoded(text).split(','), ':', wrong);
  const encounter = encounterFrom(reader);
  reader.finish();
  inRange(encounter, wrong);
  if (wrong.length === 0) return [encounter];
  problems.push(`keep: ${wrong[0]}`);
  return [];
}

/** The same encounter with the default for what the core refuses. */
function inRange(encounter: Encounter, problems: string[]): Encounter {
  const right = repaired(encounter);
  problems.push(...right.problems.values());
  return right.encounter;
}

/** The default speed, which must be one that the material of a link allows. */
function normalSpeed(encounter: Encounter): number {
  if (!encounter.si) return defaults.speed;
  const c = barSpeed(encounter);
  return Number(Math.min(Math.max(siSpeed, 1e-7 * c), 0.1 * c).toPrecision(3));
}

function pairsOf(encounter: Encounter): [string, string][] {
  const { kind, si, against } = encounter;
  const [first, second] = sidesOf(encounter);
  const numbers = ({ body, fields: its, second: other }: Side): [string, string][] =>
    its.filter((name) => name !== 'loss_time' || body[name] !== 0)
      .map((name) => [keyOf(name, other), shortest(body[name])]);
  return [
    ['body', kind],
    ...(si ? [['units', 'SI']] as [string, string][] : []),
    ...(first.strain ? [['plane', 'strain']] as [string, string][] : []),
    ...numbers(first),
    ...(against.kind !== 'wall' ? [['against', against.kind]] as [string, string][] : []),
    ...(second ? numbers(second) : []),
  ];
}

/** Takes the values of an address by their keys; what is wrong with them goes to `problems`. */
interface Reader {
  word<Word extends string>(key: string, allowed: readonly [Word, ...Word[]]): Word;
  /** `without`: without the key; a missing one is a problem unless that is 0 */
  number(key: string, without: number): number;
  /** Complains of keys that nobody has asked for. */
  finish(): void;
}

function readerOf(parts: readonly string[], between: string, problems: string[]): Reader {
  const pairs = new Map<string, string>();
  for (const part of parts) {
    const at = part.indexOf(between);
    const key = brief(at < 0 ? part : part.slice(0, at));
    if (at < 0) problems.push(`${key}: got no value`);
    else if (pairs.has(key)) problems.push(`${key}: got twice, allowed once`);
    else pairs.set(key, decoded(part.slice(at + 1)));
  }
  const take = (key: string): string | undefined => {
    const value = pairs.get(key);
    pairs.delete(key);
    return value;
  };
  return {
    word(key, allowed) {
      const value = take(key) ?? allowed[0];
      const found = allowed.find((item) => item === value);
      if (found === undefined) problems.push(`${key}: got “${brief(value)}”, allowed ${allowed.join(', ')}`);
      return found ?? allowed[0];
    },
    number(key, without) {
      const text = take(key);
      if (text === undefined) {
        if (without !== 0) problems.push(`${key}: got none, allowed a number`);
        return without;
      }
      const parsed = parseNumber(key, text);
      if ('value' in parsed) return parsed.value;
      problems.push(parsed.problem);
      return without;
    },
    finish() {
      for (const key of pairs.keys()) {
        problems.push(known.has(key) ? `${key}: got a key that this encounter does not have`
          : `${key}: got an unknown key, allowed ${[...known].join(' ')} keep`);
      }
    },
  };
}

function encounterFrom(reader: Reader): Encounter {
  const kind = reader.word('body', bodyKinds as [BodyKind, ...BodyKind[]]);
  const si = reader.word('units', ['c', 'SI']) === 'SI';
  const plane = reader.word('plane', ['stress', 'strain']);
  const others = ['wall', 'same', 'body'] as const;
  const partner = reader.word('against', blockOf(kind) ? ([...others, 'half-space'] as const) : others);
  const against: Against =
    partner === 'wall' || partner === 'same' ? { kind: partner } : { kind: partner, body: unitBody };
  const fill = (of: Kind, second: boolean, without: Body): Body => {
    const body: Body = { ...unitBody };
    for (const field of fieldsOfBody(of, si, second)) {
      body[field] = reader.number(keyOf(field, second), field === 'loss_time' ? 0 : without[field]);
    }
    return body;
  };
  const first = fill(kindNamed(kind), false, si ? ball : unitBody);
  const encounter: Encounter = { kind, si, plane, first, against };
  return withSecond(encounter, () => fill(sidesOf(encounter)[1]!.kind, true, si ? first : unitBody));
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

function brief(text: string): string {
  return text.length > 24 ? `${text.slice(0, 24)}…` : text;
}
