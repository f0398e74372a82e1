// A ball that hops between a floor and the underside of a table: free flight with gravity from one collision to the
// next, and its film. x to the right, y up, spin counterclockwise; SI.
import { bisector, extent } from 'd3-array';
import type { Core, Encounter, Motion } from '../core/protocol';
import { box, cleared, write } from '../drawing/canvas';
import { messageOf } from '../drawing/dom';
import { withUnit, written } from '../drawing/numbers';
import type { Theme } from '../drawing/theme';
import { say } from '../drawing/words';
import { meetingOf } from '../inputs/document';
import { gravity } from '../inputs/inputs';
import { slowness } from './film';
import { drawBody, drawWay } from './oblique_film';
import { type Film, createPlayer } from './player';

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

const IMPACTS = 3;
const TOLERANCE = 1e-2;
const HEIGHT = 300;
const GROUND = 22; // pixels of floor and table

interface Impact {
  flight: Flight;
  words: string;
}

/** The flights of a ball and its impacts, with the end of the last flight. */
async function hop(
  core: Core, encounter: Encounter, motion: Motion, room: Room, signal: AbortSignal,
): Promise<{ flights: Flight[]; impacts: Impact[]; end: number }> {
  const flights = [thrown(motion.speed, motion.angle, motion.spin, room)];
  const impacts: Impact[] = [];
  while (impacts.length < IMPACTS) {
    const { flight, surface } = landing(flights.at(-1)!, room);
    const rule = await core('oblique', encounter,
      { ...motion, ...meeting(flight, surface), tolerance: TOLERANCE }, { signal });
    signal.throwIfAborted();
    const value = (name: keyof typeof rule.quantities): number => rule.quantities[name]?.value ?? NaN;
    const [restitution, along] = [value('restitution'), value('tangential_restitution')];
    if (Number.isNaN(restitution)) throw new Error(rule.reason);
    const words = say('hops.impact', {
      number: impacts.length + 1, surface: say(`hops.${surface}`), normal: written(restitution, 3), along: written(along, 3),
    });
    impacts.push({ flight, words });
    flights.push(bounced(flight, surface,
      { restitution, tangential: value('tangential_after_si'), spin: value('spin_after_si') }));
  }
  const last = flights.at(-1)!;
  return { flights, impacts, end: landing(last, room).flight.time };
}

const begun = bisector(({ time }: Flight) => time).right;

function filmOf({ flights, impacts, end }: Awaited<ReturnType<typeof hop>>, room: Room): Film {
  const from = flights[0]!.time;
  const at = (time: number): Flight => {
    const flight = flights[Math.max(0, begun(flights, time) - 1)]!;
    return flown(flight, time - flight.time);
  };
  const ways = flights.map((flight, n) => {
    const last = flights[n + 1]?.time ?? end;
    return Array.from({ length: 41 }, (_, k) => flown(flight, ((last - flight.time) * k) / 40));
  });
  const said = (time: number): string => {
    const { vx, spin } = at(time);
    return say(vx < 0 ? 'hops.left' : 'hops.right', { time: withUnit(time, 's', 2), spin: written(spin, 3) });
  };
  const all = impacts.map(({ words }) => words).join('; ');
  return {
    from, to: end, still: 0, said,
    describe: (time) => `${said(time)}; ${all}`,
    note: (seconds) => say('hops.note', {
      impacts: all, slowed: slowness(end - from, 's', seconds), distance: withUnit(room.table, 'm'),
    }),
    height: () => HEIGHT,
    draw: (canvas, width, density, time, theme) =>
      drawHops(canvas, width, density, { impacts, now: at(time), ways, room }, theme),
  };
}

function drawHops(
  canvas: HTMLCanvasElement, width: number, density: number,
  { impacts, now, ways, room }: { impacts: Impact[]; now: Flight; ways: Flight[][]; room: Room }, theme: Theme,
): void {
  const context = cleared(canvas, density, width, HEIGHT, theme.background);
  const [left = 0, right = 0] = extent(ways.flat(), ({ x }) => x);
  const inner = HEIGHT - 2 * GROUND;
  const scale = Math.min(inner / room.table, (width - 24) / (right - left + 2 * room.radius));
  const floor = HEIGHT - GROUND;
  const place = ({ x, y }: Flight): [number, number] =>
    [width / 2 + scale * (x - (left + right) / 2), floor - scale * y];
  const top = floor - scale * room.table;
  for (const [y, edge] of [[floor, floor], [top - GROUND, top - 1.6]] as const) {
    box(context, theme.panel, 0, y, width, GROUND);
    box(context, theme.text, 0, edge, width, 1.6);
  }
  impacts.forEach(({ flight }, n) => {
    const [x, y] = place(flight);
    write(context, String(n + 1), x, y > HEIGHT / 2 ? floor + 16 : top - 7, theme.text, 'center', 12);
  });
  const [x, y] = place(ways[0]![0]!);
  write(context, say('hops.hand'), x + 2, y - 8, theme.muted, 'left', 12);
  for (const way of ways) drawWay(context, way.map(place), theme);
  const radius = Math.max(5, scale * room.radius);
  drawBody(context, place(now), radius, now.angle, theme);
  drawSpin(context, place(now), radius + 5, now.spin, theme);
}

const FULL = 400; // rad/s of an arrow that goes all around

/** An arrow around a body that turns, the longer the faster. */
function drawSpin(
  context: CanvasRenderingContext2D, [x, y]: [number, number], radius: number, spin: number, theme: Theme,
): void {
  const sweep = Math.sign(spin) * Math.min(5.4, 0.5 + (2 * Math.PI * Math.abs(spin)) / FULL);
  if (spin === 0) return;
  const way = Array.from({ length: 33 }, (_, k): [number, number] => {
    const angle = Math.PI / 2 + sweep * (k / 32 - 0.5);
    return [x + radius * Math.cos(angle), y - radius * Math.sin(angle)];
  });
  drawWay(context, way, theme, theme.text);
}

/** Makes an empty scene in an element, which shows the hops that begin with a collision. */
export function createHops(host: HTMLElement, core: Core) {
  const player = createPlayer(host, say('hops.name'));
  let asked: AbortController | undefined;
  return async (encounter: Encounter, motion: Motion): Promise<void> => {
    asked?.abort();
    const { signal } = (asked = new AbortController());
    const room = roomOf(meetingOf(encounter).first.body.radius, motion.speed);
    player.say(say('hops.computing'));
    try {
      player.show(filmOf(await hop(core, encounter, motion, room, signal), room));
    } catch (error) {
      if (!signal.aborted) player.say(say('hops.failed', { why: messageOf(error) }), true);
    }
  };
}
