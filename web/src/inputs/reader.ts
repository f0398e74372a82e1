// The values of an address by their keys, and what is wrong with them.
import { say } from '../drawing/words';
import { brief, parseNumber, parseRelaxation } from './check';
import type { Body } from './document';
import type { Value } from './fields';
import { fileNamed } from './files';
import { type BodyField, isFaceName, isLossName } from './kinds';

/** Takes the values of an address by their keys; what is wrong with them goes to `problems`. */
export class Reader {
  private readonly pairs = new Map<string, string>();

  constructor(parts: readonly string[], between: string, private readonly problems: string[]) {
    for (const part of parts) {
      const at = part.indexOf(between);
      const key = brief(at < 0 ? part : part.slice(0, at));
      if (at < 0) problems.push(say('address.no_value', { key }));
      else if (this.pairs.has(key)) problems.push(say('address.twice', { key }));
      else this.pairs.set(key, decoded(part.slice(at + 1)));
    }
  }

  private take(key: string): string | undefined {
    const value = this.pairs.get(key);
    this.pairs.delete(key);
    return value;
  }

  word<Word extends string>(key: string, allowed: readonly [Word, ...Word[]]): Word {
    const value = this.take(key) ?? allowed[0];
    const found = allowed.find((item) => item === value);
    if (found === undefined) this.problems.push(say('address.word', { key, got: brief(value), allowed: allowed.join(', ') }));
    return found ?? allowed[0];
  }

  /** A body of a file, if the address names one that is open. */
  file(key: string): object | undefined {
    const name = this.take(key);
    const file = name === undefined ? undefined : fileNamed(name);
    if (name !== undefined && file === undefined) this.problems.push(say('address.open', { key, name: brief(name) }));
    return file;
  }

  /** @param without what counts without the key @param optional whether a missing one is no problem */
  number(key: string, without: number, optional = false): number {
    const text = this.take(key);
    const parsed = text === undefined ? { problem: say('address.no_number', { key }) } : parseNumber(key, text);
    if ('value' in parsed) return parsed.value;
    if (text !== undefined || !optional) this.problems.push(parsed.problem);
    return without;
  }

  /** What a body has in a field; undefined where it need not be there and is not. */
  value(key: string, field: BodyField, without: Body): Value | undefined {
    if (field !== 'relaxation') {
      const optional = isLossName(field) || (isFaceName(field) && field !== 'coat_young');
      const value = this.number(key, optional ? NaN : without[field], optional);
      return Number.isNaN(value) ? undefined : value;
    }
    const text = this.take(key);
    const parsed = text === undefined ? undefined : parseRelaxation(key, text);
    if (parsed && 'problem' in parsed) this.problems.push(parsed.problem);
    return parsed && 'value' in parsed ? parsed.value : undefined;
  }

  /** Complains of keys that nobody has asked for. */
  finish(known: ReadonlySet<string>): void {
    // Those of what it meets are those of the body and a 2, but for a few.
    const told = [...known].filter((key) => !(key.endsWith('2') && known.has(key.slice(0, -1)))).join(' ');
    for (const key of this.pairs.keys()) {
      this.problems.push(known.has(key) ? say('address.not_here', { key }) : say('address.unknown', { key, allowed: told }));
    }
  }
}

export function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
