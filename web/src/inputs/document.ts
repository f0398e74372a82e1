// The document of an encounter, as the core reads it, and the numbers that it names.
import type { Body, Encounter } from '../core/protocol';
import { type BodyField, type Kind, type Material, blockOf, kindNamed, materials, parametersOf } from './kinds';

/** The numbers that say what a body is, in the order of the page; in SI some are of its material. Without SI the first
 *  has as its units what would have a default. */
export function fieldsOfBody(kind: Kind, si: boolean, second: boolean): BodyField[] {
  return parametersOf(kind)
    .filter(({ name, otherwise }) => si || second || otherwise === undefined || name === 'loss_time')
    .map(({ name }) => name);
}

/** The material that has the elastic constants and the density of a body in SI. */
function solidOf(body: Body, kind: Kind): Material | undefined {
  const used = kind.parameters.filter(({ ofMaterial }) => ofMaterial).map(({ name }) => name);
  return materials.find((material) => used.every((name) => material[name as keyof Material] === body[name]));
}

/** The same with its loss; undefined for numbers of one's own. */
export function materialOf(body: Body, kind: Kind): Material | undefined {
  const solid = solidOf(body, kind);
  const lossy = solid && Math.abs(solid.loss_time - body.loss_time) <= 1e-9 * body.loss_time;
  return lossy ? solid : undefined;
}

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
}

/** The first body, and what it meets where that is a body or a half-space of its own. */
export function sidesOf({ kind, si, plane, first, against, second }: Encounter): [Side, Side?] {
  const side = (its: Kind, body: Body, other: boolean): Side => ({
    kind: its, body, second: other, fields: fieldsOfBody(its, si, other),
    strain: si && its.hasPlane && plane === 'strain',
    solid: si ? solidOf(body, its) : undefined, material: si ? materialOf(body, its) : undefined,
  });
  const one = side(kindNamed(kind), first, false);
  if (!hasSecond(against)) return [one];
  return [one, side(against === 'body' ? one.kind : (blockOf(kind) ?? kindNamed('half-space')), second, true)];
}

/** Whether what the first body meets has numbers of its own. */
export function hasSecond(against: Encounter['against']): boolean {
  return against === 'body' || against === 'half-space';
}

/** Poisson's ratio of a solid; of a rod, which does without, any. */
export function poissonOf({ kind, body }: Side): number {
  return kind.parameters.some(({ name }) => name === 'poisson') ? body.poisson : 0.3;
}

function participant(side: Side, { si, plane }: Encounter): Record<string, unknown> {
  const { kind, body, fields, solid } = side;
  const made: Record<string, unknown> = { kind: kind.name };
  for (const name of fields) made[name] = body[name];
  if (!si) return made;
  const { young, density } = body;
  for (const { name, ofMaterial } of kind.parameters) if (ofMaterial) delete made[name];
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
