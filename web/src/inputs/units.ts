// The same encounter in other units: what they are, the core says.
import { unitsOf } from '../core/local';
import type { Body, Elastic, Encounter } from '../core/protocol';
import { type Inputs, ball, siSpeed, withSecond } from './inputs';
import { sizeOf } from './kinds';

/** c of the first body: 1 without SI, else m/s. */
export function barSpeed(encounter: Encounter): number {
  return unitsOf(encounter).speed;
}

/** The same impact in units of the first body: ε stays what it is. */
export function withoutSi(inputs: Inputs): Inputs {
  const { encounter } = inputs;
  if (!encounter.si) return inputs;
  const { first } = encounter;
  const units = unitsOf(encounter);
  const ratios = (body: Body, { young, poisson = body.poisson }: Elastic): Body => ({
    young: rounded(young),
    poisson: rounded(poisson),
    density: rounded(body.density / first.density),
    radius: rounded(body.radius / first.radius),
    length: rounded(body.length / first.length),
    area: rounded(body.area / first.area),
    loss_time: rounded(body.loss_time / units.time),
  });
  const next = withSecond({ ...encounter, first: ratios(first, units.first) },
    (body) => ratios(body, units.second ?? units.first));
  return {
    ...inputs,
    encounter: { ...next, si: false, plane: 'stress' },
    speed: rounded(inputs.speed / units.speed),
  };
}

/** Such bodies in SI: the first becomes the ball of a bearing, and a second one keeps its ratios to the first. */
export function withSi(inputs: Inputs): Inputs {
  const { encounter } = inputs;
  if (encounter.si) return inputs;
  const inSi: Encounter = { ...encounter, si: true, plane: 'stress', first: ball };
  const { time } = unitsOf({ ...inSi, against: { kind: 'wall' } });
  const values = (body: Body): Body => {
    const size = sizeOf(encounter.kind);
    const sizes = { [size]: rounded(body[size] * ball[size]), area: rounded(body.area * ball.area) };
    if (body.young === 1 && body.density === 1) return { ...ball, ...sizes };
    return {
      ...ball,
      ...sizes,
      poisson: Math.min(body.poisson, ball.poisson),
      young: rounded(body.young * ball.young),
      density: rounded(body.density * ball.density),
      loss_time: rounded(body.loss_time * time),
    };
  };
  return { ...inputs, encounter: withSecond(inSi, values), speed: siSpeed };
}

/** To six digits, so that a field stays readable. */
function rounded(value: number): number {
  return Number(value.toPrecision(6));
}
