// Who meets whom: the page has the document that the core reads, of numbers or of files.
import type { Encounter } from 'stoss';
import { unitsOf } from '../core/local';
import {
  type Block, type BodyField, type BodyKind, type Kind, type Material, type NumberField, type Relaxation, bareFace,
  blockOf, blocks, fileKind, isFaceName, isLossName, isOfCoat, kindNamed, materialNamed, materials, parametersOf, sizeOf,
} from './kinds';

/** What a body or a block is made of, in SI or in units of the first body, which are all 1. What its kind does not have
 *  is not used. */
export type Body = Readonly<Record<NumberField, number>> & { readonly relaxation: Relaxation };

/** A body or a block as a document has it, of whatever kind. */
export type Participant = Readonly<Partial<Body>> & {
  readonly kind: string;
  readonly material?: string | Pick<Body, 'young' | 'poisson' | 'density'>;
  readonly plane?: 'stress' | 'strain';
  /** a body by its modes at a point, of a file that the user has opened */
  readonly body?: object;
};

/** What a user chooses of an encounter besides its numbers. */
export interface Choice {
  readonly kind: BodyKind;
  /** Whether bodies and speeds are in SI. */
  readonly si: boolean;
  /** of a disk in SI */
  readonly plane: 'stress' | 'strain';
  /** a rigid wall, the like of the first body, another of its kind, or a block by its name for a sphere */
  readonly against: 'wall' | 'same' | 'body' | Block;
}

/** One of what meets, with what is said of it. */
export interface Side {
  /** that of a sphere where it is of a file, which has its curvature and its material */
  readonly kind: Kind;
  readonly si: boolean;
  readonly body: Body;
  readonly second: boolean;
  /** the numbers that say what it is, in the order of the page */
  readonly fields: readonly BodyField[];
  /** whether it is a long cylinder */
  readonly strain: boolean;
  /** in SI: the named material that it is of, whatever its loss; and with its loss */
  readonly solid: Material | undefined;
  readonly material: Material | undefined;
  /** what the file of which it is holds */
  readonly file: object | undefined;
}

/** An encounter in the terms of the page; the second where what the first body meets has numbers of its own. */
export interface Meeting extends Choice {
  readonly first: Side;
  readonly second: Side | undefined;
}

/** The losses of a body that has none. */
export const noLoss = { loss_time: 0, quality: 0, relaxation: [] as Relaxation };

/** A body that is its own unit, loses nothing and is smooth. */
export const unitBody: Body = {
  poisson: 0.33, young: 1, density: 1, radius: 1, inner: 0.9, length: 1, area: 1, thickness: 1, ...noLoss, ...bareFace,
};

/** What SI begins with: a ball of a bearing of 1 cm. */
export const centimetre: Body = { ...unitBody, radius: 0.01, length: 0.01, area: 1e-4, thickness: 0.01 };
export const ball = madeOf(materialNamed('bearing steel'), centimetre);

/** The body made of a material, of the same size. */
export function madeOf<Sizes extends Partial<Body>>({ young, poisson, density, quality }: Material, body: Sizes) {
  return { ...body, young, poisson, density, ...noLoss, quality };
}

/** Whether it is something else than a body has unless it is given: a loss, or what makes a face rough or coated. */
export function isUnusual(name: BodyField, body: Body): boolean {
  if (name === 'relaxation') return body.relaxation.length > 0;
  return body[name] !== (isLossName(name) ? 0 : (bareFace as Partial<Body>)[name]);
}

/** By what a body or a block is given. In SI some of it is of a material. Without SI the first body has as its units what
 *  would have a default. What a coat is made of counts where there is one. */
function fieldsOf(kind: Kind, si: boolean, second: boolean, { coat }: Pick<Body, 'coat'>): BodyField[] {
  return parametersOf(kind).map(({ name, otherwise }) => ({ name, isUnit: otherwise !== undefined && !(si || second) }))
    .filter(({ name, isUnit }) => (isOfCoat(name) ? coat !== 0 : isLossName(name) || isFaceName(name) || !isUnit))
    .map(({ name }) => name);
}

/** A body or a block of these numbers; in SI of a material by its name, where they are those of one. */
function participant(kind: Kind, body: Body, { si, plane }: Choice, second: boolean): Participant {
  const ofMaterial = kind.parameters.filter((each) => each.ofMaterial).map(({ name }) => name);
  const own = fieldsOf(kind, si, second, body).filter((name) => !(si && ofMaterial.includes(name)) && !isLossName(name) &&
    !(isFaceName(name) && !isUnusual(name, body)));
  const sizes = Object.fromEntries(own.map((name) => [name, body[name]]));
  const { loss_time, quality, relaxation } = body;
  const loss = relaxation.length > 0 ? { relaxation } : quality === 0 ? { loss_time } : { quality };
  if (!si) return { kind: kind.name, ...sizes, ...loss };
  const solid = materials.find((its) => ofMaterial.every((name) => its[name as keyof Material] === body[name]));
  const known = solid?.quality === quality && loss_time === 0 && relaxation.length === 0;
  const { young, density } = body;
  const poisson = ofMaterial.includes('poisson') ? body.poisson : 0.3; // a rod does without
  return {
    kind: kind.name, ...sizes, material: solid?.name ?? { young, poisson, density },
    ...(known ? {} : loss), ...(kind.hasPlane && { plane }),
  };
}

/** The encounter of what was chosen and of these numbers; what such a body cannot meet becomes the wall. */
export function encounterOf(choice: Choice, first: Body, second: Body = unitBody): Encounter {
  const { kind, against } = choice;
  const other = against === 'body' ? kindNamed(kind) : blockOf(kind, against);
  return {
    first: participant(kindNamed(kind), first, choice, false),
    against: other ? participant(other, second, choice, true) : against === 'same' ? 'same' : 'wall',
  } as Encounter;
}

/** The same encounter with other numbers of one side, or with something else to meet. */
export function withBody(encounter: Encounter, second: boolean, body: Body, choice: Choice = meetingOf(encounter)): Encounter {
  const changed = encounterOf(choice, body, body);
  return second ? { ...encounter, against: changed.against! } : { ...encounter, first: changed.first };
}

/** The document of a body of a file. */
export const ofFile = (file: object): Participant => ({ kind: fileKind.name, body: file });

/** A sphere of the curvature and the material of a body of a file, for what asks for numbers. */
function standIn(file: object): Body {
  const { speed, time } = unitsOf({ first: ofFile(file), against: 'wall' } as Encounter);
  const { young, poisson, density, loss_time = 0 } = file as Body;
  return { ...unitBody, young, poisson, density, loss_time, radius: speed * time };
}

function sideOf(given: Participant, si: boolean, second: boolean): Side {
  const { kind: name, material, plane, body: file, ...own } = given;
  const kind = kindNamed(file ? 'sphere' : name);
  const solid = typeof material === 'string' ? materialNamed(material) : undefined;
  const hasLoss = Object.keys(own).some(isLossName);
  const body = file ? standIn(file)
    : { ...(si ? centimetre : unitBody), ...(solid ? madeOf(solid, {}) : material as Body), ...(hasLoss && noLoss), ...own };
  const fields = file ? [] : fieldsOf(kind, si, second, body);
  const its = hasLoss ? undefined : solid;
  return { kind, si, body, second, fields, strain: plane === 'strain', solid, material: its, file };
}

const meetings = new WeakMap<Encounter, Meeting>();

/** What a document of the page says. */
export function meetingOf(encounter: Encounter): Meeting {
  const known = meetings.get(encounter);
  if (known) return known;
  const [one, other] = [encounter.first, encounter.against] as [Participant, Participant | 'wall' | 'same'];
  const si = one.material !== undefined || one.body !== undefined;
  const first = sideOf(one, si, false);
  const second = typeof other === 'string' ? undefined : sideOf(other, si, true);
  const kind = first.kind.name as BodyKind;
  const against = typeof other === 'string' ? other
    : second!.kind.bounded ? 'body' : blocks.find((name) => blockOf(kind, name) === second!.kind)!;
  const meeting: Meeting = { kind, si, plane: one.plane ?? 'stress', against, first, second };
  meetings.set(encounter, meeting);
  return meeting;
}

/** Whether one of both is of a file: such a body has no inside, and no friction. */
export function hasFile(encounter: Encounter): boolean {
  const { first, second } = meetingOf(encounter);
  return (first.file ?? second?.file) !== undefined;
}

/** Whether what the first body meets is another, which moves and turns too. */
export function meetsBody(encounter: Encounter): boolean {
  return ['same', 'body'].includes(meetingOf(encounter).against);
}

/** Sizes of what meets, in that of the first: 1 of a half-space too, and none of a wall. */
export function sizesOf(encounter: Encounter): number[] {
  const { kind, si, against, first, second } = meetingOf(encounter);
  const size = sizeOf(kind);
  const ratio = against === 'body' ? second!.body[size] / (si ? first.body[size] : 1) : 1;
  return against === 'wall' ? [1] : [1, ratio];
}

/** The text of a document. */
export const documentOf = (encounter: Encounter): string => JSON.stringify(encounter);

/** Whether two encounters give the same results: what is not used does not count. */
export function equal(a: Encounter, b: Encounter): boolean {
  return documentOf(a) === documentOf(b);
}
