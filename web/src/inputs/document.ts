// The document of an encounter, as the core reads it, and the numbers that it names.
import type { Body, BodyFile, Encounter } from '../core/protocol';
import {
  type BodyField, type Kind, type Material, blockOf, fileKind, isBlock, kindNamed, materials, parametersOf,
  sizeOf,
} from './kinds';

/** The body made of a material, of the same size. */
export function madeOf({ young, poisson, density, loss_time }: Material, body: Body): Body {
  return { ...body, young, poisson, density, loss_time };
}

/** One of what meets, with what is said of it. */
export interface Side {
  readonly kind: Kind;
  readonly body: Body;
  readonly second: boolean;
  /** the numbers that say what it is, in the order of the page */
  readonly fields: readonly BodyField[];
  /** whether it is a long cylinder */
  readonly strain: boolean;
  /** in SI: what it is made of, whatever its loss; and with its loss */
  readonly solid: Material | undefined;
  readonly material: Material | undefined;
  /** of which it is, without numbers of its own */
  readonly file: BodyFile | undefined;
}

/** The first body, and what it meets where that is a body or a half-space of its own. In SI some of their numbers are
 *  of a material. Without SI the first has as its units what would have a default. */
export function sidesOf(encounter: Encounter): [Side, Side?] {
  const { kind: name, si, plane, first, against, second: other } = encounter;
  const side = (kind: Kind, body: Body, second: boolean): Side => {
    const file = second ? secondFileOf(encounter) : encounter.firstFile;
    if (file) return { kind, body, second, fields: [], strain: false, solid: undefined, material: undefined, file };
    const fields = parametersOf(kind)
      .filter((its) => si || second || its.otherwise === undefined || its.name === 'loss_time');
    const used = kind.parameters.filter(({ ofMaterial }) => ofMaterial);
    const solid = materials.find((its) =>
      si && used.every(({ name }) => its[name as keyof Material] === body[name]));
    const lossy = solid && Math.abs(solid.loss_time - body.loss_time) <= 1e-9 * body.loss_time;
    return {
      kind, body, second, fields: fields.map((its) => its.name), strain: si && kind.hasPlane && plane === 'strain',
      solid, material: lossy ? solid : undefined, file,
    };
  };
  const one = side(kindNamed(name), first, false);
  if (!hasSecond(against)) return [one];
  return [one, side(against === 'body' ? one.kind : (blockOf(name, against) ?? kindNamed(against)), other, true)];
}

/** Whether what the first body meets has numbers of its own. */
export function hasSecond(against: Encounter['against']): boolean {
  return against === 'body' || isBlock(against);
}

/** The file of what is met, if it is of one. */
export function secondFileOf({ against, secondFile }: Encounter): BodyFile | undefined {
  return against === 'body' ? secondFile : undefined;
}

/** Whether one of both is of a file: such a body has no inside, and no friction. */
export function hasFile(encounter: Encounter): boolean {
  return (encounter.firstFile ?? secondFileOf(encounter)) !== undefined;
}

/** The same, with the spheres that stand in for the bodies of files. */
export function withoutFiles({ firstFile: _, secondFile: __, ...rest }: Encounter): Encounter {
  return rest;
}

/** Whether what the first body meets is another, which moves and turns too. */
export function meetsBody({ against }: Encounter): boolean {
  return against === 'same' || against === 'body';
}

/** Sizes of what meets, in that of the first: 1 of a half-space too, and none of a wall. */
export function sizesOf({ kind, si, first, against, second }: Encounter): number[] {
  const size = sizeOf(kind);
  const ratio = against === 'body' ? second[size] / (si ? first[size] : 1) : 1;
  return against === 'wall' ? [1] : [1, ratio];
}

/** Poisson's ratio of a solid; of a rod, which does without, any. */
export function poissonOf({ kind, body }: Side): number {
  return kind.parameters.some(({ name }) => name === 'poisson') ? body.poisson : 0.3;
}

function participant(side: Side, { si, plane }: Encounter): Record<string, unknown> {
  const { kind, body, fields, solid, material, file } = side;
  if (file) return { kind: fileKind.name, body: file.document };
  const made: Record<string, unknown> = { kind: kind.name };
  for (const name of fields) made[name] = body[name];
  if (!si) return made;
  const { young, density } = body;
  for (const { name, ofMaterial } of kind.parameters) if (ofMaterial) delete made[name];
  if (material) delete made.loss_time; // the core knows it, and how it depends on the speed
  made.material = solid?.name ?? { young, poisson: poissonOf(side), density };
  if (kind.hasPlane) made.plane = plane;
  return made;
}

/** Who meets whom, for the core. */
export function documentOf(encounter: Encounter): string {
  const [first, second] = sidesOf(encounter);
  return JSON.stringify({
    first: participant(first, encounter),
    against: second ? participant(second, encounter) : encounter.against,
  });
}

/** Whether two encounters give the same results: what is not used does not count. */
export function equal(a: Encounter, b: Encounter): boolean {
  return documentOf(a) === documentOf(b);
}
