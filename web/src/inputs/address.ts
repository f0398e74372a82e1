// All inputs in the address of the page, in short readable keys: ?body=sphere&nu=0.3&v=0.01&against=half-space&nu2=0.2;
// those of a real ball by names and a drop height: ?view=ball&material=glass&R=0.008&material2=granite&drop=0.3
import type { Encounter, Motion } from '../core/protocol';
import { rounded, shortest } from '../drawing/numbers';
import { say } from '../drawing/words';
import { motionProblem, repaired } from './check';
import {
  type Body, type Choice, type Side, ball, encounterOf, isUnusual, madeOf, meetingOf, noLoss, ofFile, unitBody, withBody,
} from './document';
import { motionFieldsOf, motions, names, softCoat, textOf } from './fields';
import { nameOf } from './files';
import { type Inputs, type View, defaults, dropOf, firstBall, mostKept, siSpeed, speedOf } from './inputs';
import {
  type BodyField, type BodyKind, bareFace, blockOf, blocks, bodyKinds, isFaceName, isLossName, isOfCoat, materialNamed,
  materials, parametersOf,
} from './kinds';
import { Reader, decoded } from './reader';
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

/** Whether a body of a named material has it of its own. */
const isOwn = (field: BodyField): boolean => ['radius', 'thickness'].includes(field) || isLossName(field) || isFaceName(field);

/** Whether what most bodies do without is named; `lossless` says whether none of the losses is, too. */
function isNamed(name: BodyField, body: Body, lossless: boolean): boolean {
  if (!isLossName(name) && !isFaceName(name)) return true;
  return isUnusual(name, body) || (lossless && name === 'loss_time' && !['quality', 'relaxation'].some((other) =>
    isUnusual(other as BodyField, body)));
}

const pairOf = (name: BodyField, { body, second }: Side): [string, string] => [keyOf(name, second), textOf(body[name], shortest)];

const grounds = ['half-space', 'plate', 'same'] as const;
const solids = materials.map(({ name }) => name) as [string, ...string[]];

/** Of named materials, which have their loss unless one has been typed. */
function ballPairs(encounter: Encounter): string[] {
  const { against, first, second } = meetingOf(encounter);
  const its = (side: Side): string[] => [
    `${side.second ? 'material2' : 'material'}=${encodeURIComponent(side.solid!.name)}`,
    ...side.fields.filter((name) => isOwn(name) && !(isLossName(name) && side.material) && isNamed(name, side.body, true))
      .map((name) => pairOf(name, side).join('=')),
  ];
  return [...its(first), ...(against === 'half-space' ? [] : [`against=${against}`]), ...(second ? its(second) : [])];
}

function pairsOf(encounter: Encounter, between: string): string[] {
  const { kind, si, against, first, second } = meetingOf(encounter);
  const numbers = (side: Side): [string, string][] => (
    side.file ? [[side.second ? 'file2' : 'file', nameOf(side.file)]]
      : side.fields.filter((name) => isNamed(name, side.body, false)).map((name) => pairOf(name, side)));
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
  reader.finish(known);
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
  reader.finish(known);
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
      const read = (fields: readonly BodyField[], otherwise: Body): Partial<Body> =>
        Object.fromEntries(fields.map((field) => [field, reader.value(keyOf(field, second), field, otherwise)])
          .filter(([, value]) => value !== undefined)) as Partial<Body>;
      const own = read(side.fields.filter((field) => !solid || isOwn(field)), without);
      // A named material has its loss unless one is given.
      const losses = solid && !Object.keys(own).some(isLossName) ? {} : noLoss;
      const body: Body = { ...(solid ? madeOf(solid, without) : without), ...losses, ...bareFace, ...own };
      const coat = body.coat === 0 ? {}
        : read(parametersOf(side.kind).map(({ name }) => name).filter(isOfCoat), { ...body, coat_young: softCoat(body) });
      encounter = withBody(encounter, second, { ...body, ...coat }, choice);
    }
  };
  filled(false, usual);
  filled(true, si ? meetingOf(encounter).first.body : unitBody);
  return encounter;
}
