// An encounter in a few words.
import type { Body, Encounter } from '../core/protocol';
import { prefixed, significant } from './digits';
import { secondBody } from './inputs';
import { materialOf } from './materials';

/** Who meets whom, in one line: disk ν 0.33; steel sphere 10 mm at a glass half-space. */
export function description(encounter: Encounter): string {
  const { kind, against } = encounter;
  const first = bodyText(encounter, encounter.first, kind, encounter.si);
  const second = secondBody(against);
  if (against.kind === 'wall') return first;
  if (against.kind === 'same' || second === undefined) return `${first} at an identical one`;
  const name = against.kind === 'body' ? kind : kind === 'disk' ? 'half-plane' : 'half-space';
  return `${first} at ${bodyText(encounter, second, name, against.kind === 'body')}`;
}

function bodyText(encounter: Encounter, body: Body, name: string, sized: boolean): string {
  const { si, kind, plane } = encounter;
  const material = si ? materialOf(body, kind)?.name : undefined;
  const parts = [material === undefined ? name : `${material} ${name}`];
  if (material === undefined && kind !== 'rod') parts.push(`ν ${significant(body.poisson, 4)}`);
  if (material === undefined && (si || body !== encounter.first)) {
    const young = prefixed(body.young, si ? 'Pa' : '');
    parts.push(`E ${significant(body.young * young.factor, 3)}${si ? ` ${young.unit}` : ''}`);
  }
  if (sized) {
    const size = prefixed(body.radius, si ? 'm' : '');
    const text = `${significant(body.radius * size.factor, 3)} ${size.unit}`.trim();
    parts.push(si ? text : `${kind === 'rod' ? 'L' : 'R'} ${significant(body.radius, 3)}`);
  }
  if (material === undefined && body.lossTime !== 0) parts.push(`η ${significant(body.lossTime, 3)}`);
  if (si && kind === 'disk' && plane === 'strain' && body === encounter.first) parts.push('plane strain');
  return parts.join(' ');
}
