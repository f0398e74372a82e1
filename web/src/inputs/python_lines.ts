// The lines of Python that give the same numbers.
import type { Body, Encounter } from '../core/protocol';
import { lossTimeOf, materialOf } from './materials';
import { shortest } from './number';

const classes = { disk: 'Disk', sphere: 'Sphere', rod: 'Rod' } as const;

/** A short program that prints ε at one speed. */
export function pythonLines(encounter: Encounter, speed: number, tolerance = 1e-3): string {
  const name: string = encounter.kind;
  const lines = ['import stoss', '', `${name} = ${bodyCall(encounter, encounter.first)}`];
  const args = [name];
  const { against } = encounter;
  if (against.kind === 'same') args.push('against="same"');
  if (against.kind === 'body') {
    lines.push(`other = ${bodyCall(encounter, against.body, true)}`);
    args.push('against=other');
  }
  if (against.kind === 'half-space') {
    lines.push(`block = ${halfSpaceCall(encounter, against.body)}`);
    args.push('against=block');
  }
  args.push(`speed=${shortest(speed)}`);
  if (tolerance !== 1e-3) args.push(`tolerance=${shortest(tolerance)}`);
  return [...lines, `print(stoss.restitution(${args.join(', ')}))`, ''].join('\n');
}

function bodyCall(encounter: Encounter, body: Body, second = false): string {
  const { kind, si } = encounter;
  const size = kind === 'rod' ? 'length' : 'radius';
  const args: string[] = [];
  if (si) {
    args.push(`${size}=${shortest(body.radius)}`);
    if (kind === 'rod') args.push(`area=${shortest(body.area)}`);
    args.push(...materialArguments(encounter, body));
  } else {
    if (kind !== 'rod') args.push(`poisson=${shortest(body.poisson)}`);
    if (second) {
      args.push(`${size}=${shortest(body.radius)}`);
      args.push(`young=${shortest(body.young)}`, `density=${shortest(body.density)}`);
      if (kind === 'rod') args.push(`area=${shortest(body.area)}`);
    }
    if (body.lossTime !== 0) args.push(`loss_time=${shortest(body.lossTime)}`);
  }
  return `stoss.${classes[kind]}(${args.join(', ')})`;
}

function halfSpaceCall(encounter: Encounter, body: Body): string {
  const name = encounter.kind === 'disk' ? 'HalfPlane' : 'HalfSpace';
  const ratios = [
    `poisson=${shortest(body.poisson)}`,
    `young=${shortest(body.young)}`,
    `density=${shortest(body.density)}`,
    ...(body.lossTime === 0 ? [] : [`loss_time=${shortest(body.lossTime)}`]),
  ];
  return `stoss.${name}(${(encounter.si ? materialArguments(encounter, body) : ratios).join(', ')})`;
}

function materialArguments(encounter: Encounter, body: Body): string[] {
  const material = materialOf(body, encounter.kind);
  const args: string[] = [];
  if (material !== undefined) {
    args.push(`material=stoss.materials["${material.name}"]`);
    if (lossTimeOf(material) !== body.lossTime) args.push(`loss_time=${shortest(body.lossTime)}`);
  } else {
    const poisson = encounter.kind === 'rod' ? 0.3 : body.poisson;
    const numbers = `young=${shortest(body.young)}, poisson=${shortest(poisson)}, density=${shortest(body.density)}`;
    args.push(`material=stoss.Material(${numbers})`);
    if (body.lossTime !== 0) args.push(`loss_time=${shortest(body.lossTime)}`);
  }
  if (encounter.kind === 'disk' && encounter.plane === 'strain') args.push('plane="strain"');
  return args;
}
