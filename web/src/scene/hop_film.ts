// The film of a ball that hops between floor and table.

import { bisector, extent } from 'd3-array';
import type { Core, Encounter, Motion } from '../core/protocol';
import { messageOf } from '../drawing/dom';
import { withUnit, written } from '../drawing/numbers';
import type { Theme } from '../drawing/theme';
import { meetingOf } from '../inputs/document';
import { type Flight, type Room, bounced, flown, landing, meeting, roomOf, thrown } from './hops';
import { drawBody, drawWay } from './oblique_film';
import { slowness } from './phases';
import { createPlayer, type Film } from './player';

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
    const value = (name: string): number => rule.quantities[name]?.value ?? NaN;
    const [restitution, along] = [value('restitution'), value('tangential_restitution')];
    if (Number.isNaN(restitution)) throw new Error(rule.reason);
    const words = `${impacts.length + 1}, ${surface}: ε ${written(restitution, 3)}, εₜ ${written(along, 3)}`;
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
    return `${withUnit(time, 's', 2)}, ${vx < 0 ? 'to the left' : 'to the right'}, spin ${written(spin, 3)} rad/s`;
  };
  const all = impacts.map(({ words }) => words).join('; ');
  return {
    from, to: end, still: 0, said,
    describe: (time) => `${said(time)}; ${all}`,
    note: (seconds) => `${all}. ${slowness(end - from, 's', seconds)} Between collisions it flies freely, with ` +
      `gravity. Floor and table, ${withUnit(room.table, 'm')} apart, are alike.`,
    height: () => HEIGHT,
    draw: (canvas, width, density, time, theme) =>
      drawHops(canvas, width, density, { impacts, now: at(time), ways, room }, theme),
  };
}

function drawHops(
  canvas: HTMLCanvasElement, width: number, density: number,
  { impacts, now, ways, room }: { impacts: Impact[]; now: Flight; ways: Flight[][]; room: Room }, theme: Theme,
): void {
  const context = canvas.getContext('2d')!;
  context.setTransform(density, 0, 0, density, 0, 0);
  context.fillStyle = theme.background;
  context.fillRect(0, 0, width, HEIGHT);
  const [left = 0, right = 0] = extent(ways.flat(), ({ x }) => x);
  const inner = HEIGHT - 2 * GROUND;
  const scale = Math.min(inner / room.table, (width - 24) / (right - left + 2 * room.radius));
  const floor = HEIGHT - GROUND;
  const place = ({ x, y }: Flight): [number, number] =>
    [width / 2 + scale * (x - (left + right) / 2), floor - scale * y];
  const top = floor - scale * room.table;
  context.fillStyle = theme.panel;
  context.fillRect(0, floor, width, GROUND);
  context.fillRect(0, top - GROUND, width, GROUND);
  context.fillStyle = theme.text;
  context.fillRect(0, floor, width, 1.6);
  context.fillRect(0, top - 1.6, width, 1.6);
  context.font = '12px system-ui, sans-serif';
  context.textAlign = 'center';
  impacts.forEach(({ flight }, n) => {
    const [x, y] = place(flight);
    context.fillText(String(n + 1), x, y > HEIGHT / 2 ? floor + 16 : top - 7);
  });
  context.fillStyle = theme.muted;
  context.textAlign = 'left';
  const [x, y] = place(ways[0]![0]!);
  context.fillText('from the hand', x + 2, y - 8);
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
  const player = createPlayer(host, 'Film of the hops');
  let asked: AbortController | undefined;
  return async (encounter: Encounter, motion: Motion): Promise<void> => {
    asked?.abort();
    const { signal } = (asked = new AbortController());
    const room = roomOf(meetingOf(encounter).first.body.radius, motion.speed);
    player.say('Computing the hops …');
    try {
      player.show(filmOf(await hop(core, encounter, motion, room, signal), room));
    } catch (error) {
      if (!signal.aborted) player.say(`The hops could not be computed: ${messageOf(error)}`, true);
    }
  };
}
