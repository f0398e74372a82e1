// All inputs in the address of the page, in short readable keys: ?body=sphere&nu=0.3&v=0.01&against=half-space&nu2=0.2
import type { Against, Body, BodyKind, Encounter } from '../core/protocol';
import { problemsOf } from './check';
import { type BodyField, bodyFields, fieldsOf, ofSecond, valueOf } from './fields';
import { type Inputs, defaults, mostKept, unitBody, withSecond } from './inputs';
import { parseNumber, shortest } from './number';

const keys: Record<BodyField, string> = {
  poisson: 'nu', young: 'E', density: 'rho', radius: 'R', area: 'A', lossTime: 'eta',
};
const kinds: readonly BodyKind[] = ['disk', 'sphere', 'rod'];
const partners: readonly Against['kind'][] = ['wall', 'same', 'body', 'half-space'];

/** The inputs as text after ? in the address. */
export function toAddress(inputs: Inputs): string {
  const kept = inputs.kept.map((encounter) => `keep=${pairsOf(encounter).map((pair) => pair.join(':')).join(',')}`);
  const own = [...pairsOf(inputs.encounter), ['v', shortest(inputs.speed)]].map((pair) => pair.join('='));
  return [...own, ...kept].join('&');
}

/** The inputs that an address holds, and in one line what was wrong with it ('' if nothing). */
export function fromAddress(text: string): { inputs: Inputs; problem: string } {
  const body = text.replace(/^[#?]/, '');
  if (body === '') return { inputs: defaults, problem: '' };
  try {
    const parts = body.split('&').filter((part) => part !== '');
    const kept = parts.filter((part) => part.startsWith('keep=')).map((part) => decode(part.slice(5)));
    const rest = parts.filter((part) => !part.startsWith('keep='));
    const pairs = pairsFrom(rest, '=');
    const v = pairs.get('v');
    if (v === undefined) throw new Error('v: got none, allowed a speed');
    pairs.delete('v');
    const encounter = encounterFrom(pairs);
    const inputs = checked({ encounter, speed: number('v', v), kept: [] });
    if (kept.length > mostKept) throw new Error(`keep: got ${kept.length} curves, allowed ${mostKept}`);
    const others = kept.map((item) => encounterFrom(pairsFrom(item.split(','), ':')));
    for (const other of others) checked({ encounter: other, speed: 1e-3 * slowest(other), kept: [] });
    return { inputs: { ...inputs, kept: others }, problem: '' };
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return { inputs: defaults, problem: `The link is not readable, so this is the default. ${reason}` };
  }
}

/** A speed that every encounter allows: its own unit of speed. */
function slowest(encounter: Encounter): number {
  return encounter.si ? Math.sqrt(encounter.first.young / encounter.first.density) : 1;
}

function pairsOf(encounter: Encounter): [string, string][] {
  const { kind, si, plane, against } = encounter;
  const pairs: [string, string][] = [['body', kind]];
  if (si) pairs.push(['units', 'SI']);
  if (si && kind === 'disk' && plane === 'strain') pairs.push(['plane', plane]);
  const fields = fieldsOf(encounter);
  const add = (field: BodyField, second: boolean): void => {
    const name = second ? ofSecond(field) : field;
    const value = valueOf(encounter, 0, name);
    if (!fields.includes(name) || (field === 'lossTime' && value === 0)) return;
    pairs.push([second ? `${keys[field]}2` : keys[field], shortest(value)]);
  };
  for (const field of bodyFields) add(field, false);
  if (against.kind !== 'wall') pairs.push(['against', against.kind]);
  for (const field of bodyFields) add(field, true);
  return pairs;
}

function pairsFrom(parts: readonly string[], between: string): Map<string, string> {
  const pairs = new Map<string, string>();
  for (const part of parts) {
    const at = part.indexOf(between);
    const key = at < 0 ? part : part.slice(0, at);
    if (at < 0 || pairs.has(key)) throw new Error(`${brief(key)}: ${at < 0 ? 'has no value' : 'given twice'}`);
    pairs.set(key, decode(part.slice(at + 1)));
  }
  return pairs;
}

function encounterFrom(pairs: Map<string, string>): Encounter {
  const take = (key: string): string | undefined => {
    const value = pairs.get(key);
    pairs.delete(key);
    return value;
  };
  const kind = word('body', take('body') ?? 'disk', kinds);
  const si = word('units', take('units') ?? 'c', ['c', 'SI']) === 'SI';
  const plane = word('plane', take('plane') ?? 'stress', ['stress', 'strain'] as const);
  const partner = word('against', take('against') ?? 'wall', partners);
  if (kind === 'rod' && partner === 'half-space') throw new Error('against: got half-space, allowed wall, same, body');
  const against: Against =
    partner === 'wall' || partner === 'same' ? { kind: partner } : { kind: partner, body: unitBody };
  const encounter: Encounter = { kind, si, plane, first: unitBody, against };
  const fields = fieldsOf(encounter);
  const fill = (second: boolean): Body => {
    const body: Body = { ...unitBody };
    for (const field of bodyFields) {
      const key = second ? `${keys[field]}2` : keys[field];
      if (!fields.includes(second ? ofSecond(field) : field)) continue;
      const text = take(key);
      if (text !== undefined) body[field] = number(key, text);
      else if (field !== 'lossTime') throw new Error(`${key}: got none, allowed a number`);
    }
    return body;
  };
  const filled = withSecond({ ...encounter, first: fill(false) }, () => fill(true));
  const [left] = pairs.keys();
  if (left !== undefined) throw new Error(`${brief(left)}: not a known key`);
  return filled;
}

function word<Word extends string>(key: string, value: string, allowed: readonly Word[]): Word {
  const found = allowed.find((item) => item === value);
  if (found === undefined) throw new Error(`${key}: got “${brief(value)}”, allowed ${allowed.join(', ')}`);
  return found;
}

function number(key: string, text: string): number {
  const parsed = parseNumber(key, text);
  if ('problem' in parsed) throw new Error(parsed.problem);
  return parsed.value;
}

function checked(inputs: Inputs): Inputs {
  const [problem] = problemsOf(inputs).values();
  if (problem !== undefined) throw new Error(problem);
  return inputs;
}

function decode(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    throw new Error(`${brief(text)}: not readable`);
  }
}

function brief(text: string): string {
  return text.length > 24 ? `${text.slice(0, 24)}…` : text;
}
