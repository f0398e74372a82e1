// What a user types: which numbers an encounter has, and in what unit they are shown.
import type { Encounter, Motion } from '../core/protocol';
import { displayed, rounded, shortest, unitInWords } from '../drawing/numbers';
import { type Word, say } from '../drawing/words';
import { ranges } from '../generated/kinds';
import { type Body, isUnusual, meetingOf, meetsBody, noLoss, withBody } from './document';
import { type Impact, type Inputs, dropOf, isOblique, speedOf, takesFriction } from './inputs';
import { type BodyField, type Relaxation, blockOf, isFaceName, isLossName, isShare, kindNamed } from './kinds';

/** What is of the first body or of what it meets. */
export type PlacedField = BodyField | `${BodyField}2`;

/** One of them, or of how they meet. */
export type Field = PlacedField | keyof Motion;

/** How they meet: a symbol, the key in the address, and the units without and with SI. */
export const motions: Record<keyof Motion, [symbol: string, key: string, own: string, si: string]> = {
  speed: ['v', 'v', 'c', 'm/s'], friction: ['μ', 'mu', '', ''], angle: ['α', 'angle', '°', '°'],
  spin: ['Ω', 'spin', 'c/R', 'rad/s'], second_spin: ['Ω₂', 'spin2', 'c/R', 'rad/s'],
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

/** All that count; the materials of a real ball are named. */
export function fieldsOf(inputs: Impact & Partial<Pick<Inputs, 'view'>>): Field[] {
  const placed = placedFieldsOf(inputs.encounter);
  const asked = inputs.view === 'ball' ? placed.filter((field) => field in measures || isLossOrFace(field)) : placed;
  return [...asked, ...motionFieldsOf(inputs)];
}

/** Whether it is a loss or of a face, of whichever body. */
export function isLossOrFace(field: Field): boolean {
  const place = owner(field);
  return place !== undefined && (isLossName(place.name) || isFaceName(place.name));
}

/** Whether there is such a one, beside the loss of a named material. */
export function hasLossOrFace(encounter: Encounter): boolean {
  const { first, second } = meetingOf(encounter);
  return [first, second].some((side) => side?.fields.some((name) =>
    (isFaceName(name) || (isLossName(name) && !side.material)) && isUnusual(name, side.body)));
}

/** What a class measures in place of a number of the core, in a unit of its own. */
interface Measure {
  readonly words: Word;
  readonly unit: string;
  shown(value: number): number;
  meant(typed: number): number;
}

const measures: Partial<Record<Field, Measure>> = {
  radius: { words: 'ball.diameter', unit: 'mm', shown: (radius) => 2000 * radius, meant: (typed) => typed / 2000 },
  thickness2: { words: 'ball.thickness', unit: 'mm', shown: (thickness) => 1000 * thickness, meant: (typed) => typed / 1000 },
  speed: { words: 'ball.height', unit: 'cm', shown: (speed) => 100 * dropOf(speed), meant: (typed) => speedOf(typed / 100) },
};

export function measureOf({ view }: Inputs, field: Field): Measure | undefined {
  return view === 'ball' ? measures[field] : undefined;
}

/** What a field has: a number, or how a material relaxes. */
export type Value = number | Relaxation;

/** What a field shows. */
export function shownOf(inputs: Inputs, field: Field): Value {
  const [measure, value] = [measureOf(inputs, field), valueOf(inputs, field)];
  return measure ? rounded(measure.shown(value as number), 12) : value;
}

/** The text of it: short enough to be read there, or that of its very number. */
export function textOf(value: Value, write: (number: number) => string = displayed): string {
  return typeof value === 'number' ? write(value) : value.map((term) => term.map(shortest).join(':')).join('+');
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

/** What the inputs have in a field. */
export function valueOf(inputs: Impact, field: Field): Value {
  const place = owner(field);
  if (!place) return inputs[field as keyof Motion];
  const { first, second } = meetingOf(inputs.encounter);
  return (place.second ? second! : first).body[place.name];
}

/** The encounter with something else in one field of a body. A loss takes the place of another, and a coat begins soft. */
export function withValue(encounter: Encounter, field: PlacedField, value: Value): Encounter {
  const { second, name } = owner(field)!;
  const its = meetingOf(encounter);
  const { body } = second ? its.second! : its.first;
  const next: Body = { ...body, [name]: value };
  if (isLossName(name) && isUnusual(name, next)) return withBody(encounter, second, { ...body, ...noLoss, [name]: value });
  const coat_young = name === 'coat' && next.coat_young === 0 ? softCoat(body) : next.coat_young;
  return withBody(encounter, second, { ...next, coat_young });
}

/** The modulus with which a coat begins: a hundredth of that of the body. */
export const softCoat = ({ young }: Body): number => rounded(young / 100, 3);

/** What a body is made of: its symbol, and its key in the address. */
export const names: Record<BodyField, [symbol: string, key: string]> = {
  poisson: ['ν', 'nu'], young: ['E', 'E'], density: ['ρ', 'rho'], radius: ['R', 'R'], inner: ['b', 'b'], length: ['L', 'R'],
  area: ['A', 'A'], thickness: ['h', 'h'], loss_time: ['η', 'eta'], quality: ['Q', 'Q'], relaxation: ['E(t)', 'relax'],
  roughness: ['h', 'rough'], coat: ['h', 'coat'], coat_young: ['E', 'Ec'], coat_poisson: ['ν', 'nuc'], coat_quality: ['Q', 'Qc'],
  yield_strength: ['Y', 'Y'],
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
    const motion = field as keyof Motion;
    const [sign, , own, real] = motions[motion];
    const [words, help, range] = [say(`field.${motion}`), say(`help.${motion}`), (ranges as Record<string, string>)[field]];
    return { name: words, label: `${words} ${sign}`, help: range ? `${help}, ${range}` : help, unit: si ? real : own };
  }
  const { name: key, second } = place;
  const { hasPlane, length, parameters } = kindNamed(kind);
  const ofBlock = blockOf(kind, against)?.parameters ?? [];
  const { help = '', unit = '', least, most } = [...parameters, ...ofBlock].find((each) => each.name === key) ?? {};
  const [symbol] = names[key];
  const name = say(si ? `field.${key}` : key === 'poisson' && hasPlane ? 'field.poisson_plane'
    : key === 'young' && second ? 'field.modulus' : `field.${key}`);
  const ratio = second && !si && key !== 'poisson' && !isShare(key) && !isLossOrFace(field);
  const ownUnits: Record<string, string> = { s: `${length}/c`, m: length, Pa: 'E' };
  const ratioOf = parameters.some((each) => each.name === key) ? `${symbol}₂/${symbol}₁` : `${symbol}/${length}`;
  return {
    name, label: `${name} ${ratio ? ratioOf : symbol}`,
    help: least === undefined ? help : `${help}, ${say('field.range', { least, most: most! })}`,
    unit: si ? unitInWords(unit) : isLossOrFace(field) ? ownUnits[unit] ?? '' : '',
  };
}
