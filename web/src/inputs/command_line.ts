// The command line that gives the same numbers.
import type { Body, Encounter } from '../core/protocol';
import { yieldStrengthOf } from './materials';
import { shortest } from './number';

/** Arguments that say who meets whom, as `stoss restitution` and `stoss table` take them. */
export function encounterArguments(encounter: Encounter): string[] {
  const { kind, si, plane, first, against } = encounter;
  const line: string[] = kind === 'disk' ? [] : ['--body', kind];
  const add = (option: string, value: number): void => void line.push(option, shortest(value));
  if (kind !== 'rod') add('--poisson', first.poisson);
  if (si) {
    add('--young', first.young);
    add('--density', first.density);
    add(kind === 'rod' ? '--length' : '--radius', first.radius);
    if (kind === 'rod') add('--area', first.area);
    if (kind === 'disk' && plane === 'strain') line.push('--plane', 'strain');
    const strength = yieldStrengthOf(first, kind);
    if (kind === 'sphere' && strength !== undefined) add('--yield', strength);
  }
  if (first.lossTime !== 0) add('--loss-time', first.lossTime);
  if (against.kind === 'same') line.push('--against', 'same');
  if (against.kind === 'body') line.push('--against', [kind, ...keysOf(encounter, against.body, true)].join(','));
  if (against.kind === 'half-space') {
    const name = kind === 'disk' ? 'half-plane' : 'half-space';
    line.push('--against', [name, ...keysOf(encounter, against.body, false)].join(','));
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

function keysOf(encounter: Encounter, body: Body, sized: boolean): string[] {
  const { kind, si } = encounter;
  const values: [string, number][] = [];
  const strength = si && kind === 'sphere' ? yieldStrengthOf(body, kind) : undefined;
  if (kind !== 'rod') values.push(['poisson', body.poisson]);
  values.push(['young', body.young], ['density', body.density]);
  if (sized) values.push([kind === 'rod' ? 'length' : 'radius', body.radius]);
  if (sized && kind === 'rod') values.push(['area', body.area]);
  if (strength !== undefined) values.push(['yield', strength]);
  if (body.lossTime !== 0) values.push(['loss_time', body.lossTime]);
  return values.map(([key, value]) => `${key}=${shortest(value)}`);
}
