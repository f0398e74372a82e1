// Units of the results in SI, and the same encounter in other units.
import type { Body, Encounter } from '../core/protocol';
import { type Inputs, secondBody, withSecond } from './inputs';
import { madeOf, materials } from './materials';

/** Modulus that counts in the plane of a disk: E, or E/(1−ν²) in plane strain. */
export function modulus(encounter: Encounter, body: Body): number {
  const strain = encounter.kind === 'disk' && encounter.si && encounter.plane === 'strain';
  return strain ? body.young / (1 - body.poisson ** 2) : body.young;
}

/** 2-D Poisson's ratio of a disk in SI, ν or in plane strain ν/(1−ν); ν of other bodies. */
export function planePoisson(encounter: Encounter, body: Body): number {
  const strain = encounter.kind === 'disk' && encounter.si && encounter.plane === 'strain';
  return strain ? body.poisson / (1 - body.poisson) : body.poisson;
}

/** Bar speed c = √(E/ρ) of the first body: 1 without SI, else m/s. */
export function barSpeed(encounter: Encounter): number {
  if (!encounter.si) return 1;
  return Math.sqrt(modulus(encounter, encounter.first) / encounter.first.density);
}

/** R/c of the first body in s. */
export function barTime(encounter: Encounter): number {
  return encounter.si ? encounter.first.radius / barSpeed(encounter) : 1;
}

/** The same impact in units of the first body: ε stays what it is. */
export function withoutSi(inputs: Inputs): Inputs {
  const { encounter } = inputs;
  if (!encounter.si) return inputs;
  const { first } = encounter;
  const time = barTime(encounter);
  const ratios = (body: Body): Body => ({
    poisson: rounded(planePoisson(encounter, body)),
    radius: rounded(body.radius / first.radius),
    young: rounded(modulus(encounter, body) / modulus(encounter, first)),
    density: rounded(body.density / first.density),
    area: rounded(body.area / first.area),
    lossTime: rounded(body.lossTime / time),
  });
  const next = withSecond({ ...encounter, first: ratios(first) }, ratios);
  return {
    ...inputs,
    encounter: { ...next, si: false, plane: 'stress' },
    speed: rounded(inputs.speed / barSpeed(encounter)),
  };
}

/** Another encounter at the same speed; where that is out of its range, at the same share of its bar speed. */
export function withEncounter(inputs: Inputs, encounter: Encounter): Inputs {
  const c = barSpeed(encounter);
  const allowed = inputs.speed >= 1e-8 * c && inputs.speed <= c;
  if (allowed || !(c > 0)) return { ...inputs, encounter };
  return { ...inputs, encounter, speed: Number(((inputs.speed / barSpeed(inputs.encounter)) * c).toPrecision(3)) };
}

const [steel] = materials;

/** The same impact in SI: the first body becomes steel of 1 cm with its own Poisson's ratio, and ε stays what it is. */
export function withSi(inputs: Inputs): Inputs {
  const { encounter } = inputs;
  if (encounter.si || steel === undefined) return inputs;
  const bodies = [encounter.first, secondBody(encounter.against)].filter((body) => body !== undefined);
  const strain = encounter.kind === 'disk' && bodies.some((body) => body.poisson >= 0.5);
  const plane = strain ? 'strain' : 'stress';
  const solid = (poisson: number): number => (strain ? rounded(poisson / (1 + poisson)) : poisson);
  const reference = madeOf(steel, { ...encounter.first, radius: 0.01, area: 1e-4 });
  const first = { ...reference, poisson: solid(encounter.first.poisson) };
  const inSi: Encounter = { ...encounter, si: true, plane, first };
  const time = barTime(inSi);
  const values = (body: Body): Body => {
    const poisson = solid(body.poisson);
    const planeYoung = body.young * modulus(inSi, first);
    return {
      poisson,
      radius: rounded(body.radius * first.radius),
      young: rounded(strain ? planeYoung * (1 - poisson ** 2) : planeYoung),
      density: rounded(body.density * first.density),
      area: rounded(body.area * first.area),
      lossTime: rounded(body.lossTime * time),
    };
  };
  const lossy = { ...inSi, first: { ...first, lossTime: rounded(encounter.first.lossTime * time) } };
  return { ...inputs, encounter: withSecond(lossy, values), speed: rounded(inputs.speed * barSpeed(inSi)) };
}

/** To six digits, so that a field stays readable. */
function rounded(value: number): number {
  return Number(value.toPrecision(6));
}
