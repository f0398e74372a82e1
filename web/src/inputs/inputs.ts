// What the user has chosen, as one value that is never changed in place.
import type { Against, Body, Encounter } from '../core/protocol';
import { documentOf } from './document';
import { type BodyKind, blockOf, kindNamed, materialNamed, sizeOf } from './kinds';

/** All that the address holds: who meets whom, how fast, and whose curves stay for comparison. */
export interface Inputs {
  readonly encounter: Encounter;
  /** c of the first body, or m/s in SI */
  readonly speed: number;
  readonly kept: readonly Encounter[];
  /** whether only ε, the height of rebound and the film are shown */
  readonly simple: boolean;
}

/** A body that is its own unit and loses nothing. */
export const unitBody: Body =
  { poisson: 0.33, young: 1, density: 1, radius: 1, length: 1, area: 1, loss_time: 0 };

export const defaults: Inputs = {
  encounter: { kind: 'disk', first: unitBody, against: { kind: 'wall' }, si: false, plane: 'stress' },
  speed: 0.1,
  kept: [],
  simple: false,
};

const { young, poisson, density, loss_time } = materialNamed('bearing steel');

/** What SI begins with: a ball of a bearing of 1 cm, at the speed of a fall from 5 cm. */
export const ball: Body = { young, poisson, density, loss_time, radius: 0.01, length: 0.01, area: 1e-4 };
export const siSpeed = 1;

/** More curves than these cannot be told apart: there are as many colours, and one is for the current one. */
export const mostKept = 5;

/** What deforms opposite the first body; undefined for a rigid wall and for an equal body. */
export function secondBody(against: Against): Body | undefined {
  return against.kind === 'body' || against.kind === 'half-space' ? against.body : undefined;
}

/** Another kind of body of the same material and size; what only the old kind can meet becomes the wall. */
export function withKind(encounter: Encounter, kind: BodyKind): Encounter {
  const [old, size] = [sizeOf(encounter.kind), sizeOf(kind)];
  // A disk without a material may have a 2-D Poisson's ratio that no solid has.
  const made = (body: Body): Body => ({
    ...body, [size]: body[old], poisson: kind === 'sphere' && body.poisson > 0.4999 ? 0.33 : body.poisson,
  });
  const { against } = encounter;
  return withSecond({
    ...encounter,
    kind,
    plane: kindNamed(kind).hasPlane ? encounter.plane : 'stress',
    first: made(encounter.first),
    against: against.kind === 'half-space' && !blockOf(kind) ? { kind: 'wall' } : against,
  }, made);
}

/** Something else to meet; a second body starts as the first's like. */
export function withAgainst(encounter: Encounter, kind: Against['kind']): Encounter {
  if (kind === 'wall' || kind === 'same') return { ...encounter, against: { kind } };
  const body = secondBody(encounter.against) ?? encounter.first;
  return { ...encounter, against: { kind, body } };
}

/** The same encounter with its second body, if it has one, changed by a function. */
export function withSecond(encounter: Encounter, change: (body: Body) => Body): Encounter {
  const { against } = encounter;
  if (against.kind !== 'body' && against.kind !== 'half-space') return encounter;
  return { ...encounter, against: { kind: against.kind, body: change(against.body) } };
}

/** Whether two encounters give the same results: what is not used does not count. */
export function equal(a: Encounter, b: Encounter): boolean {
  return documentOf(a) === documentOf(b);
}
