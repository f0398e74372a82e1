// An encounter in a few words.
import type { Encounter } from '../core/protocol';
import { prefixFor } from '../drawing/numbers';
import { significant } from './digits';
import { type Side, sidesOf } from './document';
import { sizeOf } from './kinds';

/** Who meets whom, in one line: disk ν 0.33; steel sphere 10 mm at a glass half-space. */
export function description(encounter: Encounter): string {
  const { against, si } = encounter;
  const [first, second] = sidesOf(encounter);
  const words = inWords(first, si, si);
  if (second) return `${words} at ${inWords(second, si, second.kind.bounded)}`;
  return against.kind === 'wall' ? words : `${words} at an identical one`;
}

function inWords({ kind, body, second, fields, material, strain }: Side, si: boolean, sized: boolean): string {
  const size = kind.bounded ? body[sizeOf(kind.name)] : 0;
  return [
    ...(material ? [`${material.name} ${kind.name}`] : [kind.name]),
    ...(!material && fields.includes('poisson') ? [`ν ${significant(body.poisson, 4)}`] : []),
    ...(!material && (si || second) ? [`E ${withPrefix(body.young, si ? 'Pa' : '')}`] : []),
    ...(sized ? [si ? withPrefix(size, 'm') : `${kind.length} ${significant(size, 3)}`] : []),
    ...(!material && body.loss_time !== 0 ? [`η ${significant(body.loss_time, 3)}`] : []),
    ...(strain && !second ? ['plane strain'] : []),
  ].join(' ');
}

function withPrefix(value: number, unit: string): string {
  const prefix = prefixFor(value, unit);
  return `${significant(value / prefix.size, 3)} ${prefix.unit}`.trim();
}
