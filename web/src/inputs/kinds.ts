// The core's table of kinds and its named materials, as the page asks them: what can meet, and of which numbers.
import type { NamedMaterial } from 'stoss';
import { kinds, materials as named } from '../generated/kinds';

type Row = (typeof kinds)[number];

/** What can be the first body, of numbers. */
export type BodyKind = Extract<Row, { bounded: true; fromFile: false }>['name'];

/** What has no end, by its name for a sphere. */
export type Block = Extract<Row, { solid: true; bounded: false; hasPlane: false }>['name'];

/** What makes a body or a block: a number, or how its material relaxes. */
export type BodyField = Extract<Row, { solid: true }>['parameters'][number]['name'];
export type NumberField = Exclude<BodyField, 'relaxation'>;
type FaceField = Extract<NumberField, 'roughness' | 'yield_strength' | `coat${string}`>;

/** Shares of the modulus E(0) that relax, and their times. */
export type Relaxation = readonly (readonly [share: number, time: number])[];

export interface Parameter {
  readonly name: BodyField;
  /** in SI; '' for a pure number */
  readonly unit: string;
  readonly ofMaterial: boolean;
  /** without a material, where it is not given */
  readonly otherwise?: number;
  /** which it may be, where the core limits it */
  readonly most?: number;
  /** where it must be given */
  readonly least?: number;
  readonly help: string;
}

export interface Kind {
  readonly name: string;
  readonly help: string;
  readonly bounded: boolean;
  readonly canYield: boolean;
  readonly hasPlane: boolean;
  /** given by a file, not by numbers */
  readonly fromFile: boolean;
  /** its unit of length, R or L */
  readonly length: string;
  readonly parameters: readonly Parameter[];
  /** kinds of bodies and blocks that it meets */
  readonly meets: readonly string[];
}

const table = kinds as unknown as readonly Kind[];

export const bodyKinds = table.filter(({ bounded, fromFile }) => bounded && !fromFile)
  .map(({ name }) => name as BodyKind);

/** Any body, by a file of its own. */
export const fileKind = table.find(({ fromFile }) => fromFile)!;

export function kindNamed(name: string): Kind {
  return table.find((kind) => kind.name === name)!;
}

const blocksOf = (kind: BodyKind): Kind[] => kindNamed(kind).meets.map(kindNamed).filter(({ bounded }) => !bounded);

export const blocks = blocksOf('sphere').map(({ name }) => name as Block);

export function isBlock(against: string): against is Block {
  return blocks.some((name) => name === against);
}

/** The kind of block that a body meets in place of that of a sphere; undefined where it meets none. */
export function blockOf(kind: BodyKind, against: string): Kind | undefined {
  return isBlock(against) ? blocksOf(kind)[blocks.indexOf(against)] : undefined;
}

/** A kind in words. */
export const wordOf = (kind: string): string => kind.replace('hollow-', 'hollow ');

/** What is a pure number of a body's shape, whatever the units. */
export const isShare = (name: string): boolean => name === 'inner';

/** Whether it is the loss of a material. A body has one of them at most. */
export const isLossName = (name: string): boolean => ['loss_time', 'quality', 'relaxation'].includes(name);

/** Whether it says how rough a face is, with what it is coated, or from which stress on it yields; and whether it counts
 *  only of one with a coat. */
export const isFaceName = (name: string): boolean => ['roughness', 'yield_strength'].includes(name) || name.startsWith('coat');
export const isOfCoat = (name: string): boolean => name.startsWith('coat_');

/** What a kind is made of, in the order of the page: the material, the size, the loss, the face. */
export function parametersOf(kind: Kind): Parameter[] {
  const rank = ({ ofMaterial, name }: Parameter): number =>
    (name === 'poisson' ? 0 : ofMaterial ? 1 : isLossName(name) ? 3 : isFaceName(name) ? 4 : 2);
  return [...kind.parameters].sort((a, b) => rank(a) - rank(b));
}

/** The name of the size of a body: radius, or length. */
export function sizeOf(kind: string): NumberField {
  return lengthOf(kindNamed(kind))!;
}

/** The name of the size of a body or a block; undefined of what has none. */
export function lengthOf({ parameters }: Kind): NumberField | undefined {
  return parameters.find(({ unit, name }) => unit === 'm' && !isFaceName(name))?.name as NumberField | undefined;
}

/** The smooth face without a coat, which every body has unless another is given. */
export const bareFace = Object.fromEntries(kindNamed('sphere').parameters.filter(({ name }) => isFaceName(name))
  .map(({ name, otherwise }) => [name, otherwise])) as Record<FaceField, number>;

export type Material = NamedMaterial;

export const materials: readonly Material[] = named;

export function materialNamed(name: string): Material {
  const found = materials.find((material) => material.name === name);
  if (found === undefined) throw new Error(`there is no material “${name}”`);
  return found;
}
