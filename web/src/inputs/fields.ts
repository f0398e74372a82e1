// The numbers a user types: which of them an encounter has, what they are called, and in what unit.
import type { Body, Encounter } from '../core/protocol';
import { secondBody, withSecond } from './inputs';

export type BodyField = keyof Body;

/** A number of the first body, of what it meets, or the speed. */
export type Field = BodyField | `${BodyField}2` | 'speed';

export const bodyFields: readonly BodyField[] = ['poisson', 'young', 'density', 'radius', 'area', 'lossTime'];

/** The fields that count in an encounter, in the order of the page. */
export function fieldsOf(encounter: Encounter): Field[] {
  const { kind, si, against } = encounter;
  const material: BodyField[] = kind === 'rod' ? ['young', 'density'] : ['poisson', 'young', 'density'];
  const size: BodyField[] = kind === 'rod' ? ['radius', 'area'] : ['radius'];
  const first: BodyField[] = si ? [...material, ...size] : kind === 'rod' ? [] : ['poisson'];
  const fields: Field[] = [...first, 'lossTime'];
  if (against.kind === 'body') fields.push(...[...material, ...size, 'lossTime' as const].map(ofSecond));
  if (against.kind === 'half-space') fields.push(...[...material, 'lossTime' as const].map(ofSecond));
  return [...fields, 'speed'];
}

export function ofSecond(field: BodyField): `${BodyField}2` {
  return `${field}2`;
}

/** The name a field has in the body that owns it, and whether that is the second one; undefined for the speed. */
export function owner(field: Field): { second: boolean; name: BodyField } | undefined {
  if (field === 'speed') return undefined;
  const second = field.endsWith('2');
  return { second, name: (second ? field.slice(0, -1) : field) as BodyField };
}

/** The number of a field in the inputs. */
export function valueOf(encounter: Encounter, speed: number, field: Field): number {
  const place = owner(field);
  if (place === undefined) return speed;
  const body = place.second ? secondBody(encounter.against) : encounter.first;
  return (body ?? encounter.first)[place.name];
}

/** The encounter with another number in one field of a body. */
export function withValue(encounter: Encounter, field: Exclude<Field, 'speed'>, value: number): Encounter {
  const place = owner(field);
  if (place === undefined) return encounter;
  if (!place.second) return { ...encounter, first: { ...encounter.first, [place.name]: value } };
  return withSecond(encounter, (body) => ({ ...body, [place.name]: value }));
}

/** The name of a field next to its number. */
export function labelOf(encounter: Encounter, field: Field): string {
  const place = owner(field);
  if (place === undefined) return 'Speed of approach v';
  const { name, second } = place;
  const ratio = second && !encounter.si;
  const plane = encounter.kind === 'disk' && !encounter.si;
  const symbol = (letter: string): string => (ratio ? `${letter}₂/${letter}₁` : letter);
  const rod = encounter.kind === 'rod';
  const labels: Record<BodyField, string> = {
    poisson: plane ? '2‑D Poisson’s ratio ν' : 'Poisson’s ratio ν',
    young: `${ratio ? 'Modulus' : 'Young’s modulus'} ${symbol('E')}`,
    density: `Density ${symbol('ρ')}`,
    radius: rod ? `Length ${symbol('L')}` : `Radius ${symbol('R')}`,
    area: `Cross-section ${symbol('A')}`,
    lossTime: 'Loss time η',
  };
  return labels[name];
}

/** The unit behind a field; '' for a pure number. */
export function unitOf(encounter: Encounter, field: Field): string {
  const place = owner(field);
  const { si } = encounter;
  if (place === undefined) return si ? 'm/s' : 'c';
  const size = encounter.kind === 'rod' ? 'L' : 'R';
  const inSi: Record<BodyField, string> = {
    poisson: '', young: 'Pa', density: 'kg/m³', radius: 'm', area: 'm²', lossTime: 's',
  };
  if (si) return inSi[place.name];
  return place.name === 'lossTime' ? `${size}/c` : '';
}
