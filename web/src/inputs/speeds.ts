// The speeds of the slider and of the curve: logarithmic, up to where linear elasticity loses its meaning.
import type { Body, Encounter } from '../core/protocol';
import { barSpeed, modulus } from './scales';

/** In c of the first body. */
export const slowest = 1e-6;

/** In c of the first body: half of the wave speed, for a soft half-space of its own, which is pressed in the faster the
 *  more of the compression is its. */
export function fastest(encounter: Encounter): number {
  const { first, against, kind } = encounter;
  const half = 0.5;
  if (against.kind !== 'half-space') return half;
  const stiff = (body: Body): number => modulus(encounter, body) / (kind === 'sphere' ? 1 - body.poisson ** 2 : 1);
  const share = stiff(first) / (stiff(first) + stiff(against.body));
  const slower = Math.sqrt((modulus(encounter, first) * against.body.density) /
    (modulus(encounter, against.body) * first.density));
  return half / Math.max(1, share * slower);
}

/** Steps of the slider. */
export const steps = 1000;

/** The speed at a place 0 … steps of the slider, to three digits. */
export function speedAt(encounter: Encounter, place: number): number {
  const speed = barSpeed(encounter) * slowest * (fastest(encounter) / slowest) ** (place / steps);
  return Number(speed.toPrecision(3));
}

/** The nearest place of the slider to a speed; its end for one beyond. */
export function placeOf(encounter: Encounter, speed: number): number {
  const share = Math.log(speed / barSpeed(encounter) / slowest) / Math.log(fastest(encounter) / slowest);
  return Math.round(Math.min(Math.max(share, 0), 1) * steps);
}

/** Speeds of the curve, in an order that fills the range ever more densely. */
export function curveSpeeds(encounter: Encounter, count = 49): number[] {
  const speeds = Array.from({ length: count }, (_, index) => {
    const speed = barSpeed(encounter) * slowest * (fastest(encounter) / slowest) ** (index / (count - 1));
    return Number(speed.toPrecision(4));
  });
  const order: number[] = [];
  for (let stride = 2 ** Math.ceil(Math.log2(count)); stride >= 1; stride /= 2) {
    for (let index = 0; index < count; index += stride) if (!order.includes(index)) order.push(index);
  }
  return order.map((index) => speeds[index] ?? 0);
}

/** A speed of one encounter on the axis of another: as it is if both are in SI or neither, else the same share of c. */
export function onAxisOf(axis: Encounter, encounter: Encounter, speed: number): number {
  return axis.si === encounter.si ? speed : (speed / barSpeed(encounter)) * barSpeed(axis);
}
