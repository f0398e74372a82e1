// A ball that hops between a floor and the underside of a table: free flight with gravity from one collision to the
// next. x to the right, y up, spin counterclockwise; SI.

export interface Flight {
  time: number;
  /** of the centre */
  x: number;
  y: number;
  vx: number;
  vy: number;
  /** by which it has turned, radians */
  angle: number;
  spin: number;
}

/** What the ball hops in; heights above the floor. */
export interface Room {
  radius: number;
  table: number;
  hand: number;
}

export type Surface = 'floor' | 'table';

/** Standard gravity, m/s². */
export const gravity = 9.80665;

const TALLEST = 0.7; // m, of a table

/** A room whose table the ball reaches with some speed, unless it is as low as a few balls. */
export function roomOf(radius: number, speed: number): Room {
  const table = Math.max(4 * radius, Math.min(TALLEST, (0.55 * speed ** 2) / (2 * gravity)));
  return { radius, table, hand: 0.7 * table };
}

/** A flight some seconds later, or earlier. */
export function flown({ time, x, y, vx, vy, angle, spin }: Flight, seconds: number): Flight {
  return {
    time: time + seconds, x: x + vx * seconds, y: y + (vy - 0.5 * gravity * seconds) * seconds, vx,
    vy: vy - gravity * seconds, angle: angle + spin * seconds, spin,
  };
}

/** The seconds after which a flight that goes up, or down, passes a height; NaN where it does not get there. */
function until({ y, vy }: Flight, height: number, up: boolean): number {
  const root = Math.sqrt(vy * vy - 2 * gravity * (height - y));
  return (vy - (up ? root : -root)) / gravity;
}

/** Where a flight ends: at the table if it gets there, else on the floor. */
export function landing(flight: Flight, { radius, table }: Room): { flight: Flight; surface: Surface } {
  const rise = flight.vy > 0 ? until(flight, table - radius, true) : NaN;
  if (rise > 0) return { flight: flown(flight, rise), surface: 'table' };
  return { flight: flown(flight, until(flight, radius, false)), surface: 'floor' };
}

/** The flight before the first collision, which is on the floor and at the time 0, from the hand's height or its own
 *  apex. */
export function thrown(speed: number, angle: number, spin: number, { radius, hand }: Room): Flight {
  const tangential = speed * Math.tan((angle * Math.PI) / 180);
  const struck: Flight = { time: 0, x: 0, y: radius, vx: tangential, vy: -speed, angle: 0, spin };
  const back = until({ ...struck, vy: speed }, hand, true);
  return flown(struck, -(Number.isNaN(back) ? speed / gravity : back));
}

/** How a ball meets a surface: on the floor the normal points down and what is along it to the right, at the table up
 *  and to the left; the spin is the same. Angle in degrees. */
export function meeting({ vx, vy, spin }: Flight, surface: Surface) {
  const along = surface === 'floor' ? vx : -vx;
  return { speed: Math.abs(vy), angle: (180 / Math.PI) * Math.atan2(along, Math.abs(vy)), spin };
}

/** The flight after a collision by its rule: the speed along the normal over that before, and what is along the
 *  surface. */
export function bounced(
  flight: Flight, surface: Surface, rule: { restitution: number; tangential: number; spin: number },
): Flight {
  const side = surface === 'floor' ? 1 : -1;
  return { ...flight, vx: side * rule.tangential, vy: side * rule.restitution * Math.abs(flight.vy), spin: rule.spin };
}
