// What the user has chosen, as one value that is never changed in place; and examples, each with all of it.
import type { Encounter, Motion } from '../core/protocol';
import {
  type Body, type Choice, type Side, centimetre, encounterOf, equal, hasFile, madeOf, meetingOf, meetsBody, unitBody, withBody,
} from './document';
import { type BodyKind, kindNamed, materialNamed, sizeOf } from './kinds';

/** Who meets whom, and how. */
export interface Impact extends Motion {
  readonly encounter: Encounter;
}

/** All that the address holds: the impact, and whose curves stay for comparison. */
export interface Inputs extends Impact {
  readonly kept: readonly Encounter[];
  /** whether only ε, the height of rebound and the film are shown */
  readonly simple: boolean;
}

/** What is along the surface at first: nothing that counts. */
const smooth = { friction: 0, angle: 45, spin: 0, second_spin: 0 };

export const defaults: Inputs = {
  encounter: encounterOf({ kind: 'disk', si: false, plane: 'stress', against: 'wall' }, unitBody),
  speed: 0.1,
  ...smooth,
  kept: [],
  simple: false,
};

/** The speed with which SI begins: a ball of steel does not yield at a rigid wall (from 0.13 m/s). */
export const siSpeed = 0.1;

/** More curves than these cannot be told apart: there are as many colours, and one is for the current one. */
export const mostKept = 5;

/** Another kind of body of the same material and size; what only the old kind can meet becomes the wall. */
export function withKind(encounter: Encounter, kind: BodyKind): Encounter {
  const { first, second, ...choice } = meetingOf(encounter);
  const { hasPlane, parameters } = kindNamed(kind);
  const most = parameters.find(({ name }) => name === 'poisson')?.most ?? 1;
  // A disk without a material may have a 2-D Poisson's ratio that no solid has.
  const made = ({ body }: Side): Body => ({
    ...body, [sizeOf(kind)]: body[sizeOf(choice.kind)],
    poisson: body.poisson > most ? unitBody.poisson : body.poisson,
  });
  return encounterOf({ ...choice, kind, plane: hasPlane ? choice.plane : 'stress' }, made(first), second && made(second));
}

/** Something else to meet; a second body starts as the first's like. */
export function withAgainst(encounter: Encounter, against: Choice['against']): Encounter {
  const { first, second, ...choice } = meetingOf(encounter);
  return withBody(encounter, true, (second ?? first).body, { ...choice, against });
}

/** Whether its surface moves along another: not that of rods, nor of bodies of which only a point is known. */
export function takesFriction(encounter: Encounter): boolean {
  return sizeOf(meetingOf(encounter).kind) === 'radius' && !hasFile(encounter);
}

/** Whether friction counts. */
export function isOblique({ encounter, friction }: Impact): boolean {
  return takesFriction(encounter) && friction !== 0;
}

/** How bodies of inputs meet: what does not count is 0. */
export function motionOf(inputs: Impact): Motion {
  const { speed, friction, angle, spin, second_spin } = inputs;
  if (!isOblique(inputs)) return { speed, friction: 0, angle: 0, spin: 0, second_spin: 0 };
  return { speed, friction, angle, spin, second_spin: meetsBody(inputs.encounter) ? second_spin : 0 };
}

/** Whether two inputs give the same results. */
export function equalInputs(a: Impact, b: Impact): boolean {
  return equal(a.encounter, b.encounter) && JSON.stringify(motionOf(a)) === JSON.stringify(motionOf(b));
}

/** An impact that a class can see for itself. */
export interface Preset extends Impact {
  readonly name: string;
}

/** A ball that falls on a block: radius in m, speed in m/s. */
function drop(name: string, material: string, radius: number, block: string, speed: number): Preset {
  const [first, second] = [material, block].map((each) => madeOf(materialNamed(each), { ...centimetre, radius })) as [Body, Body];
  const encounter = encounterOf({ kind: 'sphere', si: true, plane: 'stress', against: 'half-space' }, first, second);
  return { name, encounter, speed, ...smooth };
}

export const presets: readonly Preset[] = [
  { name: 'Elastic disk at a wall', encounter: defaults.encounter, speed: defaults.speed, ...smooth },
  drop('Glass marble on a granite table', 'glass', 0.008, 'granite', 1),
  drop('Rubber ball on a granite floor', 'rubber', 0.02, 'granite', 2),
  drop('Steel ball on glass', 'bearing steel', 0.005, 'glass', 1),
  { ...drop('Superball under a table', 'rubber', 0.025, 'granite', 5), friction: 1, angle: 25, spin: 40 },
];

/** The preset that inputs are; undefined for those of one's own. */
export function presetOf(inputs: Inputs): Preset | undefined {
  return presets.find((preset) => equalInputs(preset, inputs));
}
