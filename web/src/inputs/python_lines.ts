// The lines of Python that give the same numbers.
import type { Body, Encounter } from '../core/protocol';
import { fieldsOfBody, materialOf, poissonOf, secondOf } from './document';
import { type Kind, kindNamed } from './kinds';
import { shortest } from './number';

/** A short program that prints ε at one speed. */
export function pythonLines(encounter: Encounter, speed: number, tolerance = 1e-3): string {
  const { kind, first, against } = encounter;
  const lines = ['import stoss', '', `${kind} = ${call(encounter, kindNamed(kind), first, false)}`];
  const args: string[] = [kind];
  const second = secondOf(encounter);
  if (second) {
    const name = second.kind.bounded ? 'other' : 'block';
    lines.push(`${name} = ${call(encounter, second.kind, second.body, true)}`);
    args.push(`against=${name}`);
  } else if (against.kind === 'same') args.push('against="same"');
  args.push(`speed=${shortest(speed)}`);
  if (tolerance !== 1e-3) args.push(`tolerance=${shortest(tolerance)}`);
  return [...lines, `print(stoss.restitution(${args.join(', ')}))`, ''].join('\n');
}

function call({ si, plane }: Encounter, kind: Kind, body: Body, second: boolean): string {
  const given = fieldsOfBody(kind, si, second);
  const args = kind.parameters // in the order of Python
    .filter(({ name, ofMaterial }) => given.includes(name) && name !== 'loss_time' && !(si && ofMaterial))
    .map(({ name }) => `${name}=${shortest(body[name])}`);
  const material = si ? materialOf(body, kind) : undefined;
  if (si) args.push(`material=${material ? `stoss.materials["${material.name}"]` : ownMaterial(kind, body)}`);
  if ((material?.loss_time ?? 0) !== body.loss_time) args.push(`loss_time=${shortest(body.loss_time)}`);
  if (si && kind.hasPlane && plane === 'strain') args.push('plane="strain"');
  const name = kind.name.split('-').map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join('');
  return `stoss.${name}(${args.join(', ')})`;
}

function ownMaterial(kind: Kind, body: Body): string {
  const numbers = { young: body.young, poisson: poissonOf(body, kind), density: body.density };
  return `stoss.Material(${Object.entries(numbers).map(([name, value]) => `${name}=${shortest(value)}`).join(', ')})`;
}
