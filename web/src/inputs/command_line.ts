// The command line that gives the same numbers.
import type { Body, Encounter } from '../core/protocol';
import { fieldsOfBody, secondOf, solidOf } from './document';
import { type Kind, kindNamed } from './kinds';
import { shortest } from './number';

/** The numbers of a body by the keys of the command. */
function pairsOf({ si }: Encounter, kind: Kind, body: Body, second: boolean): [string, number][] {
  const all = fieldsOfBody(kind, si, second).filter((name) => name !== 'loss_time');
  const pairs: [string, number][] = all.map((name) => [name, body[name]]);
  const strength = si && kind.canYield ? solidOf(body, kind)?.yield_strength : undefined;
  if (strength !== undefined) pairs.push(['yield', strength]);
  if (body.loss_time !== 0) pairs.push(['loss_time', body.loss_time]);
  return pairs;
}

/** Arguments that say who meets whom, as `stoss restitution` and `stoss table` take them. */
export function encounterArguments(encounter: Encounter): string[] {
  const { kind, si, plane, first, against } = encounter;
  const line: string[] = kind === 'disk' ? [] : ['--body', kind];
  const strain = si && kindNamed(kind).hasPlane && plane === 'strain';
  for (const [key, value] of pairsOf(encounter, kindNamed(kind), first, false)) {
    line.push(`--${key.replace('_', '-')}`, shortest(value));
  }
  if (strain) line.push('--plane', plane);
  const second = secondOf(encounter);
  if (second) {
    const pairs = pairsOf(encounter, second.kind, second.body, true).map(([key, value]) => `${key}=${shortest(value)}`);
    line.push('--against', [second.kind.name, ...pairs].join(','));
  } else if (against.kind !== 'wall') {
    line.push('--against', against.kind);
  }
  return line;
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
