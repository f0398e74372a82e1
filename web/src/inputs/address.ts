// All inputs in the address of the page, in short readable keys: ?body=sphere&nu=0.3&v=0.01&against=half-space&nu2=0.2;
// those of a real ball by names and a drop height: ?view=ball&material=glass&R=0.008&material2=granite&drop=0.3
import type { Encounter, Motion } from '../core/protocol';
import { rounded, shortest } from '../drawing/numbers';
import { say } from '../drawing/words';
import { brief, motionProblem, parseNumber, repaired } from './check';
import {
  type Body, type Choice, type Side, ball, encounterOf, madeOf, meetingOf, ofFile, unitBody, withBody,
} from './document';
import { motionFieldsOf, motions, names } from './fields';
import { fileNamed, nameOf } from './files';
import { type Inputs, type View, defaults, dropOf, firstBall, mostKept, siSpeed, speedOf } from './inputs';
import {
  type BodyField, type BodyKind, blockOf, blocks, bodyKinds, isLossName, materialNamed, materials,
} from './kinds';
import { barSpeed } from './units';

const keyOf = (field: BodyField, second: boolean): string => names[field][1] + (second ? '2' : '');
const keys = (second: boolean): string[] => (Object.keys(names) as BodyField[]).map((field) => keyOf(field, second));
const known = new Set([
  'body', 'file', 'file2', 'units', 'plane', 'material', 'material2', 'drop', ...Object.values(motions).map(([, key]) => key),
  ...keys(false), 'against', ...keys(true), 'view', 'keep', 'version',
]);

/** Of the keys and their meaning; an address names it only if it is another one (docs/developer/versions.md). */
const version = '1';

/** The inputs as text after ? in the address. */
export function toAddress(inputs: Inputs): string {
  const { encounter, view, kept, speed } = inputs;
  const isBall = view === 'ball';
  return [
    ...(isBall ? ['view=ball', ...ballPairs(encounter), `drop=${shortest(dropOf(speed))}`] : pairsOf(encounter, '=')),
    ...motionFieldsOf(inputs).filter((name) => (name === 'speed' ? !isBall : inputs[name] !== defaults[name]))
      .map((name) => `${motions[name][1]}=${shortest(inputs[name])}`),
    ...(view === 'simple' ? ['view=simple'] : []),
    ...kept.map((other) => `keep=${pairsOf(other, ':').join(',')}`),
  ].join('&');
}

/** Whether a body of a named material has such a number of its own. */
const isOwn = (field: BodyField): boolean => ['radius', 'thickness'].includes(field) || isLossName(field);

/** Whether a loss stands for that of the body: without a quality it is the loss time, be it 0. */
const isGiven = (name: BodyField, { quality }: Body): boolean => (name === 'quality') === (quality !== 0);

const grounds = ['half-space', 'plate', 'same'] as const;
const solids = materials.map(({ name }) => name) as [string, ...string[]];

/** Of named materials, which have their loss unless one has been typed. */
function ballPairs(encounter: Encounter): string[] {
  const { against, first, second } = meetingOf(encounter);
  const its = ({ solid, material, body, fields, second: other }: Side): string[] => [
    `${other ? 'material2' : 'material'}=${encodeURIComponent(solid!.name)}`,
    ...fields.filter((name) => isOwn(name) && !(isLossName(name) && (material || !isGiven(name, body))))
      .map((name) => `${keyOf(name, other)}=${shortest(body[name])}`),
  ];
  return [...its(first), ...(against === 'half-space' ? [] : [`against=${against}`]), ...(second ? its(second) : [])];
}

function pairsOf(encounter: Encounter, between: string): string[] {
  const { kind, si, against, first, second } = meetingOf(encounter);
  const numbers = ({ body, fields, second: other, file }: Side): [string, string][] => (
    file ? [[other ? 'file2' : 'file', nameOf(file)]] : fields.filter((name) => !isLossName(name) || body[name] !== 0)
      .map((name) => [keyOf(name, other), shortest(body[name])]));
  const pairs: [string, string][] = [
    ['body', kind], ...(first.file ? numbers(first) : []), ...(si ? [['units', 'SI']] as const : []),
    ...(first.strain ? [['plane', 'strain']] as const : []), ...(first.file ? [] : numbers(first)),
    ...(against === 'wall' ? [] : [['against', against]] as const), ...(second ? numbers(second) : []),
  ] as [string, string][];
  return pairs.map((pair) => pair.join(between));
}

/** The inputs that an address holds, and in one line what of it was left out ('' if nothing): what is right counts,
 *  and what is not is that of the default. */
export function fromAddress(text: string): { inputs: Inputs; problem: string } {
  const parts = text.replace(/^[#?]/, '').split('&').filter((part) => part !== '');
  if (parts.length === 0) return { inputs: firstBall, problem: '' };
  const problems: string[] = [];
  const isKept = (part: string): boolean => part.startsWith('keep=');
  const reader = new Reader(parts.filter((part) => !isKept(part)), '=', problems);
  const view = reader.word('view', ['full', 'simple', 'ball']);
  const encounter = inRange(encounterFrom(reader, view), problems);
  const motion = motionFrom(reader, encounter, view, problems);
  reader.word('version', [version]);
  reader.finish();
  const curves = parts.filter(isKept);
  if (curves.length > mostKept) problems.push(say('address.curves', { count: curves.length, most: mostKept }));
  const kept = curves.slice(0, mostKept).flatMap((part) => keptFrom(part.slice('keep='.length), problems));
  return { inputs: { encounter, ...motion, kept, view }, problem: lineOf(problems) };
}

/** How they meet; the default for what is wrong. */
function motionFrom(reader: Reader, encounter: Encounter, view: View, problems: string[]): Motion {
  const { friction, angle, spin, second_spin } = defaults;
  const isBall = view === 'ball';
  const usual = { speed: isBall ? firstBall.speed : normalSpeed(encounter), friction, angle, spin, second_spin };
  let motion: Motion = isBall ? { ...usual, speed: speedOf(reader.number('drop', dropOf(usual.speed))) } : usual;
  for (const name of ['speed', 'friction', 'angle', 'spin', 'second_spin'] as const) {
    if ((isBall && name === 'speed') || !motionFieldsOf({ encounter, ...motion }).includes(name)) continue;
    motion = { ...motion, [name]: reader.number(motions[name][1], usual[name], name !== 'speed') };
  }
  for (let wrong = motionProblem({ encounter, ...motion }); wrong; wrong = motionProblem({ encounter, ...motion })) {
    problems.push(wrong[1]);
    motion = { ...motion, [wrong[0]]: usual[wrong[0]] };
  }
  return motion;
}

/** Problems that are told; more of them do not help. */
const mostTold = 3;

function lineOf(problems: readonly string[]): string {
  if (problems.length === 0) return '';
  const more = problems.length - mostTold;
  const told = problems.slice(0, mostTold).join('; ').replace(/[\p{C}\p{Zl}\p{Zp}]/gu, '�'); // no line ends or controls
  return say('address.problem', { told: more > 0 ? say('address.more', { told, more }) : told });
}

/** A curve for comparison; one that is not right as a whole is not shown. */
function keptFrom(text: string, problems: string[]): Encounter[] {
  const wrong: string[] = [];
  const reader = new Reader(decoded(text).split(','), ':', wrong);
  const encounter = encounterFrom(reader, 'full');
  reader.finish();
  inRange(encounter, wrong);
  if (wrong.length === 0) return [encounter];
  problems.push(`keep: ${wrong[0]}`);
  return [];
}

/** The same encounter with the default for what the core refuses. */
function inRange(encounter: Encounter, problems: string[]): Encounter {
  const right = repaired(encounter);
  problems.push(...right.problems.values());
  return right.encounter;
}

/** The default speed, which must be one that the material of a link allows. */
function normalSpeed(encounter: Encounter): number {
  if (!meetingOf(encounter).si) return defaults.speed;
  const c = barSpeed(encounter);
  return rounded(Math.min(Math.max(siSpeed, 1e-7 * c), 0.1 * c), 3);
}

function encounterFrom(reader: Reader, view: View): Encounter {
  const isBall = view === 'ball';
  const kind = isBall ? 'sphere' : reader.word('body', bodyKinds as [BodyKind, ...BodyKind[]]);
  const si = isBall || reader.word('units', ['c', 'SI']) === 'SI';
  const plane = isBall ? 'stress' : reader.word('plane', ['stress', 'strain']);
  const others = ['wall', 'same', 'body'] as const;
  const against = isBall ? reader.word('against', grounds)
    : reader.word('against', [...others, ...blocks.filter((name) => blockOf(kind, name))]);
  const choice: Choice = { kind, si, plane, against };
  const file = (key: string): object | undefined => (kind === 'sphere' && si ? reader.file(key) : undefined);
  const usual = si ? ball : unitBody;
  let encounter = encounterOf(choice, usual, usual);
  /** With the numbers of one side, or the body of its file. */
  const filled = (second: boolean, without: Body): void => {
    const its = second && against !== 'body' ? undefined : file(second ? 'file2' : 'file');
    const side = meetingOf(encounter)[second ? 'second' : 'first'];
    if (its) encounter = { ...encounter, [second ? 'against' : 'first']: ofFile(its) };
    else if (side) {
      const solid = isBall ? materialNamed(reader.word(second ? 'material2' : 'material', solids)) : undefined;
      const numbers = side.fields.filter((field) => !solid || isOwn(field)).map((field) => [field, isLossName(field)
        ? reader.number(keyOf(field, second), NaN, true) : reader.number(keyOf(field, second), without[field])] as const)
        .filter(([, value]) => !Number.isNaN(value));
      const body = solid ? madeOf(solid, without) : without;
      // A named material has its loss unless one is given.
      const losses = solid && !numbers.some(([field]) => isLossName(field)) ? {} : { loss_time: 0, quality: 0 };
      encounter = withBody(encounter, second, { ...body, ...losses, ...Object.fromEntries(numbers) as Body }, choice);
    }
  };
  filled(false, usual);
  filled(true, si ? meetingOf(encounter).first.body : unitBody);
  return encounter;
}

/** Takes the values of an address by their keys; what is wrong with them goes to `problems`. */
class Reader {
  private readonly pairs = new Map<string, string>();

  constructor(parts: readonly string[], between: string, private readonly problems: string[]) {
    for (const part of parts) {
      const at = part.indexOf(between);
      const key = brief(at < 0 ? part : part.slice(0, at));
      if (at < 0) problems.push(say('address.no_value', { key }));
      else if (this.pairs.has(key)) problems.push(say('address.twice', { key }));
      else this.pairs.set(key, decoded(part.slice(at + 1)));
    }
  }

  private take(key: string): string | undefined {
    const value = this.pairs.get(key);
    this.pairs.delete(key);
    return value;
  }

  word<Word extends string>(key: string, allowed: readonly [Word, ...Word[]]): Word {
    const value = this.take(key) ?? allowed[0];
    const found = allowed.find((item) => item === value);
    if (found === undefined) this.problems.push(say('address.word', { key, got: brief(value), allowed: allowed.join(', ') }));
    return found ?? allowed[0];
  }

  /** A body of a file, if the address names one that is open. */
  file(key: string): object | undefined {
    const name = this.take(key);
    const file = name === undefined ? undefined : fileNamed(name);
    if (name !== undefined && file === undefined) this.problems.push(say('address.open', { key, name: brief(name) }));
    return file;
  }

  /** @param without what counts without the key @param optional whether a missing one is no problem */
  number(key: string, without: number, optional = false): number {
    const text = this.take(key);
    const parsed = text === undefined ? { problem: say('address.no_number', { key }) } : parseNumber(key, text);
    if ('value' in parsed) return parsed.value;
    if (text !== undefined || !optional) this.problems.push(parsed.problem);
    return without;
  }

  /** Complains of keys that nobody has asked for. */
  finish(): void {
    for (const key of this.pairs.keys()) {
      this.problems.push(known.has(key) ? say('address.not_here', { key })
        : say('address.unknown', { key, allowed: [...known].join(' ') }));
    }
  }
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
