// What the user has chosen, as one value that is never changed in place; and examples, each with all of it.
import type { Body, Encounter, Motion } from '../core/protocol';
import { equal, hasFile, hasSecond, madeOf, meetsBody, withoutFiles } from './document';
import { type BodyKind, blockOf, isBlock, kindNamed, materialNamed, sizeOf } from './kinds';

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

/** A body that is its own unit and loses nothing. */
export const unitBody: Body =
  { poisson: 0.33, young: 1, density: 1, radius: 1, length: 1, area: 1, thickness: 1, loss_time: 0 };

/** What is along the surface at first: nothing that counts. */
const smooth = { friction: 0, angle: 45, spin: 0, spin2: 0 };

export const defaults: Inputs = {
  encounter: { kind: 'disk', first: unitBody, against: 'wall', second: unitBody, si: false, plane: 'stress' },
  speed: 0.1,
  ...smooth,
  kept: [],
  simple: false,
};

/** What SI begins with: a ball of a bearing of 1 cm, slow enough not to yield at a rigid wall (from 0.13 m/s). */
const centimetre = { radius: 0.01, length: 0.01, area: 1e-4, thickness: 0.01 };
export const ball = madeOf(materialNamed('bearing steel'), { ...unitBody, ...centimetre });
export const siSpeed = 0.1;

/** More curves than these cannot be told apart: there are as many colours, and one is for the current one. */
export const mostKept = 5;

/** Another kind of body of the same material and size; what only the old kind can meet becomes the wall. */
export function withKind(encounter: Encounter, kind: BodyKind): Encounter {
  const [old, size] = [sizeOf(encounter.kind), sizeOf(kind)];
  // A disk without a material may have a 2-D Poisson's ratio that no solid has.
  const made = (body: Body): Body => ({
    ...body, [size]: body[old], poisson: kind === 'sphere' && body.poisson > 0.4999 ? 0.33 : body.poisson,
  });
  const { plane, against, first, second } = encounter;
  return {
    ...withoutFiles(encounter),
    kind,
    plane: kindNamed(kind).hasPlane ? plane : 'stress',
    first: made(first),
    against: isBlock(against) && !blockOf(kind, against) ? 'wall' : against,
    second: made(second),
  };
}

/** Something else to meet; a second body starts as the first's like. */
export function withAgainst(encounter: Encounter, against: Encounter['against']): Encounter {
  const { secondFile: _, ...rest } = encounter;
  return { ...rest, against, second: hasSecond(encounter.against) ? encounter.second : encounter.first };
}

/** Whether its surface moves along another: not that of rods, nor of bodies of which only a point is known. */
export function takesFriction(encounter: Encounter): boolean {
  return sizeOf(encounter.kind) === 'radius' && !hasFile(encounter);
}

/** Whether friction counts. */
export function isOblique({ encounter, friction }: Impact): boolean {
  return takesFriction(encounter) && friction !== 0;
}

/** How bodies of inputs meet: what does not count is 0. */
export function motionOf(inputs: Impact): Motion {
  const { speed, friction, angle, spin, spin2 } = inputs;
  if (!isOblique(inputs)) return { speed, friction: 0, angle: 0, spin: 0, spin2: 0 };
  return { speed, friction, angle, spin, spin2: meetsBody(inputs.encounter) ? spin2 : 0 };
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
  const made = (of: string): Body => madeOf(materialNamed(of), { ...unitBody, ...centimetre, radius });
  const encounter: Encounter =
    { kind: 'sphere', first: made(material), against: 'half-space', second: made(block), si: true, plane: 'stress' };
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
