// The command line that gives the same numbers.
import type { Encounter } from '../core/protocol';
import { type Side, sidesOf } from './document';
import { shortest } from './number';

/** The numbers of a body by the keys of the command. */
function pairsOf({ kind, body, fields, solid }: Side): [string, string][] {
  const strength = kind.canYield ? solid?.yield_strength : undefined;
  const pairs: [string, number][] = [
    ...fields.filter((name) => name !== 'loss_time').map((name): [string, number] => [name, body[name]]),
    ...(strength === undefined ? [] : [['yield', strength] as [string, number]]),
    ...(body.loss_time === 0 ? [] : [['loss_time', body.loss_time] as [string, number]]),
  ];
  return pairs.map(([key, value]) => [key, shortest(value)]);
}

/** Arguments that say who meets whom, as `stoss restitution` and `stoss table` take them. */
export function encounterArguments(encounter: Encounter): string[] {
  const { kind, against } = encounter;
  const [first, second] = sidesOf(encounter);
  const other = second ? [second.kind.name, ...pairsOf(second).map((pair) => pair.join('='))].join(',') : against.kind;
  return [
    ...(kind === 'disk' ? [] : ['--body', kind]),
    ...pairsOf(first).flatMap(([key, value]) => [`--${key.replace('_', '-')}`, value]),
    ...(first.strain ? ['--plane', 'strain'] : []),
    ...(other === 'wall' ? [] : ['--against', other]),
  ];
}

/** The arguments of `stoss restitution` for ε at one speed. */
export function commandArguments(encounter: Encounter, speed: string, tolerance: number): string[] {
  const line = ['restitution', ...encounterArguments(encounter), '--speed', speed];
  return tolerance === 1e-3 ? line : [...line, '--tolerance', shortest(tolerance)];
}

/** The command line, to be pasted into a shell. */
export function commandLine(encounter: Encounter, speed: number, tolerance = 1e-3): string {
  return ['stoss', ...commandArguments(encounter, shortest(speed), tolerance)].join(' ');
}
