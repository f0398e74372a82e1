// Every picture of the page by itself: ?body=disk&against=wall&speed=0.1, with a core without physics unless ?real.

import type { Against, Body, BodyKind, Encounter } from '../../src/core/protocol';
import { createScene } from '../../src/scene/scene';
import { fakeCore } from './fake_core';

const query = new URLSearchParams(location.search);
const first: Body = { poisson: 0.3, radius: 1, young: 1, density: 1, area: 1, lossTime: 0 };
const name = query.get('against') ?? 'wall';
const ratio = Number(query.get('ratio') ?? 2);
const against: Against =
  name === 'wall' || name === 'same' ? { kind: name }
    : name === 'body' ? { kind: 'body', body: { ...first, radius: ratio, area: ratio } }
      : { kind: 'half-space', body: first };
const encounter: Encounter = {
  kind: (query.get('body') ?? 'disk') as BodyKind, first, against, si: false, plane: 'stress',
};
const speed = Number(query.get('speed') ?? 0.1);
const core = fakeCore();
const at = (id: string): HTMLElement => document.getElementById(id)!;

const scene = createScene(at('scene'), core);
const collision = await core.collision(encounter, speed, 1e-3);
scene.show(encounter, speed, 1e-3, collision);
Object.assign(window, { pictures: { scene, collision, ready: true } });
