// Units of the results in SI, and the same encounter in other units.
import type { Body, Encounter } from '../core/protocol';
import { type Inputs, unitBody, withSecond } from './inputs';
import { madeOf, materialNamed } from './materials';

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

/** What SI begins with: a ball of a bearing of 1 cm, at the speed of a fall from 5 cm. */
export const ball: Body = madeOf(materialNamed('bearing steel'), { ...unitBody, radius: 0.01, area: 1e-4 });
export const siSpeed = 1;

/** Such bodies in SI: the first becomes the ball of a bearing, and a second one keeps its ratios to the first. */
export function withSi(inputs: Inputs): Inputs {
  const { encounter } = inputs;
  if (encounter.si) return inputs;
  const values = (body: Body): Body => {
    const size = { radius: rounded(body.radius * ball.radius), area: rounded(body.area * ball.area) };
    if (body.young === 1 && body.density === 1) return { ...ball, ...size };
    return {
      ...size,
      poisson: Math.min(body.poisson, ball.poisson),
      young: rounded(body.young * ball.young),
      density: rounded(body.density * ball.density),
      lossTime: rounded((body.lossTime * ball.radius) / Math.sqrt(ball.young / ball.density)),
    };
  };
  const inSi = withSecond({ ...encounter, si: true, plane: 'stress', first: ball }, values);
  return { ...inputs, encounter: inSi, speed: siSpeed };
}

/** To six digits, so that a field stays readable. */
function rounded(value: number): number {
  return Number(value.toPrecision(6));
}
