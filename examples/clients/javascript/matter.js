// A disk falls on the floor in Matter and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body disk --poisson 0.4 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format js
//       -o restitution.mjs
//   npm ci --omit=peer && node matter.js
//
// Copy `touched` and the settings that have a comment. Matter lets gravity act before it looks for contacts, and
// multiplies what the relative velocity is then. What comes slower than 2 units of length in 1/60 s it slows down over
// several steps instead, unless that is set to 0. A circle is a polygon: where an edge meets the floor, with both its
// ends, the speed is off by up to 0.15 of it, unless the body cannot turn. The ratio of the speeds is then that of the
// table to rounding. Units are m and s; in a window `scale` is the number of pixels of a metre.
import Matter from "matter-js";
import { compare } from "./compare.js";
import { stoss_restitution } from "./restitution.mjs";

const { Bodies, Body, Common, Composite, Engine, Events, Resolver, Vector } = Matter;
const scale = 100;
Resolver._restingThresh = 0; // slow bodies bounce too

// How far a body goes in a step: Matter has positions, now and before, for a velocity.
const moved = (body) => Vector.sub(body.position, body.positionPrev);

let before = 0;

// Listens to `collisionStart`. (The spins of circles do not count along the normal.)
function touched({ pairs, delta }) {
  for (const pair of pairs) {
    const { parentA, parentB, normal } = pair.collision; // from b to a
    const approach = (-Vector.dot(Vector.sub(moved(parentA), moved(parentB)), normal) * 1000) / delta / scale;
    if (approach <= 0) continue;
    pair.restitution = stoss_restitution(approach);
    before = approach;
  }
}

// Drops a disk, thrown down with a speed from five steps above the floor: the speeds before and after.
function drop(speed, step) {
  const radius = 0.1;
  const engine = Engine.create({ gravity: { x: 0, y: -1, scale: 9.81e-6 * scale } });
  Events.on(engine, "collisionStart", touched);
  const floor = Bodies.rectangle(0, -scale, 20 * scale, 2 * scale, { isStatic: true });
  const air = { frictionAir: 0 }; // which slows bodies down
  const disk = Bodies.circle(0, (radius + 5.3 * step * speed) * scale, radius * scale, air);
  Body.setInertia(disk, Infinity); // or the speed is wrong where an edge meets the floor
  Body.setVelocity(disk, { x: 0, y: (-speed * scale * Common._baseDelta) / 1000 });
  Composite.add(engine.world, [floor, disk]);
  for (let i = 0; i < 20 && moved(disk).y < 0; ++i) Engine.update(engine, 1000 * step);
  return [before, moved(disk).y / step / scale];
}

compare(drop, 1e-12);
