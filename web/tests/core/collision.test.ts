// One impact in time is that of `stoss impact`, and its frames show bodies that touch and do not enter each other.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Encounter, Frame, Grid } from '../../src/core/protocol';
import { meetingOf, sizesOf, unitBody } from '../../src/inputs/document';
import { encounterArguments } from '../../src/inputs/lines';
import { shortest } from '../../src/drawing/numbers';
import { barSpeed } from '../../src/inputs/units';
import { cases, like } from '../unit/cases';
import { hasCommand, run } from './native';
import { ask } from './wasm';

const tolerance = 1e-2;
const chosen = [0, 1, 2, 4, 5, 6, 9, 10, 12];

const cutoffOf = (encounter: Encounter, speed: number): number =>
  ask('restitution', encounter, { speed, tolerance }).value.cutoff;

function trajectory(encounter: Encounter, speed: number, cutoff: number): Record<string, number[]> {
  const folder = mkdtempSync(join(tmpdir(), 'stoss-'));
  const file = join(folder, 'trajectory.csv');
  run(['impact', ...encounterArguments(encounter), '--speed', shortest(speed), '--cutoff', shortest(cutoff),
    '--trajectory', file]);
  const [head, ...rows] = readFileSync(file, 'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  rmSync(folder, { recursive: true });
  const names = head!.split(',').map((name) => name.replace(/\[.*/, ''));
  return Object.fromEntries(names.map((name, k) => [name, rows.map((row) => Number(row.split(',')[k]))]));
}

describe.skipIf(!hasCommand)('a collision', () => {
  it.each([...chosen, 18, 19])('is the impact of the command: case %i', (index) => {
    const { encounter, speed } = cases[index]!;
    const { si } = meetingOf(encounter);
    const cutoff = cutoffOf(encounter, speed);
    const native = trajectory(encounter, speed, cutoff);
    const ours = ask('collision', encounter, { speed, cutoff }).value;
    expect(ours.time.length).toBe(native.time!.length);
    const names = ['time', 'velocity', 'force', 'contact_half_width', 'translation', 'vibration', 'stored',
      'dissipated', 'unresolved'] as const;
    for (const name of names) {
      const values = ours[name];
      const theirs = native[name]!;
      // In the unit of the maximum, which the two have in their own.
      const greatest = Math.max(...values.map(Math.abs));
      const unit = greatest / (Math.max(...theirs.map(Math.abs)) || 1);
      const energy = ['translation', 'vibration', 'stored', 'dissipated', 'unresolved'].includes(name);
      if (!si || energy) expect(unit === 0 ? 1 : unit, name).toBeCloseTo(1, 10);
      if (si && name === 'velocity') expect(unit / barSpeed(encounter)).toBeCloseTo(1, 10);
      theirs.forEach((value, k) => {
        const size = energy ? 1 : greatest;
        expect(Math.abs(values[k]! - unit * value), `${name} ${k}`).toBeLessThanOrEqual(1e-10 * size);
      });
    }
  });
});

/** A grid that has the foremost point. */
function gridOf(encounter: Encounter): Grid {
  const below = { depth: Float32Array.from([0, 0.5, 1]), distance: Float32Array.from([0, 0.5, 1, 2]) };
  return meetingOf(encounter).kind === 'rod'
    ? { radius: Float32Array.from([0, 0.5, 1]), angle: Float32Array.from([0]) }
    : { radius: Float32Array.from([0, 0.5, 1]), angle: Float32Array.from([0, 1, 2, Math.PI]), below };
}

/** Place of the point of a body that touches first. */
function front(encounter: Encounter, frame: Frame, body: 0 | 1, radius: number): number {
  const seen = frame.bodies[body]!;
  const rod = meetingOf(encounter).kind === 'rod';
  const u = seen.radial[rod ? 0 : 2 * 4]!;
  return seen.center + (body === 0 ? 1 : -1) * radius * ((rod ? 0.5 : 1) + u);
}

describe('frames', () => {
  it.each(chosen)('show bodies that touch: case %i', (index) => {
    const { encounter, speed } = cases[index]!;
    const cutoff = cutoffOf(encounter, speed);
    const collision = ask('collision', encounter, { speed, cutoff }).value;
    const strongest = collision.force.reduce((best, force, k) => (force > collision.force[best]! ? k : best), 0);
    const times = [-collision.end, collision.time[strongest]!, 2 * collision.end];
    const { all } = ask('frames', encounter, { speed, cutoff, times, grid: gridOf(encounter) });
    const [before, touching, after] = all as [Frame, Frame, Frame];
    const compression = Math.abs(before.bodies[0]!.center - touching.bodies[0]!.center);
    const gap = (frame: Frame): number => {
      const first = front(encounter, frame, 0, 1);
      const second = frame.bodies[1];
      if (meetingOf(encounter).against === 'half-space') return second!.center + second!.radial[0]! - first;
      return frame.bodies.length === 1 ? -first : front(encounter, frame, 1, sizesOf(encounter)[1]!) - first;
    };
    expect(gap(before)).toBeGreaterThan(0);
    expect(Math.abs(gap(touching))).toBeLessThan(0.01 * compression);
    expect(gap(after)).toBeGreaterThan(0);
    expect(touching.time).toBeCloseTo(times[1]!, 12);
    for (const body of touching.bodies) {
      expect(body.vonMises.every((stress) => Number.isFinite(stress) && stress >= 0)).toBe(true);
      expect(body.fringes.length).toBe(body.radial.length);
    }
    expect(Math.max(...before.bodies[0]!.vonMises)).toBe(0);
    if (meetingOf(encounter).kind === 'rod') expect(touching.bodies[0]!.vonMises[0]).toBeGreaterThan(0);
  });
});

it('frames of a plate bend both of its faces', () => {
  const second = { ...unitBody, poisson: 0.3, young: 3, density: 4, thickness: 0.5 };
  const encounter = like(cases[4]!.encounter, { against: 'plate', second });
  const { end } = ask('collision', encounter, { speed: 0.02, cutoff: 8 }).value;
  const below = { depth: Float32Array.from([0, 0.25, 0.5]), distance: Float32Array.from([0, 0.5, 2, 4]) };
  const { all } = ask('frames', encounter,
    { speed: 0.02, cutoff: 8, times: [-1, 1.7 * end], grid: { ...gridOf(encounter), below } });
  const [before, late] = all.map(({ bodies }) => bodies[1]!.radial) as [Float32Array, Float32Array];
  for (const each of before) expect(each).toBe(0);
  expect(late[8]! / late[0]!).toBeCloseTo(1, 2);
});

it('the shape of the breathing mode of a disk is the same all around', () => {
  const grid = { radius: Float32Array.from([0, 1]), angle: Float32Array.from([0, Math.PI / 2, Math.PI]) };
  const { radial, tangential } = ask('shape', cases[0]!.encounter, { body: 0, order: 0, index: 0, grid }).value;
  for (const k of [3, 4, 5]) expect(Math.abs(radial[k]!)).toBeCloseTo(1, 6);
  for (const each of tangential) expect(each).toBeCloseTo(0, 6);
});
