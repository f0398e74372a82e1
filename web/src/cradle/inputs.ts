// What the page of the cradle is told, as one value; its examples, its document, and its address:
// ?material=bearing%20steel&R=0.01&balls=5&lift=1&drop=0.0025, or ?scene=drop&material=rubber&R=0.01&R2=0.03&drop=0.5&gap=0.001
import type { Encounter, Row } from '../core/protocol';
import { shortest } from '../drawing/numbers';
import { type Word, say } from '../drawing/words';
import { speedOf } from '../inputs/inputs';
import { materials } from '../inputs/kinds';
import { Reader } from '../inputs/reader';

/** Balls that hang in a row, or two balls, one on the other, that fall on a floor. */
export const scenes = ['cradle', 'drop'] as const;

/** What is left of the vibration when the balls meet again: what the material leaves, or all of it. */
export const leaves = ['fades', 'stays'] as const;

export interface CradleInputs {
  readonly scene: (typeof scenes)[number];
  /** the name of one */
  readonly material: string;
  /** of all balls, or of the upper one, m */
  readonly radius: number;
  /** of the lower one, m */
  readonly radius2: number;
  readonly balls: number;
  readonly lift: number;
  /** m */
  readonly drop: number;
  /** between neighbours, m */
  readonly gap: number;
  readonly vibration: (typeof leaves)[number];
}

export const fewestBalls = 2;
export const mostBalls = 7;

/** The strings of the cradle, m: their length says how long a swing takes. */
export const string = 0.2;

export const usual: CradleInputs = {
  scene: 'cradle', material: 'bearing steel', radius: 0.01, radius2: 0.03, balls: 5, lift: 1, drop: 0.0025, gap: 0,
  vibration: 'fades',
};

const drop: CradleInputs = { ...usual, scene: 'drop', material: 'rubber', radius: 0.01, radius2: 0.03, drop: 0.5, gap: 0.005 };

/** Examples, by their words. */
export const examples: readonly (readonly [Word, CradleInputs])[] = [
  ['cradle.steel', usual],
  ['cradle.two', { ...usual, lift: 2 }],
  ['cradle.glass', { ...usual, material: 'glass', radius: 0.008, balls: 3, drop: 0.02 }],
  ['cradle.rubber', { ...usual, material: 'rubber', radius: 0.02, balls: 3, drop: 0.1 }],
  ['cradle.apart', { ...usual, gap: 5e-5 }],
  ['cradle.drop', drop],
  ['cradle.drop_touching', { ...drop, gap: 0 }],
];

/** The inputs with which a scene begins. */
export const startOf = (scene: CradleInputs['scene']): CradleInputs => (scene === 'drop' ? drop : usual);

/** Which of the numbers a scene has. */
const numbersOf = { cradle: ['radius', 'drop', 'gap'], drop: ['radius', 'radius2', 'drop', 'gap'] } as const;
export type NumberName = (typeof numbersOf)['drop'][number];

export const namesOf = ({ scene }: CradleInputs): readonly NumberName[] => numbersOf[scene];

const keys: Record<NumberName, string> = { radius: 'R', radius2: 'R2', drop: 'drop', gap: 'gap' };
const known = new Set(['scene', 'material', 'balls', 'lift', 'vibration', 'version', ...Object.values(keys)]);

/** The inputs as text after ? in the address. */
export function toAddress(inputs: CradleInputs): string {
  const { scene, material, balls, lift, vibration } = inputs;
  return [
    ...(scene === 'cradle' ? [] : [`scene=${scene}`]), `material=${encodeURIComponent(material)}`,
    ...(scene === 'cradle' ? [`balls=${balls}`, `lift=${lift}`] : []),
    ...namesOf(inputs).map((name) => `${keys[name]}=${shortest(inputs[name])}`),
    ...(vibration === 'fades' ? [] : [`vibration=${vibration}`]),
  ].join('&');
}

/** Problems that are told; more of them do not help. */
const mostTold = 3;

/** The inputs that an address holds, and in one line what of it was left out. */
export function fromAddress(text: string): { inputs: CradleInputs; problem: string } {
  const problems: string[] = [];
  const reader = new Reader(text.replace(/^[#?]/, '').split('&').filter((part) => part !== ''), '=', problems);
  const scene = reader.word('scene', scenes);
  const start = startOf(scene);
  const names = [start.material, ...materials.map(({ name }) => name)] as [string, ...string[]];
  const material = reader.word('material', [...new Set(names)] as [string, ...string[]]);
  const whole = (key: 'balls' | 'lift', low: number, high: number): number => {
    const value = reader.number(key, start[key], true);
    if (Number.isInteger(value) && value >= low && value <= high) return value;
    problems.push(say('address.word', { key, got: String(value), allowed: say('number.range', { from: low, to: high }) }));
    return Math.min(start[key], high);
  };
  const balls = scene === 'cradle' ? whole('balls', fewestBalls, mostBalls) : start.balls;
  const lift = scene === 'cradle' ? whole('lift', 1, balls - 1) : start.lift;
  const own = Object.fromEntries(numbersOf[scene].map((name) => {
    const value = reader.number(keys[name], start[name], true);
    if (value >= 0) return [name, value];
    problems.push(say('cradle.negative', { key: keys[name], got: value }));
    return [name, start[name]];
  }));
  const vibration = reader.word('vibration', leaves);
  reader.word('version', ['1']);
  reader.finish(known);
  const told = problems.slice(0, mostTold).join('; ');
  return {
    inputs: { ...start, scene, material, balls, lift, ...own, vibration },
    problem: told && say('address.problem', { told }),
  };
}

/** Another number of balls, or of lifted ones. */
export function withBalls(inputs: CradleInputs, balls: number, lift = inputs.lift): CradleInputs {
  return { ...inputs, balls, lift: Math.min(lift, balls - 1) };
}

/** The speed at the bottom, m/s. */
export const speedAt = ({ drop: height }: CradleInputs): number => speedOf(height);

/** Velocities at first, to the right or down, m/s. */
export function speedsOf(inputs: CradleInputs): number[] {
  const speed = speedAt(inputs);
  return inputs.scene === 'drop' ? [speed, speed]
    : Array.from({ length: inputs.balls }, (_, ball) => (ball < inputs.lift ? speed : 0));
}

const sphere = (material: string, radius: number) => ({ kind: 'sphere', radius, material }) as const;

/** The document of the row: the balls from left to right, or from the upper one to the floor. */
export function rowOf(inputs: CradleInputs): Row {
  const { scene, material, radius, radius2, balls, gap } = inputs;
  const [bodies, count] = scene === 'drop' ? [[sphere(material, radius), sphere(material, radius2)], 1]
    : [Array.from({ length: balls }, () => sphere(material, radius)), balls - 1];
  const gaps = gap === 0 ? {} : { gaps: [...Array.from({ length: count }, () => gap), ...(scene === 'drop' ? [0] : [])] };
  return { bodies: bodies as unknown as Row['bodies'], ...(scene === 'drop' ? { after: 'wall' as const } : {}), ...gaps };
}

/** Two neighbours as a pair; and the lower ball at the floor. */
export function pairOf({ scene, material, radius, radius2 }: CradleInputs): Encounter {
  const against = scene === 'drop' ? sphere(material, radius2) : 'same';
  return { first: sphere(material, radius), against } as Encounter;
}
export function floorOf({ material, radius2 }: CradleInputs): Encounter {
  return { first: sphere(material, radius2), against: 'wall' } as Encounter;
}

/** Masses of the balls over that of the first. */
export function massesOf({ scene, radius, radius2, balls }: CradleInputs): number[] {
  return scene === 'drop' ? [1, (radius2 / radius) ** 3] : Array.from({ length: balls }, () => 1);
}
