// An encounter in a few words, as a command line, as lines of Python, and its curve as CSV.
import { unitsOf } from '../core/local';
import type { CurvePoint, Encounter, Motion } from '../core/protocol';
import { prefixFor, shortest, significant } from '../drawing/numbers';
import { say } from '../drawing/words';
import { type Side, isUnusual, meetingOf } from './document';
import { names, textOf } from './fields';
import { nameOf, titleOf } from './files';
import { type Inputs, dropOf, motionOf, speedOf } from './inputs';
import { isFaceName, isLossName, lengthOf, wordOf } from './kinds';

// The build takes it from CMakeLists.txt.
declare const STOSS_VERSION: string;

export const version = STOSS_VERSION;

/** The tolerance of the command and of Python where none is given. */
const usualTolerance = 1e-3;

/** Who meets whom, in one line: disk ν 0.33; steel sphere R 10 mm at a glass half-space. */
export function description(encounter: Encounter): string {
  const { against, si, first, second } = meetingOf(encounter);
  const words = inWords(first, si);
  if (second) return say('encounter.at', { words, other: inWords(second, true) });
  return against === 'wall' ? words : say('encounter.same', { words });
}

function inWords({ kind, si, body, second, fields, material, strain, file }: Side, sized: boolean): string {
  if (file) return `“${titleOf(file)}”`;
  const size = sized ? lengthOf(kind) : undefined;
  return [
    material ? `${material.name} ${wordOf(kind.name)}` : wordOf(kind.name),
    ...(!material && fields.includes('poisson') ? [`ν ${significant(body.poisson, 4)}`] : []),
    ...(!material && (si || second) ? [`E ${withPrefix(body.young, si ? 'Pa' : '')}`] : []),
    ...(size ? [`${names[size][0]} ${inUnit(body[size], si)}`] : []),
    ...(fields.includes('inner') ? [`b ${significant(body.inner, 4)}`] : []),
    ...(!material && body.loss_time !== 0 ? [`η ${significant(body.loss_time, 3)}`] : []),
    ...(!material && body.quality !== 0 ? [`Q ${significant(body.quality, 3)}`] : []),
    ...(body.relaxation.length > 0 ? [`E(t) ${textOf(body.relaxation)}`] : []),
    ...(body.roughness !== 0 ? [say('encounter.rough', { height: inUnit(body.roughness, si) })] : []),
    ...(body.coat !== 0 ? [say('encounter.coat', { thickness: inUnit(body.coat, si) })] : []),
    ...(body.yield_strength !== 0 ? [say('encounter.yields', { stress: withPrefix(body.yield_strength, si ? 'Pa' : '') })] : []),
    ...(strain && !second ? [say('encounter.strain')] : []),
  ].join(' ');
}

const inUnit = (length: number, si: boolean): string => (si ? withPrefix(length, 'm') : significant(length, 3));

function withPrefix(value: number, unit: string): string {
  const prefix = prefixFor(value, unit);
  return `${significant(value / prefix.size, 3)} ${prefix.unit}`.trim();
}

/** Numbers of a side by their names, of what it is made apart from all others; none of a named material. */
function numbersOf({ si, kind, body, fields, solid, material }: Side): Record<'made' | 'other', [string, string][]> {
  const made = kind.parameters.filter(({ ofMaterial }) => ofMaterial).map(({ name }) => name);
  // In SI a body of a named material that loses nothing has to say so.
  const lossless = si && !isUnusual('quality', body) && !isUnusual('relaxation', body);
  const given = fields.filter((name) =>
    (isLossName(name) ? !material && (isUnusual(name, body) || (name === 'loss_time' && lossless))
      : isFaceName(name) ? isUnusual(name, body) : !solid || !made.includes(name)));
  const pairs = (wanted: boolean): [string, string][] =>
    given.filter((name) => made.includes(name) === wanted).map((name) => [name, textOf(body[name], shortest)]);
  return { made: pairs(true), other: pairs(false) };
}

/** What a side is by the keys of the command. */
function pairsOf(side: Side): [string, string][] {
  const { made, other } = numbersOf(side);
  return [...(side.solid ? [['material', side.solid.name] as [string, string]] : made), ...other];
}

/** Arguments that say who meets whom, as `stoss restitution`, `stoss table` and `stoss predict` take them. */
export function encounterArguments(encounter: Encounter): string[] {
  const { kind, against, first, second } = meetingOf(encounter);
  const other = second?.file ? `@${nameOf(second.file)}`
    : second ? [second.kind.name, ...pairsOf(second).map((pair) => pair.join('='))].join(',') : against;
  return [
    '--body', first.file ? `@${nameOf(first.file)}` : kind,
    ...pairsOf(first).flatMap(([key, value]) => [`--${key.replace('_', '-')}`, value]),
    ...(first.strain ? ['--plane', 'strain'] : []),
    ...(other === 'wall' ? [] : ['--against', other]),
  ];
}

/** Arguments of `stoss` for ε, or for a prediction, at some speeds. */
export function argumentsOf(encounter: Encounter, speeds: readonly number[], command = 'restitution'): string[] {
  return [command, ...encounterArguments(encounter), '--speed', speeds.map(shortest).join(',')];
}

/** Arguments of `stoss predict` at a speed, as a drop height where that is the rounder number. */
export function dropArguments(encounter: Encounter, speed: number): string[] {
  const height = dropOf(speed);
  const isRounder = speedOf(height) === speed && shortest(height).length < shortest(speed).length;
  return isRounder ? ['predict', ...encounterArguments(encounter), '--height', shortest(height)]
    : argumentsOf(encounter, [speed], 'predict');
}

/** Arguments of the command as a line to be pasted into a shell. */
export function commandLine(args: readonly string[]): string {
  return ['stoss', ...args].map((each) => (/\s/.test(each) ? `'${each}'` : each)).join(' ');
}

/** Arguments of the collision rule of inputs; of ε where there is no friction. */
export function ruleArguments(inputs: Inputs): string[] {
  const motion = motionOf(inputs);
  if (motion.friction === 0) return argumentsOf(inputs.encounter, [inputs.speed]);
  const numbers = wordsOfMotion(motion).flatMap(([name, value]) => [`--${name.replace('_', '-')}`, value]);
  return ['oblique', ...encounterArguments(inputs.encounter), ...numbers];
}

/** The numbers of a motion, those along the surface only with friction, by the words of the command and of Python. */
function wordsOfMotion({ speed, angle, friction, spin, second_spin }: Motion): [string, string][] {
  const along = friction === 0 ? {} : { angle, friction, ...(spin && { spin }), ...(second_spin && { second_spin }) };
  return Object.entries({ speed, ...along }).map(([name, value]) => [name, shortest(value)]);
}

/** A short program in Python that prints ε at one speed, or with friction the collision rule. */
export function pythonLines(inputs: Inputs): string {
  const motion = motionOf(inputs);
  const { kind, against, first, second } = meetingOf(inputs.encounter);
  const one = first.file ? 'body' : kind.replace('-', '_');
  const other = second?.kind.bounded ? 'other' : 'block';
  const args = [
    one, ...(second ? [`against=${other}`] : against === 'same' ? ['against="same"'] : []),
    ...wordsOfMotion(motion).map((pair) => pair.join('=')),
  ];
  return [
    'import stoss', '', `${one} = ${call(first)}`, ...(second ? [`${other} = ${call(second)}`] : []),
    `print(stoss.${motion.friction === 0 ? 'restitution' : 'oblique'}(${args.join(', ')}))`, '',
  ].join('\n');
}

function call(side: Side): string {
  const { si, kind, body: { young, poisson, density, relaxation }, solid, strain, file } = side;
  if (file) return `stoss.ModalBody.read("${nameOf(file)}")`;
  const { made, other } = numbersOf(side);
  const terms = relaxation.map((term) => `(${term.map(shortest).join(', ')})`).join(', ');
  const args = (pairs: [string, string][]): string[] =>
    pairs.map(([name, value]) => `${name}=${name === 'relaxation' ? `[${terms}]` : value}`);
  const own = args(Object.entries({ young, poisson, density }).map(([name, value]) => [name, shortest(value)]));
  const material = solid ? `stoss.materials["${solid.name}"]` : `stoss.Material(${own.join(', ')})`;
  const name = kind.name.replace(/(^|-)(\w)/g, (_, __, letter: string) => letter.toUpperCase());
  const all = [...args(si ? other : [...made, ...other]), ...(si ? [`material=${material}`] : []),
    ...(strain ? ['plane="strain"'] : [])];
  return `stoss.${name}(${all.join(', ')})`;
}

/** A body as its document has it, one of a file by its name. */
function said(of: unknown): string {
  if (typeof of === 'string') return of;
  return JSON.stringify(of, (key, value: unknown) => (key === 'body' ? { name: (value as { name: string }).name } : value));
}

/** A curve as CSV, as `stoss restitution --format csv` writes it, of the columns that the page knows: comments that say
 *  what it is, one line of columns, one row for each speed, slowest first. */
export function curveCsv(encounter: Encounter, points: readonly CurvePoint[]): string {
  const sorted = [...points].sort((a, b) => a.speed - b.speed);
  const { si } = meetingOf(encounter);
  const { speed: c, first: { poisson } } = unitsOf(encounter);
  const columns: [string, (point: CurvePoint) => string][] = [
    ['speed[c]', ({ speed }) => shortest(speed / c)],
    ['restitution', ({ restitution }) => shortest(restitution)],
    ['restitution_error', ({ error }) => (Number.isFinite(error) ? shortest(error) : 'unknown')],
    ['converged', ({ converged }) => String(converged)],
  ];
  if (si) columns.splice(1, 0, ['speed_si[m/s]', ({ speed }) => shortest(speed)]);
  if (poisson !== undefined) columns.unshift(['poisson', () => shortest(poisson)]);
  return [
    `# stoss ${version}: restitution`,
    `# command: ${commandLine(argumentsOf(encounter, sorted.map(({ speed }) => speed)))} --format csv`,
    `# first: ${said(encounter.first)}`,
    `# against: ${said(encounter.against)}`,
    `# tolerance: ${shortest(usualTolerance)}`,
    columns.map(([name]) => name).join(','),
    ...sorted.map((point) => columns.map(([, text]) => text(point)).join(',')),
    '',
  ].join('\n');
}
