// The numbers a user types: which of them an encounter has, what they are called, and in what unit.
import type { Encounter } from '../core/protocol';
import { unitInWords } from '../drawing/numbers';
import { sidesOf } from './document';
import { type BodyField, kindNamed } from './kinds';

/** A number of the first body, of what it meets, or the speed. */
export type Field = BodyField | `${BodyField}2` | 'speed';

/** The fields that count in an encounter, in the order of the page. */
export function fieldsOf(encounter: Encounter): Field[] {
  return [...sidesOf(encounter).flatMap((side) =>
    side!.fields.map((name): Field => (side!.second ? ofSecond(name) : name))), 'speed'];
}

export function ofSecond(field: BodyField): `${BodyField}2` {
  return `${field}2`;
}

/** The name a field has in the body that owns it, and whether that is the second one; undefined for the speed. */
export function owner(field: Field): { second: boolean; name: BodyField } | undefined {
  if (field === 'speed') return undefined;
  const second = field.endsWith('2');
  return { second, name: (second ? field.slice(0, -1) : field) as BodyField };
}

/** The number of a field in the inputs. */
export function valueOf(encounter: Encounter, speed: number, field: Field): number {
  const place = owner(field);
  return place === undefined ? speed : encounter[place.second ? 'second' : 'first'][place.name];
}

/** The encounter with another number in one field of a body. */
export function withValue(encounter: Encounter, field: Exclude<Field, 'speed'>, value: number): Encounter {
  const { second, name } = owner(field)!;
  const side = second ? 'second' : 'first';
  return { ...encounter, [side]: { ...encounter[side], [name]: value } };
}

/** What the page calls a number of a body: in words, by a symbol, and in the address. */
export const names: Record<BodyField, [words: string, symbol: string, key: string]> = {
  poisson: ['Poisson’s ratio', 'ν', 'nu'], young: ['Young’s modulus', 'E', 'E'], density: ['Density', 'ρ', 'rho'],
  radius: ['Radius', 'R', 'R'], length: ['Length', 'L', 'R'], area: ['Cross-section', 'A', 'A'],
  loss_time: ['Loss time', 'η', 'eta'],
};

/** What the page says of a field. */
interface Words {
  readonly name: string;
  /** its name with its symbol */
  readonly label: string;
  /** what it is, in the words of the core */
  readonly help: string;
  /** '' for a pure number */
  readonly unit: string;
}

export function wordsOf({ kind, si }: Encounter, field: Field): Words {
  const place = owner(field);
  const speed = 'Speed of approach';
  if (place === undefined) return { name: speed, label: `${speed} v`, help: '', unit: si ? 'm/s' : 'c' };
  const { name: key, second } = place;
  const { hasPlane, length, parameters } = kindNamed(kind);
  const { help = '', unit = '' } = parameters.find((each) => each.name === key) ?? {};
  const [usual, symbol] = names[key];
  const name = si ? usual : key === 'poisson' && hasPlane ? '2‑D Poisson’s ratio'
    : key === 'young' && second ? 'Modulus' : usual;
  const ratio = second && !si && !['ν', 'η'].includes(symbol);
  return {
    name, label: `${name} ${ratio ? `${symbol}₂/${symbol}₁` : symbol}`, help,
    unit: si ? unitInWords(unit) : key === 'loss_time' ? `${length}/c` : '',
  };
}
