// A disk falls on the floor in planck.js and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body disk --poisson 0.4 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format js
//       -o restitution.mjs
//   npm ci --omit=peer && node planck.js
//
// Copy speedOfApproach and the listener of pre-solve. planck is Box2D in JavaScript:
// - Below a threshold, 1 m/s unless it is set, nothing bounces: Settings.velocityThreshold = 0.
// - A step first calls pre-solve, then lets gravity act, then multiplies the relative velocity: `velocity` adds what is
//   still to come. Where continuous physics meets a fast body within a step, gravity has acted before pre-solve, and
//   the term is too much; it is off here.
// The ratio of the speeds is then that of the table to rounding. Units are m, kg, s.
import { Circle, Edge, Settings, Vec2, World, WorldManifold } from "planck";
import { compare } from "./compare.js";
import { stoss_restitution } from "./restitution.mjs";

const gravity = Vec2(0, -9.81);
Settings.velocityThreshold = 0;

function velocity(body, point, step) {
  const now = body.getLinearVelocityFromWorldPoint(point);
  return body.isDynamic() ? Vec2.combine(1, now, step * body.getGravityScale(), gravity) : now;
}

// The greatest speed of approach at the points of a contact.
function speedOfApproach(contact, step) {
  const [a, b] = [contact.getFixtureA().getBody(), contact.getFixtureB().getBody()];
  const manifold = contact.getWorldManifold(new WorldManifold()); // its normal points from a to b
  let greatest = 0;
  for (let i = 0; i < manifold.pointCount; ++i) {
    const point = manifold.points[i];
    const relative = Vec2.sub(velocity(a, point, step), velocity(b, point, step));
    greatest = Math.max(greatest, Vec2.dot(relative, manifold.normal));
  }
  return greatest;
}

// Drops a disk, thrown down with a speed from five steps above the floor: the speeds before and after.
function drop(speed, step) {
  const radius = 0.1;
  const world = new World({ gravity, continuousPhysics: false });
  let before = 0;
  world.on("pre-solve", (contact) => {
    const approach = speedOfApproach(contact, step);
    if (approach <= 0) return;
    contact.setRestitution(stoss_restitution(approach));
    if (before === 0) before = approach;
  });
  world.createBody().createFixture({ shape: new Edge(Vec2(-1, 0), Vec2(1, 0)) });
  const body = world.createBody({
    type: "dynamic",
    position: Vec2(0, radius + Settings.polygonRadius + 5.3 * step * speed),
    linearVelocity: Vec2(0, -speed),
  });
  body.createFixture({ shape: new Circle(radius), density: 1000 });
  for (let i = 0; i < 20 && before === 0; ++i) world.step(step, 8, 3);
  return [before, body.getLinearVelocity().y];
}

compare(drop, 1e-12);
