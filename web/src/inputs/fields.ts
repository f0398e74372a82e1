// The numbers a user types: which of them an encounter has, what they are called, and in what unit.
import type { Encounter, Motion } from '../core/protocol';
import { unitInWords } from '../drawing/numbers';
import { ranges } from '../generated/kinds';
import { meetingOf, meetsBody, withBody } from './document';
import { type Impact, isOblique, takesFriction } from './inputs';
import { type BodyField, blockOf, kindNamed } from './kinds';

/** A number of the first body or of what it meets. */
export type PlacedField = BodyField | `${BodyField}2`;

/** One of them, or of how they meet. */
export type Field = PlacedField | keyof Motion;

/** What the page calls how they meet: in words, by a symbol, in the address, its units without and with SI, and what it
 *  is. */
export const motions: Record<
  keyof Motion, [words: string, symbol: string, key: string, own: string, si: string, help: string]
> = {
  speed: ['Speed of approach', 'v', 'v', 'c', 'm/s', ''],
  friction: ['Friction', 'μ', 'mu', '', '', 'coefficient of Coulomb’s law'],
  angle: ['Angle', 'α', 'angle', '°', '°', 'between the velocity and the normal, along which the speed of approach is'],
  spin: ['Spin', 'Ω', 'spin', 'c/R', 'rad/s', 'positive moves what touches as a positive angle does'],
  second_spin: ['Second spin', 'Ω₂', 'spin2', 'c/R', 'rad/s', 'of what it meets, with the same sign of sliding'],
};

/** The fields of bodies that count in an encounter, in the order of the page. */
export function placedFieldsOf(encounter: Encounter): PlacedField[] {
  const { first, second } = meetingOf(encounter);
  return [...first.fields, ...(second?.fields.map(ofSecond) ?? [])];
}

/** Those of how they meet: some take no friction, and without it the rest does not count. */
export function motionFieldsOf(inputs: Impact): (keyof Motion)[] {
  const { encounter } = inputs;
  if (!takesFriction(encounter)) return ['speed'];
  if (!isOblique(inputs)) return ['speed', 'friction'];
  return ['speed', 'friction', 'angle', 'spin', ...(meetsBody(encounter) ? ['second_spin'] as const : [])];
}

/** All that count. */
export function fieldsOf(inputs: Impact): Field[] {
  return [...placedFieldsOf(inputs.encounter), ...motionFieldsOf(inputs)];
}

export function ofSecond(field: BodyField): `${BodyField}2` {
  return `${field}2`;
}

/** The name a field has in the body that owns it, and whether that is the second one; undefined for how they meet. */
export function owner(field: Field): { second: boolean; name: BodyField } | undefined {
  if (field in motions) return undefined;
  const second = field.endsWith('2');
  return { second, name: (second ? field.slice(0, -1) : field) as BodyField };
}

/** The number of a field in the inputs. */
export function valueOf(inputs: Impact, field: Field): number {
  const place = owner(field);
  if (!place) return inputs[field as keyof Motion];
  const { first, second } = meetingOf(inputs.encounter);
  return (place.second ? second! : first).body[place.name];
}

/** The encounter with another number in one field of a body. */
export function withValue(encounter: Encounter, field: PlacedField, value: number): Encounter {
  const { second, name } = owner(field)!;
  const its = meetingOf(encounter);
  return withBody(encounter, second, { ...(second ? its.second! : its.first).body, [name]: value });
}

/** What the page calls a number of a body: in words, by a symbol, and in the address. */
export const names: Record<BodyField, [words: string, symbol: string, key: string]> = {
  poisson: ['Poisson’s ratio', 'ν', 'nu'], young: ['Young’s modulus', 'E', 'E'], density: ['Density', 'ρ', 'rho'],
  radius: ['Radius', 'R', 'R'], length: ['Length', 'L', 'R'], area: ['Cross-section', 'A', 'A'],
  thickness: ['Thickness', 'h', 'h'], loss_time: ['Loss time', 'η', 'eta'],
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

export function wordsOf(encounter: Encounter, field: Field): Words {
  const { kind, si, against } = meetingOf(encounter);
  const place = owner(field);
  if (place === undefined) {
    const [words, sign, , own, real, help] = motions[field as keyof Motion];
    const range = (ranges as Record<string, string>)[field];
    return { name: words, label: `${words} ${sign}`, help: range ? `${help}, ${range}` : help, unit: si ? real : own };
  }
  const { name: key, second } = place;
  const { hasPlane, length, parameters } = kindNamed(kind);
  const ofBlock = blockOf(kind, against)?.parameters ?? [];
  const { help = '', unit = '' } = [...parameters, ...ofBlock].find((each) => each.name === key) ?? {};
  const [usual, symbol] = names[key];
  const name = si ? usual : key === 'poisson' && hasPlane ? '2‑D Poisson’s ratio'
    : key === 'young' && second ? 'Modulus' : usual;
  const ratio = second && !si && !['ν', 'η'].includes(symbol);
  const ratioOf = parameters.some((each) => each.name === key) ? `${symbol}₂/${symbol}₁` : `${symbol}/${length}`;
  return {
    name, label: `${name} ${ratio ? ratioOf : symbol}`, help,
    unit: si ? unitInWords(unit) : key === 'loss_time' ? `${length}/c` : '',
  };
}
