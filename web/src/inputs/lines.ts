// An encounter in a few words, as a command line, as lines of Python, and its curve as CSV.
import { unitsOf } from '../core/local';
import type { CurvePoint, Encounter, Motion } from '../core/protocol';
import { prefixFor, shortest, significant } from '../drawing/numbers';
import { type Side, poissonOf, sidesOf } from './document';
import { names } from './fields';
import { type Inputs, motionOf } from './inputs';
import { lengthOf } from './kinds';

// The build takes it from CMakeLists.txt.
declare const STOSS_VERSION: string;

export const version = STOSS_VERSION;

/** The tolerance of the command and of Python where none is given. */
const usualTolerance = 1e-3;

/** Who meets whom, in one line: disk ν 0.33; steel sphere 10 mm at a glass half-space. */
export function description(encounter: Encounter): string {
  const { against, si } = encounter;
  const [first, second] = sidesOf(encounter);
  const words = inWords(first, si, si);
  if (second) return `${words} at ${inWords(second, si, true)}`;
  return against === 'wall' ? words : `${words} at an identical one`;
}

function inWords({ kind, body, second, fields, material, strain, file }: Side, si: boolean, sized: boolean): string {
  if (file) return `“${file.title}”`;
  const size = sized ? lengthOf(kind) : undefined;
  return [
    ...(material ? [`${material.name} ${kind.name}`] : [kind.name]),
    ...(!material && fields.includes('poisson') ? [`ν ${significant(body.poisson, 4)}`] : []),
    ...(!material && (si || second) ? [`E ${withPrefix(body.young, si ? 'Pa' : '')}`] : []),
    ...(size ? [si ? withPrefix(body[size], 'm') : `${names[size][1]} ${significant(body[size], 3)}`] : []),
    ...(!material && body.loss_time !== 0 ? [`η ${significant(body.loss_time, 3)}`] : []),
    ...(strain && !second ? ['plane strain'] : []),
  ].join(' ');
}

function withPrefix(value: number, unit: string): string {
  const prefix = prefixFor(value, unit);
  return `${significant(value / prefix.size, 3)} ${prefix.unit}`.trim();
}

/** The numbers of a body by the keys of the command. */
function pairsOf({ kind, body, fields, solid, file }: Side): [string, string][] {
  if (file) return [];
  const pairs: [string, number | undefined][] = [
    ...fields.filter((name) => name !== 'loss_time').map((name): [string, number] => [name, body[name]]),
    ['yield', kind.canYield ? solid?.yield_strength : undefined],
    ['loss_time', body.loss_time || undefined],
  ];
  return pairs.flatMap(([key, value]) => (value === undefined ? [] : [[key, shortest(value)]]));
}

/** Arguments that say who meets whom, as `stoss restitution` and `stoss table` take them. */
export function encounterArguments(encounter: Encounter): string[] {
  const { kind, against } = encounter;
  const [first, second] = sidesOf(encounter);
  const other = second?.file ? `@${second.file.name}`
    : second ? [second.kind.name, ...pairsOf(second).map((pair) => pair.join('='))].join(',') : against;
  return [
    ...(kind === 'disk' ? [] : ['--body', first.file ? `@${first.file.name}` : kind]),
    ...pairsOf(first).flatMap(([key, value]) => [`--${key.replace('_', '-')}`, value]),
    ...(first.strain ? ['--plane', 'strain'] : []),
    ...(other === 'wall' ? [] : ['--against', other]),
  ];
}

/** The command line of ε at some speeds, a,b,c, to be pasted into a shell. */
export function commandLine(encounter: Encounter, ...speeds: number[]): string {
  const list = speeds.map(shortest).join(',');
  return ['stoss', 'restitution', ...encounterArguments(encounter), '--speed', list].join(' ');
}

/** The command line of the collision rule of inputs; of ε where there is no friction. */
export function ruleLine(inputs: Inputs): string {
  const motion = motionOf(inputs);
  if (motion.friction === 0) return commandLine(inputs.encounter, inputs.speed);
  const args = numbersOf(motion).map(([name, value]) => `--${name.replace('_', '-')} ${value}`);
  return ['stoss', 'oblique', ...encounterArguments(inputs.encounter), ...args].join(' ');
}

/** The numbers of a motion with friction, by the words of the command and of Python. */
function numbersOf({ speed, angle, friction, spin, spin2 }: Motion): [string, string][] {
  const all: [string, number][] = [['speed', speed], ['angle', angle], ['friction', friction]];
  if (spin !== 0) all.push(['spin', spin]);
  if (spin2 !== 0) all.push(['second_spin', spin2]);
  return all.map(([name, value]) => [name, shortest(value)]);
}

/** A short program in Python that prints ε at one speed, or with friction the collision rule. */
export function pythonLines(inputs: Inputs): string {
  const { encounter, speed } = inputs;
  const motion = motionOf(inputs);
  const rule = motion.friction === 0 ? 'restitution' : 'oblique';
  const { against, si } = encounter;
  const [first, second] = sidesOf(encounter);
  const kind = first.file ? 'body' : encounter.kind;
  const name = second?.kind.bounded ? 'other' : 'block';
  const args = [
    kind,
    ...(second ? [`against=${name}`] : against === 'same' ? ['against="same"'] : []),
    ...(motion.friction === 0 ? [`speed=${shortest(speed)}`]
      : numbersOf(motion).map((pair) => pair.join('='))),
  ];
  return [
    'import stoss', '', `${kind} = ${call(first, si)}`, ...(second ? [`${name} = ${call(second, si)}`] : []),
    `print(stoss.${rule}(${args.join(', ')}))`, '',
  ].join('\n');
}

function call(side: Side, si: boolean): string {
  const { kind, body, fields, material, strain, file } = side;
  if (file) return `stoss.ModalBody.read("${file.name}")`;
  const args = kind.parameters // in the order of Python
    .filter(({ name, ofMaterial }) => fields.includes(name) && name !== 'loss_time' && !(si && ofMaterial))
    .map(({ name }) => `${name}=${shortest(body[name])}`);
  if (si) args.push(`material=${material ? `stoss.materials["${material.name}"]` : ownMaterial(side)}`);
  if ((material?.loss_time ?? 0) !== body.loss_time) args.push(`loss_time=${shortest(body.loss_time)}`);
  if (strain) args.push('plane="strain"');
  const name = kind.name.replace(/(^|-)(\w)/g, (_, __, letter: string) => letter.toUpperCase());
  return `stoss.${name}(${args.join(', ')})`;
}

function ownMaterial(side: Side): string {
  const { young, density } = side.body;
  const numbers = { young, poisson: poissonOf(side), density };
  return `stoss.Material(${Object.entries(numbers).map(([name, value]) => `${name}=${shortest(value)}`).join(', ')})`;
}

/** A curve as CSV, as `stoss restitution --format csv` writes it, of the columns that the page knows: comments that say
 *  what it is, one line of columns, one row for each speed, slowest first. */
export function curveCsv(encounter: Encounter, points: readonly CurvePoint[]): string {
  const sorted = [...points].sort((a, b) => a.speed - b.speed);
  const { kind, si } = encounter;
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
    `# command: ${commandLine(encounter, ...sorted.map(({ speed }) => speed))} --format csv`,
    `# body: ${kind}`,
    `# tolerance: ${shortest(usualTolerance)}`,
    columns.map(([name]) => name).join(','),
    ...sorted.map((point) => columns.map(([, text]) => text(point)).join(',')),
    '',
  ].join('\n');
}
