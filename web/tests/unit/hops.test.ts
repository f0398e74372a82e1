import { describe, expect, it } from 'vitest';
import { type flown, bounced, landing, meeting, roomOf, thrown } from '../../src/scene/hop_film';
import { gravity } from '../../src/inputs/inputs';

const room = roomOf(0.025, 5);
const energy = ({ vx, vy, y }: ReturnType<typeof flown>): number => 0.5 * (vx ** 2 + vy ** 2) + gravity * y;

describe('a ball under a table', () => {
  it('leaves the hand so that it meets the floor as it should', () => {
    const first = thrown(5, 25, 40, room);
    expect([room.table, first.y]).toEqual([0.7, expect.closeTo(0.49, 12)]);
    const { flight, surface } = landing(first, room);
    expect(surface).toBe('floor');
    expect([flight.time, flight.x, flight.y]).toEqual([0, 0, room.radius].map((each) => expect.closeTo(each, 12)));
    const { speed, angle, spin } = meeting(flight, surface);
    expect([speed, angle, spin]).toEqual([5, 25, 40].map((each) => expect.closeTo(each, 12)));
    expect(energy(flight)).toBeCloseTo(energy(first), 12);
  });
  it('falls from its apex if it is slow', () => {
    const first = thrown(1, 0, 0, room);
    expect(first.vy).toBeCloseTo(0, 12);
    expect(landing(first, room).flight.time).toBeCloseTo(0, 12);
  });
  it('reaches the table, or falls back', () => {
    const up = (vy: number) => landing({ time: 0, x: 0, y: room.radius, vx: 1, vy, angle: 0, spin: 0 }, room);
    expect(up(4).surface).toBe('table');
    expect(up(4).flight.y).toBeCloseTo(room.table - room.radius, 12);
    expect(up(4).flight.vy).toBeGreaterThan(0);
    expect(up(3).surface).toBe('floor');
    expect(up(3).flight.vy).toBeCloseTo(-3, 12);
    expect(landing({ ...up(4).flight, vy: -2 }, room).surface).toBe('floor');
  });
  it('sees floor and table from the two sides', () => {
    const flight = { time: 0, x: 0, y: 0, vx: 3, vy: 3, angle: 0, spin: 7 };
    expect(meeting(flight, 'table').angle).toBeCloseTo(-45, 12);
    const rule = { restitution: 0.5, tangential: -1, spin: -2 };
    expect(bounced(flight, 'table', rule)).toMatchObject({ vx: 1, vy: -1.5, spin: -2 });
    expect(bounced({ ...flight, vy: -3 }, 'floor', rule)).toMatchObject({ vx: -1, vy: 1.5 });
  });
});
