// Every picture of the page by itself: ?body=disk&against=wall&speed=0.1, with a core without physics unless ?real.

import type { Against, Body, BodyKind, Encounter } from '../../src/core/protocol';
import { createCurveChart, type Curve } from '../../src/charts/curve_chart';
import { createModeBars } from '../../src/charts/mode_bars';
import { createTimeCharts } from '../../src/charts/time_charts';
import { createScene } from '../../src/scene/scene';
import { createCore } from '../../src/core/client';
import { fakeCore } from './fake_core';

const query = new URLSearchParams(location.search);
const si = query.has('si'); // steel, 1 cm
const first: Body = {
  poisson: 0.3, radius: si ? 0.01 : 1, young: si ? 2.1e11 : 1, density: si ? 7850 : 1, area: si ? 1e-4 : 1, lossTime: 0,
};
const name = query.get('against') ?? 'wall';
const ratio = Number(query.get('ratio') ?? 2);
const against: Against =
  name === 'wall' || name === 'same' ? { kind: name }
    : name === 'body' ? { kind: 'body', body: { ...first, radius: ratio * first.radius, area: ratio * first.area } }
      : { kind: 'half-space', body: first };
const encounter: Encounter = {
  kind: (query.get('body') ?? 'disk') as BodyKind, first, against, si, plane: 'stress',
};
const speed = Number(query.get('speed') ?? 0.1);
const core = query.has('real') ? createCore() : fakeCore();
const at = (id: string): HTMLElement => document.getElementById(id)!;

const scene = createScene(at('scene'), core);
const time = createTimeCharts(at('time'));
const curve = createCurveChart(at('curve'));
const modes = createModeBars(at('modes'), core);
scene.onCursor(time.setCursor);
time.onCursor(scene.seek);
curve.onPick((picked) => curve.setCurrent(picked, 0.9, 0.001));

const { cutoff } = await core.restitution(encounter, speed, 1e-3);
const collision = await core.collision(encounter, speed, cutoff);
Object.assign(window, { pictures: { scene, collision, core, encounter, speed } });
if (!query.has('noshow')) scene.show(encounter, speed, cutoff, collision);
time.show(collision);
modes.show(encounter, collision);
const planned = Array.from({ length: 25 }, (_, k) => 1e-3 * 300 ** (k / 24));
const curves: Curve[] = [0.3, 0.4].map((poisson) =>
  ({ label: `${encounter.kind}, ν = ${poisson}`, encounter, points: [], planned }));
curve.setCurrent(speed, 1 - 0.9 * speed ** 0.6, 0.005);
for (const [n, each] of curves.entries()) {
  await core.curve(encounter, planned.filter((_, k) => n === 0 || k % 3 !== 1), 1e-3, (point) => {
    each.points.push({ ...point, restitution: point.restitution - 0.05 * n, converged: point.speed < 0.2 });
    curve.setCurves(curves);
  });
}
Object.assign(window, { pictures: { scene, core, encounter, speed, time, curve, modes, collision, ready: true } });
