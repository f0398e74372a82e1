// An encounter in a few words.
import type { Body, Encounter } from '../core/protocol';
import { prefixFor } from '../drawing/numbers';
import { significant } from './digits';
import { materialOf, secondOf } from './document';
import { type Kind, kindNamed } from './kinds';

/** Who meets whom, in one line: disk ν 0.33; steel sphere 10 mm at a glass half-space. */
export function description(encounter: Encounter): string {
  const { kind, against, si } = encounter;
  const first = bodyText(encounter, encounter.first, kindNamed(kind), si);
  const second = secondOf(encounter);
  if (against.kind === 'wall') return first;
  if (!second) return `${first} at an identical one`;
  return `${first} at ${bodyText(encounter, second.body, second.kind, second.kind.bounded)}`;
}

function bodyText(encounter: Encounter, body: Body, kind: Kind, sized: boolean): string {
  const { si, plane } = encounter;
  const own = body === encounter.first;
  const has = (name: string): boolean => kind.parameters.some((each) => each.name === name);
  const material = si ? materialOf(body, kind)?.name : undefined;
  const parts = [material === undefined ? kind.name : `${material} ${kind.name}`];
  if (material === undefined && has('poisson')) parts.push(`ν ${significant(body.poisson, 4)}`);
  if (material === undefined && (si || !own)) parts.push(`E ${withPrefix(body.young, si ? 'Pa' : '')}`);
  if (sized) {
    const size = has('length') ? body.length : body.radius;
    parts.push(si ? withPrefix(size, 'm') : `${kind.length} ${significant(size, 3)}`);
  }
  if (material === undefined && body.loss_time !== 0) parts.push(`η ${significant(body.loss_time, 3)}`);
  if (si && kind.hasPlane && plane === 'strain' && own) parts.push('plane strain');
  return parts.join(' ');
}

function withPrefix(value: number, unit: string): string {
  const prefix = prefixFor(value, unit);
  return `${significant(value / prefix.size, 3)} ${prefix.unit}`.trim();
}
