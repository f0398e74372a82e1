// The swings of the cradle as ideal pendulums of one length, which all come back to the bottom at once, and the flights of
// two balls that fall. Collisions, which last microseconds, are instants at the bottom.
import { gravity } from '../inputs/inputs';

/** Half of a swing, s: from the bottom, out, and back. */
export const halfPeriod = (length: number): number => Math.PI * Math.sqrt(length / gravity);

/** The velocities at the bottom: those with which the balls come at first, and those after each collision. */
export interface Swings {
  half: number;
  velocities: readonly (readonly number[])[];
}

/** From when to when: the first ball falls for a quarter of a swing, and every later velocity carries half of one. */
export const spanOf = ({ half, velocities }: Swings) => ({ from: -half / 2, to: (velocities.length - 1) * half });

/** How many collisions are over at a time. */
export function collisionsAt({ half, velocities }: Swings, time: number): number {
  return Math.min(velocities.length - 1, Math.max(0, 1 + Math.floor(time / half)));
}

/** How far each ball is out to the right, over that of a ball with the velocity 1 at its farthest. */
export function outAt(swings: Swings, time: number): number[] {
  const count = collisionsAt(swings, time);
  const since = time - Math.max(0, count - 1) * swings.half;
  return swings.velocities[count]!.map((velocity) => velocity * Math.sin((Math.PI * since) / swings.half));
}

/** Heights above the floor at which two balls touch each other and the floor, from which they fly. */
export interface Fall {
  /** down, and after, up; m/s */
  speed: number;
  after: readonly number[];
}

/** From when to when: the fall, and until the upper ball is at its highest or the lower one is back on the floor. */
export function fallSpan({ speed, after: [upper = 0, lower = 0] }: Fall) {
  const back = lower > 0 ? (2 * lower) / gravity : Infinity;
  return { from: -speed / gravity, to: Math.max(0.5 * (speed / gravity), Math.min(upper > 0 ? upper / gravity : 0, back)) };
}

/** Heights of both balls above where they are in the collision. */
export function heightsAt({ speed, after }: Fall, time: number): number[] {
  return after.map((up) => (time < 0 ? -speed * time : up * time) - 0.5 * gravity * time ** 2);
}
