// What the user has chosen, as one value that is never changed in place; and examples, each with all of it.
import type { Encounter, Motion } from '../core/protocol';
import {
  type Body, type Choice, type Side, centimetre, encounterOf, equal, hasFile, madeOf, meetingOf, meetsBody, unitBody, withBody,
} from './document';
import type { Word } from '../drawing/words';
import { rounded } from '../drawing/numbers';
import { type Block, type BodyKind, isBlock, kindNamed, materialNamed, sizeOf } from './kinds';

/** Who meets whom, and how. */
export interface Impact extends Motion {
  readonly encounter: Encounter;
}

/** What is shown: the drop test of a real ball; all numbers; or of those only ε, the height of rebound and the film. */
export type View = 'ball' | 'full' | 'simple';

/** All that the address holds: the impact, the view, and whose curves stay for comparison. */
export interface Inputs extends Impact {
  readonly kept: readonly Encounter[];
  readonly view: View;
}

/** What is along the surface at first: nothing that counts. */
const smooth = { friction: 0, angle: 45, spin: 0, second_spin: 0 };

export const defaults: Inputs = {
  encounter: encounterOf({ kind: 'disk', si: false, plane: 'stress', against: 'wall' }, unitBody),
  speed: 0.1,
  ...smooth,
  kept: [],
  view: 'full',
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

/** Standard gravity, m/s². */
export const gravity = 9.80665;

/** The height in m from which a ball falls to a speed in m/s, without air. */
export const dropOf = (speed: number): number => rounded(speed ** 2 / (2 * gravity), 12);

/** The speed of such a fall; the sign of a height that is none is kept, for the core to refuse. */
export const speedOf = (height: number): number => Math.sign(height) * Math.sqrt(2 * gravity * Math.abs(height));

/** Whether the view of a real ball can ask for it: a sphere of a named material on a block, a plate or its like. */
export function isBall(encounter: Encounter): boolean {
  const { kind, against, first, second } = meetingOf(encounter);
  return kind === 'sphere' && first.solid !== undefined &&
    (against === 'same' || (isBlock(against) && second!.solid !== undefined));
}

/** An impact that a class can see for itself. */
export interface Preset extends Impact {
  readonly name: Word;
}

/** A ball that falls: its material, radius in m, what it falls on and of what, drop height in m; thickness of a plate. */
function drop(
  name: Word, material: string, radius: number, against: Block, ground: string, height: number, thickness = 0.01,
): Preset {
  const [first, second] = [material, ground]
    .map((each) => madeOf(materialNamed(each), { ...centimetre, radius, thickness })) as [Body, Body];
  const encounter = encounterOf({ kind: 'sphere', si: true, plane: 'stress', against }, first, second);
  return { name, encounter, speed: speedOf(height), ...smooth };
}

export const presets: readonly Preset[] = [
  drop('preset.marble', 'glass', 0.008, 'half-space', 'granite', 0.3),
  drop('preset.superball', 'rubber', 0.02, 'half-space', 'granite', 0.5),
  drop('preset.bearing', 'bearing steel', 0.005, 'half-space', 'glass', 0.2),
  drop('preset.pane', 'bearing steel', 0.005, 'plate', 'glass', 0.2, 0.004),
  { ...drop('preset.hops', 'rubber', 0.025, 'half-space', 'granite', 1.25), friction: 1, angle: 25, spin: 40 },
  { name: 'preset.disk', encounter: defaults.encounter, speed: defaults.speed, ...smooth },
];

/** What the page opens with. */
export const firstBall: Inputs = { ...defaults, ...withoutName(presets[0]!), view: 'ball' };

function withoutName({ encounter, speed, friction, angle, spin, second_spin }: Impact): Impact {
  return { encounter, speed, friction, angle, spin, second_spin };
}

/** The inputs with the impact of an example. */
export function withPreset(inputs: Inputs, name: string): Inputs {
  const preset = presets.find((each) => each.name === name);
  return preset ? { ...inputs, ...withoutName(preset) } : inputs;
}

/** The preset that inputs are; undefined for those of one's own. */
export function presetOf(inputs: Inputs): Preset | undefined {
  return presets.find((preset) => equalInputs(preset, inputs));
}
