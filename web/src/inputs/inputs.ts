// What the user has chosen, as one value that is never changed in place; and examples, each with all of it.
import type { Body, Encounter } from '../core/protocol';
import { equal, hasSecond, madeOf } from './document';
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
  encounter: { kind: 'disk', first: unitBody, against: 'wall', second: unitBody, si: false, plane: 'stress' },
  speed: 0.1,
  kept: [],
  simple: false,
};

/** What SI begins with: a ball of a bearing of 1 cm, at the speed of a fall from 5 cm. */
export const ball = madeOf(materialNamed('bearing steel'), { ...unitBody, radius: 0.01, length: 0.01, area: 1e-4 });
export const siSpeed = 1;

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
    ...encounter,
    kind,
    plane: kindNamed(kind).hasPlane ? plane : 'stress',
    first: made(first),
    against: against === 'half-space' && !blockOf(kind) ? 'wall' : against,
    second: made(second),
  };
}

/** Something else to meet; a second body starts as the first's like. */
export function withAgainst(encounter: Encounter, against: Encounter['against']): Encounter {
  return { ...encounter, against, second: hasSecond(encounter.against) ? encounter.second : encounter.first };
}

/** An impact that a class can see for itself. */
export interface Preset {
  readonly name: string;
  readonly encounter: Encounter;
  readonly speed: number;
}

/** A ball that falls on a block: radius in m, speed in m/s. */
function drop(name: string, material: string, radius: number, block: string, speed: number): Preset {
  const made = (of: string): Body => madeOf(materialNamed(of), { ...unitBody, radius, area: 1e-4 });
  const encounter: Encounter =
    { kind: 'sphere', first: made(material), against: 'half-space', second: made(block), si: true, plane: 'stress' };
  return { name, encounter, speed };
}

export const presets: readonly Preset[] = [
  { name: 'Elastic disk at a wall', encounter: defaults.encounter, speed: defaults.speed },
  drop('Glass marble on a granite table', 'glass', 0.008, 'granite', 1),
  drop('Rubber ball on a granite floor', 'rubber', 0.02, 'granite', 2),
  drop('Steel ball on glass', 'bearing steel', 0.005, 'glass', 1),
];

/** The preset that inputs are; undefined for those of one's own. */
export function presetOf({ encounter, speed }: Inputs): Preset | undefined {
  return presets.find((preset) => preset.speed === speed && equal(preset.encounter, encounter));
}
