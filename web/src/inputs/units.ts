// The same encounter in other units: what they are, the core says.
import { unitsOf } from '../core/local';
import type { Body, Elastic, Encounter } from '../core/protocol';
import { rounded } from '../drawing/numbers';
import { type Inputs, ball, siSpeed } from './inputs';
import type { BodyField } from './kinds';

/** c of the first body: 1 without SI, else m/s. */
export function barSpeed(encounter: Encounter): number {
  return unitsOf(encounter).speed;
}

/** The numbers of a body changed by a function, to six digits, so that a field stays readable. */
function changed(body: Body, change: (value: number, name: BodyField) => number): Body {
  return Object.fromEntries(Object.entries(body).map(([name, value]) =>
    [name, rounded(change(value, name as BodyField), 6)])) as Body;
}

/** The same impact in units of the first body: ε stays what it is. */
export function withoutSi(inputs: Inputs): Inputs {
  const { encounter } = inputs;
  if (!encounter.si) return inputs;
  const { first, second } = encounter;
  const units = unitsOf(encounter);
  const ratios = (body: Body, { young, poisson = body.poisson }: Elastic): Body => {
    const own: Partial<Body> = { young, poisson, loss_time: body.loss_time / units.time };
    return changed(body, (value, name) => own[name] ?? value / first[name]);
  };
  return {
    ...inputs,
    encounter: {
      ...encounter, si: false, plane: 'stress', first: ratios(first, units.first),
      second: ratios(second, units.second ?? units.first),
    },
    speed: rounded(inputs.speed / units.speed, 6),
  };
}

/** Such bodies in SI: the first becomes the ball of a bearing, and a second one keeps its ratios to the first. */
export function withSi(inputs: Inputs): Inputs {
  const { encounter } = inputs;
  if (encounter.si) return inputs;
  const { poisson, loss_time } = ball;
  const inSi: Encounter = { ...encounter, si: true, plane: 'stress', first: ball };
  const { time } = unitsOf({ ...inSi, against: 'wall' });
  const { second } = encounter;
  const loss = second.young === 1 && second.density === 1 ? { poisson, loss_time }
    : { poisson: Math.min(second.poisson, poisson), loss_time: rounded(second.loss_time * time, 6) };
  const values = { ...changed(second, (value, name) => value * ball[name]), ...loss };
  return { ...inputs, encounter: { ...inSi, second: values }, speed: siSpeed };
}
