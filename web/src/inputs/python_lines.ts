// The lines of Python that give the same numbers.
import type { Encounter } from '../core/protocol';
import { type Side, poissonOf, sidesOf } from './document';
import { shortest } from './number';

/** A short program that prints ε at one speed. */
export function pythonLines(encounter: Encounter, speed: number, tolerance = 1e-3): string {
  const { kind, against, si } = encounter;
  const [first, second] = sidesOf(encounter);
  const name = second?.kind.bounded ? 'other' : 'block';
  const args = [
    kind,
    ...(second ? [`against=${name}`] : against.kind === 'same' ? ['against="same"'] : []),
    `speed=${shortest(speed)}`,
    ...(tolerance === 1e-3 ? [] : [`tolerance=${shortest(tolerance)}`]),
  ];
  return [
    'import stoss', '', `${kind} = ${call(first, si)}`, ...(second ? [`${name} = ${call(second, si)}`] : []),
    `print(stoss.restitution(${args.join(', ')}))`, '',
  ].join('\n');
}

function call(side: Side, si: boolean): string {
  const { kind, body, fields, material, strain } = side;
  const args = kind.parameters // in the order of Python
    .filter(({ name, ofMaterial }) => fields.includes(name) && name !== 'loss_time' && !(si && ofMaterial))
    .map(({ name }) => `${name}=${shortest(body[name])}`);
  if (si) args.push(`material=${material ? `stoss.materials["${material.name}"]` : ownMaterial(side)}`);
  if ((material?.loss_time ?? 0) !== body.loss_time) args.push(`loss_time=${shortest(body.loss_time)}`);
  if (strain) args.push('plane="strain"');
  const name = kind.name.split('-').map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join('');
  return `stoss.${name}(${args.join(', ')})`;
}

function ownMaterial(side: Side): string {
  const { young, density } = side.body;
  const numbers = { young, poisson: poissonOf(side), density };
  return `stoss.Material(${Object.entries(numbers).map(([name, value]) => `${name}=${shortest(value)}`).join(', ')})`;
}
