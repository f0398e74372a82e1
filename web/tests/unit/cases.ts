// A dozen encounters, of every kind and in both systems of units.
import type { Encounter } from '../../src/core/protocol';
import { type Inputs, defaults } from '../../src/inputs/inputs';
import { type Body, type Choice, encounterOf, madeOf, meetingOf, unitBody } from '../../src/inputs/document';
import { materialNamed } from '../../src/inputs/kinds';

/** Another encounter like one, of other choices or numbers. */
export function like(encounter: Encounter, { first, second, ...choice }: Partial<Choice & Record<'first' | 'second', Body>>) {
  const its = meetingOf(encounter);
  return encounterOf({ ...its, ...choice }, first ?? its.first.body, second ?? its.second?.body);
}

export const made = (name: string, size: number): Body =>
  madeOf(materialNamed(name), { ...unitBody, radius: size, length: size, area: 1e-4 });
const ratios = (numbers: Partial<Body>): Body => ({ ...unitBody, ...numbers });
const disk = defaults.encounter;
const sphere = like(disk, { kind: 'sphere', first: ratios({ poisson: 0.3 }) });
const rod = like(disk, { kind: 'rod' });
const ball = made('bearing steel', 0.005);
const own: Body = {
  ...unitBody, poisson: 0.25, young: 1.5e11, density: 5000, radius: 0.004, length: 0.004, area: 2e-4, thickness: 0.03, loss_time: 1e-9,
};

const of = (encounter: Encounter, speed: number, kept: Encounter[] = []): Inputs =>
  ({ ...defaults, encounter, speed, kept });

export const cases: readonly Inputs[] = [
  of(disk, 0.1),
  of(like(disk, { first: ratios({ poisson: -0.5, loss_time: 0.01 }), against: 'same' }), 0.02, [disk, sphere]),
  of(like(disk, { against: 'body', second: ratios({ poisson: 0.2, radius: 0.5, young: 2, density: 3 }) }), 0.1),
  of(like(disk, { against: 'half-space', second: ratios({ poisson: 0.2, young: 0.5, loss_time: 0.02 }) }), 0.05),
  of(sphere, 0.01),
  of(like(sphere, { against: 'body', second: { ...unitBody, poisson: 0.4, radius: 2, loss_time: 0.1 } }), 0.01),
  of(like(rod, { against: 'body', second: { ...unitBody, length: 2.5, density: 3, area: 0.5 } }), 0.1),
  of(like(disk, { si: true, plane: 'strain', first: made('structural steel', 0.01) }), 5),
  of(like(disk, { si: true, first: own, against: 'body', second: made('brass', 0.02) }), 3),
  of(like(disk, { si: true, first: made('PMMA', 0.03), plane: 'strain', against: 'half-space', second: own }), 1),
  of(like(sphere, { si: true, first: ball, against: 'half-space', second: made('glass', 1) }), 1),
  of(like(sphere, { si: true, first: own, against: 'same' }), 0.2),
  of(like(rod, { si: true, first: made('aluminium', 0.5), against: 'body', second: made('structural steel', 0.3) }), 1),
  of(like(sphere, { against: 'plate', second: ratios({ poisson: 0.2, thickness: 2, young: 0.5 }) }), 0.1),
  of(like(disk, { si: true, first: made('structural steel', 0.01), plane: 'strain', against: 'plate', second: own }), 1),
  of(like(sphere, { si: true, first: ball, against: 'plate', second: { ...made('glass', 1), thickness: 0.01 } }), 1),
  of(like(sphere, { first: ratios({ poisson: 0.3, quality: 30 }), against: 'half-space', second: ratios({ young: 0.5, loss_time: 0.02 }) }), 0.01),
  of(like(sphere, { si: true, first: { ...ball, quality: 50 }, against: 'half-space', second: { ...own, loss_time: 0, quality: 12 } }), 1),
  of(like(sphere, {
    first: ratios({ poisson: 0.3, relaxation: [[0.5, 1], [0.2, 10]], roughness: 0.002 }), against: 'half-space',
    second: ratios({ young: 0.5, coat: 0.001, coat_young: 0.02, coat_poisson: 0.4, coat_quality: 10 }),
  }), 0.01),
  of(like(sphere, {
    si: true, first: { ...ball, roughness: 2.4e-8 }, against: 'plate',
    second: { ...made('glass', 1), thickness: 0.01, roughness: 1e-7, coat: 1e-6, coat_young: 2e9 },
  }), 1),
  of(like(sphere, { kind: 'hollow-sphere', first: ratios({ poisson: 0.3, inner: 0.8 }) }), 0.01),
  of(like(sphere, {
    kind: 'hollow-sphere', first: ratios({ poisson: 0.3, inner: 0.5, loss_time: 0.01 }), against: 'half-space', second: ratios({ young: 0.5 }),
  }), 0.01),
  of(like(sphere, {
    kind: 'hollow-sphere', si: true, first: { ...made('PMMA', 0.02), inner: 0.9 }, against: 'body',
    second: { ...made('structural steel', 0.03), inner: 0.7 },
  }), 0.5),
];

/** Collisions with friction. */
export const obliqueCases: readonly Inputs[] = [
  { ...cases[0]!, friction: 0.3 },
  { ...cases[2]!, friction: 0.2, angle: -20, spin: 0.05, second_spin: -0.1 },
  { ...cases[4]!, friction: 1, angle: 70, spin: -0.02 },
  { ...cases[10]!, friction: 0.1, angle: 30, spin: 200 },
  { ...cases[11]!, friction: 0.4, angle: 10, spin: 5, second_spin: 20 },
  { ...cases[20]!, friction: 0.3, angle: 30 },
];
