// The document of an encounter, as the core reads it, and the numbers that it names.
import type { Body, Encounter } from '../core/protocol';
import { secondBody } from './inputs';
import { type BodyField, type Kind, type Material, blockOf, kindNamed, materials, parametersOf } from './kinds';

/** What is second: a body like the first, or a block; undefined for a wall and for an equal body. */
export function secondOf({ kind, against }: Encounter): { kind: Kind; body: Body } | undefined {
  const body = secondBody(against);
  if (body === undefined) return undefined;
  return { kind: against.kind === 'body' ? kindNamed(kind) : (blockOf(kind) ?? kindNamed('half-space')), body };
}

/** The numbers that say what a body is, in the order of the page; in SI some are of its material. Without SI the first
 *  has as its units what would have a default. */
export function fieldsOfBody(kind: Kind, si: boolean, second: boolean): BodyField[] {
  return parametersOf(kind)
    .filter(({ name, otherwise }) => si || second || otherwise === undefined || name === 'loss_time')
    .map(({ name }) => name);
}

/** The material that has the elastic constants and the density of a body in SI. */
export function solidOf(body: Body, kind: Kind): Material | undefined {
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

/** Poisson's ratio of a solid; of a rod, which does without, any. */
export function poissonOf(body: Body, kind: Kind): number {
  return kind.parameters.some(({ name }) => name === 'poisson') ? body.poisson : 0.3;
}

type Participant = Record<string, unknown>;

function participant({ si, plane }: Encounter, kind: Kind, body: Body, second: boolean): Participant {
  const made: Participant = { kind: kind.name };
  for (const name of fieldsOfBody(kind, si, second)) made[name] = body[name];
  if (!si) return made;
  const { young, density } = body;
  for (const { name, ofMaterial } of kind.parameters) if (ofMaterial) delete made[name];
  made.material = solidOf(body, kind)?.name ?? { young, poisson: poissonOf(body, kind), density };
  if (kind.hasPlane) made.plane = plane;
  return made;
}

/** Who meets whom, for the core. */
export function documentOf(encounter: Encounter): string {
  const { kind, first, against } = encounter;
  const second = secondOf(encounter);
  return JSON.stringify({
    first: participant(encounter, kindNamed(kind), first, false),
    against: second ? participant(encounter, second.kind, second.body, true) : against.kind,
  });
}
