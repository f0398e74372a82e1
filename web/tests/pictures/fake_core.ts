// A core without physics, for pictures: bodies with a dent of the right size that then swing in their lowest mode.

import type {
  BodyFrame, Collision, Core, CurvePoint, Encounter, Frame, Grid, Restitution, Shape,
} from '../../src/core/protocol';

const CONTACT = 8;

function compression(speed: number, time: number): number {
  return time > 0 && time < CONTACT ? ((speed * CONTACT) / Math.PI) * Math.sin((Math.PI * time) / CONTACT) : 0;
}

function centerOf(speed: number, time: number): number {
  if (time < 0) return speed * time;
  return time < CONTACT ? compression(speed, time) : -0.9 * speed * (time - CONTACT);
}

function bodyFrame(encounter: Encounter, speed: number, time: number, grid: Grid, second: boolean): BodyFrame {
  const size = grid.radius.length * grid.angle.length;
  const make = (): Float32Array => new Float32Array(size);
  const frame: BodyFrame = {
    center: (second ? 1 : -1) * (1 - centerOf(speed, time)), radial: make(), tangential: make(), vonMises: make(),
    fringes: make(),
  };
  const dent = compression(speed, time);
  const swing = time > CONTACT ? 0.4 * speed * Math.sin(1.4 * (time - CONTACT)) : 0;
  const width = Math.sqrt(Math.max(dent, 1e-6));
  for (let i = 0, k = 0; i < grid.radius.length; ++i) {
    for (let j = 0; j < grid.angle.length; ++j, ++k) {
      const r = grid.radius[i]!;
      const angle = grid.angle[j]!;
      if (encounter.kind === 'rod') {
        frame.radial[k] = -dent * (1 - r) + swing * Math.cos(Math.PI * r);
        frame.vonMises[k] = frame.fringes[k] = dent * Math.sin(Math.PI * r) + Math.abs(swing);
        continue;
      }
      const [x, y] = [1 - r * Math.cos(angle), r * Math.sin(angle)];
      const near = Math.hypot(x, y) + width;
      frame.radial[k] = -dent * (width / near) * Math.cos(angle) + swing * r * Math.cos(2 * angle);
      frame.tangential[k] = dent * (width / near) * Math.sin(angle) - swing * r * Math.sin(2 * angle);
      const hertz = 0.5 * width * (dent > 0 ? 1 : 0);
      frame.fringes[k] = (hertz * width * (x + 0.1 * width)) / (near * near) + 0.5 * Math.abs(swing) * (1 - r * r);
      frame.vonMises[k] = 1.1 * frame.fringes[k]! + 0.1 * Math.abs(swing);
    }
  }
  return frame;
}

export function fakeCore(): Core {
  const later = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 1));
  return {
    async restitution(): Promise<Restitution> {
      throw new Error('not here');
    },
    async collision(encounter: Encounter, speed: number): Promise<Collision> {
      const count = 400;
      const time = Float64Array.from({ length: count }, (_, k) => (k * CONTACT) / (count - 1));
      const of = (value: (t: number) => number): Float64Array => time.map(value);
      const phase = (t: number): number => (Math.PI * t) / CONTACT;
      const modes = [];
      for (let n = 0; n < 60; ++n) {
        for (let l = 0; l < 20; ++l) {
          modes.push({
            body: 0 as const, order: n, index: l, omega: 1.4 + n + 2.7 * l,
            after: (0.05 * Math.abs(Math.cos(3 * n + l))) / (1 + n * n) / (1 + 3 * l) ** 2,
            average: 0.1 / (1 + n * n) / (1 + 3 * l) ** 2,
          });
        }
      }
      return {
        units: { time: 'R/c', length: 'R', speed: 'c', force: 'mc²/R' }, time,
        velocity: of((t) => speed * Math.cos(phase(t))), force: of((t) => speed * Math.sin(phase(t)) ** 1.2),
        halfWidth: of((t) => Math.sqrt(Math.max(0, compression(speed, t)))),
        translation: of((t) => Math.cos(phase(t)) ** 2 * (1 - 0.02 * t)), vibration: of((t) => 0.02 * t),
        stored: of((t) => Math.sin(phase(t)) ** 2 * (1 - 0.02 * t)), dissipated: of(() => 0),
        unresolved: of((t) => 1e-4 * Math.sin(t)), modes, begin: 0, end: CONTACT,
        bodies: [
          { kind: encounter.kind, radius: 1 },
          ...(encounter.against.kind === 'wall' ? []
            : encounter.against.kind === 'half-space' ? [{ kind: 'half-space' as const, radius: 0 }]
              : [{ kind: encounter.kind, radius: 1 }]),
        ],
      };
    },
    async frames(encounter, speed, _cutoff, times, grid, deliver, signal) {
      for (const [index, time] of times.entries()) {
        if (index % 4 === 0) await later();
        signal?.throwIfAborted();
        const pair = encounter.against.kind === 'same' || encounter.against.kind === 'body';
        const frame: Frame = { time, bodies: [bodyFrame(encounter, speed, time, grid, false)] };
        if (pair) frame.bodies.push(bodyFrame(encounter, speed, time, grid, true));
        if (encounter.against.kind === 'half-space') {
          const y = Float32Array.from({ length: 60 }, (_, k) => k / 12);
          frame.surface = { y, depth: y.map((each) => (0.3 * compression(speed, time)) / (1 + 4 * each)) };
        }
        deliver(frame, index);
      }
    },
    async shape(_encounter, _body, order, _index, grid): Promise<Shape> {
      const radial: number[] = [];
      const tangential: number[] = [];
      for (const r of grid.radius) {
        for (const angle of grid.angle) {
          radial.push(r ** Math.max(1, order - 1) * Math.cos(order * angle));
          tangential.push(-(r ** Math.max(1, order - 1)) * Math.sin(order * angle) * 0.8);
        }
      }
      return { radial: Float32Array.from(radial), tangential: Float32Array.from(tangential) };
    },
    async curve(_encounter, speeds, _tolerance, deliver, signal) {
      for (const [index, speed] of speeds.entries()) {
        await later();
        signal?.throwIfAborted();
        const point: CurvePoint = {
          speed, restitution: 1 - 0.9 * speed ** 0.6, error: 0.004 + 0.02 * speed, converged: true,
        };
        deliver(point, index);
      }
    },
    async header() {
      return '';
    },
  };
}
