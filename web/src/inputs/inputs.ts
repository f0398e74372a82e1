// What the user has chosen, as one value that is never changed in place.
import type { Against, Body, BodyKind, Encounter } from '../core/protocol';

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
export const unitBody: Body = { poisson: 0.33, radius: 1, young: 1, density: 1, area: 1, lossTime: 0 };

export const defaults: Inputs = {
  encounter: { kind: 'disk', first: unitBody, against: { kind: 'wall' }, si: false, plane: 'stress' },
  speed: 0.1,
  kept: [],
  simple: false,
};

/** More curves than these cannot be told apart: there are as many colours, and one is for the current one. */
export const mostKept = 5;

/** What deforms opposite the first body; undefined for a rigid wall and for an equal body. */
export function secondBody(against: Against): Body | undefined {
  return against.kind === 'body' || against.kind === 'half-space' ? against.body : undefined;
}

/** Another kind of body of the same material and size; what only the old kind can meet becomes the wall. */
export function withKind(encounter: Encounter, kind: BodyKind): Encounter {
  const solid = (body: Body): Body => (kind === 'sphere' && body.poisson > 0.4999 ? { ...body, poisson: 0.33 } : body);
  const rodAtHalfSpace = kind === 'rod' && encounter.against.kind === 'half-space';
  return withSecond(
    {
      ...encounter,
      kind,
      plane: kind === 'disk' ? encounter.plane : 'stress',
      first: solid(encounter.first),
      against: rodAtHalfSpace ? { kind: 'wall' } : encounter.against,
    },
    solid,
  );
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
  return JSON.stringify(used(a)) === JSON.stringify(used(b));
}

/** The numbers that count, by the names of the fields, in a fixed order. */
export function used(encounter: Encounter): Record<string, unknown> {
  const { kind, si, plane, first, against } = encounter;
  const pick = (body: Body, sized: boolean, own: boolean): Partial<Body> => ({
    ...(kind === 'rod' ? {} : { poisson: body.poisson }),
    ...(own ? { young: body.young, density: body.density } : {}),
    ...(own && sized ? { radius: body.radius } : {}),
    ...(own && kind === 'rod' ? { area: body.area } : {}),
    lossTime: body.lossTime,
  });
  const second = secondBody(against);
  return {
    kind,
    si,
    plane: kind === 'disk' && si ? plane : 'stress',
    first: pick(first, true, si),
    against: against.kind,
    second: second === undefined ? null : pick(second, against.kind === 'body', true),
  };
}
