// The same encounter in other units, which the core knows; and the speeds of the slider and of the curve: logarithmic,
// up to where linear elasticity loses its meaning.
import { scaleLog } from 'd3-scale';
import { seriesOf, unitsOf } from '../core/local';
import type { Elastic, Encounter } from '../core/protocol';
import { rounded, shortest } from '../drawing/numbers';
import { type Body, type Choice, ball, encounterOf, meetingOf } from './document';
import { type Inputs, type View, dropOf, siSpeed, speedOf } from './inputs';
import { type NumberField, blockOf, isBlock, isFaceName, isShare, lengthOf, sizeOf } from './kinds';

/** c of the first body: 1 without SI, else m/s. */
export function barSpeed(encounter: Encounter): number {
  return unitsOf(encounter).speed;
}

/** The numbers of a body changed by a function, and the times of its relaxation by a factor, to six digits, so that a field
 *  stays readable. */
function changed({ relaxation, ...numbers }: Body, change: (value: number, name: NumberField) => number, time: number): Body {
  return {
    ...Object.fromEntries(Object.entries(numbers).map(([name, value]) =>
      [name, rounded(change(value, name as NumberField), 6)])) as Omit<Body, 'relaxation'>,
    relaxation: relaxation.map(([share, each]) => [share, rounded(each * time, 6)]),
  };
}

/** The unit of what is of a face; undefined of all else. */
function unitOfFace(name: NumberField, length: number, modulus: number): number | undefined {
  if (!isFaceName(name)) return undefined;
  return ['coat_young', 'yield_strength'].includes(name) ? modulus : ['roughness', 'coat'].includes(name) ? length : 1;
}

/** The same impact in units of the first body: ε stays what it is. */
export function withoutSi(inputs: Inputs): Inputs {
  const { first, second, ...choice } = meetingOf(inputs.encounter);
  if (!choice.si) return inputs;
  // Those of the spheres that stand in for files.
  const units = unitsOf(encounterOf(choice, first.body, second?.body));
  const block = blockOf(choice.kind, choice.against);
  const thickness = block && lengthOf(block);
  const ratios = (body: Body, { young, poisson = body.poisson }: Elastic): Body => {
    const size = first.body[sizeOf(choice.kind)];
    const own: Partial<Record<NumberField, number>> = { young, poisson, loss_time: body.loss_time / units.time, quality: body.quality };
    const unitOf = (name: NumberField): number =>
      isShare(name) ? 1 : unitOfFace(name, size, units.modulus!) ?? (name === thickness ? size : first.body[name]);
    return changed(body, (value, name) => own[name] ?? value / unitOf(name), 1 / units.time);
  };
  return {
    ...inputs,
    encounter: encounterOf({ ...choice, si: false, plane: 'stress' }, ratios(first.body, units.first),
      second && ratios(second.body, units.second!)),
    speed: rounded(inputs.speed / units.speed, 6),
    spin: rounded(inputs.spin * units.time, 6),
    second_spin: rounded(inputs.second_spin * units.time, 6),
  };
}

/** A body beside the ball of a bearing whose E(0) has this ratio to that of the ball: with a quality, as the ball has one,
 *  the modulus in SI is the one at 10 kHz. */
function ofModulus(choice: Choice, body: Body, ratio: number): Body {
  let its = body;
  const rounds = 5; // each takes away most of what is wrong
  for (let round = 0; round < rounds; ++round) {
    its = { ...its, young: its.young * ratio / unitsOf(encounterOf(choice, ball, its)).second!.young };
  }
  return { ...its, young: rounded(its.young, 6) };
}

/** Such bodies in SI: the first becomes the ball of a bearing, and a second one keeps its ratios to the first. */
export function withSi(inputs: Inputs): Inputs {
  const { first, second, ...choice } = meetingOf(inputs.encounter);
  if (choice.si) return inputs;
  const si: Choice = { ...choice, si: true, plane: 'stress' };
  const its = { ...ball, inner: first.body.inner };
  const { poisson, loss_time, quality, relaxation } = ball;
  const { time, modulus } = unitsOf(encounterOf({ ...si, against: 'wall' }, ball));
  const unitOf = (name: NumberField): number => unitOfFace(name, ball[sizeOf(choice.kind)], modulus!) ?? ball[name];
  const inSi = (body: Body): Body => ({
    ...changed(body, (value, name) => (name === 'quality' || isShare(name) ? value : value * unitOf(name)), time),
    ...(body.young === 1 && body.density === 1 ? { poisson, loss_time, quality, relaxation }
      : { poisson: Math.min(body.poisson, poisson), loss_time: rounded(body.loss_time * time, 6) }),
  });
  const [spin, second_spin] = [inputs.spin, inputs.second_spin].map((each) => rounded(each / time, 6)) as [number, number];
  return { ...inputs, encounter: encounterOf(si, its, second && ofModulus(si, inSi(second.body), second.body.young)), speed: siSpeed, spin, second_spin };
}

/** In c of the first body. */
export const slowest = 1e-6;

/** In c of the first body: half of the wave speed, for a soft half-space of its own, which is pressed in the faster the
 *  more of the compression is its. */
export function fastest(encounter: Encounter): number {
  const half = 0.5;
  const { first, second } = unitsOf(encounter);
  const { kind, si, against, ...its } = meetingOf(encounter);
  if (!isBlock(against) || !second) return half;
  const sphere = kind !== 'disk';
  const stiff = ({ young, poisson = 0 }: Elastic): number => young / (sphere ? 1 - poisson ** 2 : 1);
  const share = stiff(first) / (stiff(first) + stiff(second));
  const slower = Math.sqrt(its.second!.body.density / (si ? its.first.body.density : 1) / second.young);
  return half / Math.max(1, share * slower);
}

/** Steps of the slider. */
export const steps = 1000;

/** The ends of the slider and of a curve, as the page gives speeds. */
export function endsOf(encounter: Encounter): [number, number] {
  const c = barSpeed(encounter);
  return [rounded(slowest * c, 4), rounded(fastest(encounter) * c, 4)];
}

/** Drop heights in m in a classroom. */
const drops = [0.01, 10] as const;

const slider = (encounter: Encounter, view: View) =>
  scaleLog(view === 'ball' ? drops.map(speedOf) : endsOf(encounter), [0, steps]).clamp(true);

/** The speed at a place 0 … steps of the slider, to three digits; of a real ball its drop height, to two. */
export function speedAt(encounter: Encounter, place: number, view: View = 'full'): number {
  const speed = slider(encounter, view).invert(place);
  return view === 'ball' ? speedOf(rounded(dropOf(speed), 2)) : rounded(speed, 3);
}

/** The nearest place of the slider to a speed; its end for one beyond. */
export function placeOf(encounter: Encounter, speed: number, view: View = 'full'): number {
  return Math.round(slider(encounter, view)(speed));
}

/** The series of a curve that nobody has typed. */
export function usualSeries(encounter: Encounter, count = 49): string {
  return `log:${endsOf(encounter).map(shortest).join(':')}:${count}`;
}

/** Speeds of the curve, those of a series, in an order that fills the range ever more densely. Throws CoreError for a
 *  text that is none. */
export function curveSpeeds(encounter: Encounter, series = ''): number[] {
  const usual = series.trim() === '';
  const speeds = seriesOf(usual ? usualSeries(encounter) : series)
    .map((speed) => (usual ? rounded(speed, 4) : speed));
  return coarseFirst(speeds);
}

/** Values in an order that fills their range ever more densely, each once. */
export function coarseFirst(values: readonly number[]): number[] {
  const order = new Set<number>();
  for (let stride = 2 ** Math.ceil(Math.log2(values.length)); stride >= 1; stride /= 2) {
    for (let index = 0; index < values.length; index += stride) order.add(values[index]!);
  }
  return [...order];
}

/** A speed of one encounter on the axis of another: as it is if both are in SI or neither, else the same share of c. */
export function onAxisOf(axis: Encounter, encounter: Encounter, speed: number): number {
  return meetingOf(axis).si === meetingOf(encounter).si ? speed : (speed / barSpeed(encounter)) * barSpeed(axis);
}
