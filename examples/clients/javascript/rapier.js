// A ball falls on the floor in Rapier and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format js
//       -o restitution.mjs
//   npm ci --omit=peer && node rapier.js
//
// Copy beforeStep. Rapier in JavaScript asks nobody for a restitution (in Rust PhysicsHooks do): it is set before each
// step, as that of the ball alone by the rule Max. Three things about Rapier 0.21:
// - It multiplies the velocity that bodies have before gravity acts in this step.
// - A contact keeps the restitution that its bodies had when they came near. Setting groups anew makes it look again.
// - One restitution holds for all that a ball meets in a step.
// The ratio of the speeds is then that of the table to the rounding of float. Units are m, kg, s.
import RAPIER from "@dimforge/rapier3d-compat";
import { compare } from "./compare.js";
import { stoss_restitution } from "./restitution.mjs";

await RAPIER.init();
const radius = 0.1;

// Before each step, of each ball that may meet something at rest whose normal, towards the ball, is known.
function beforeStep(ball, normal) {
  const velocity = ball.parent().linvel();
  const approach = -(velocity.x * normal.x + velocity.y * normal.y + velocity.z * normal.z);
  if (approach > 0) ball.setRestitution(stoss_restitution(approach));
  ball.setCollisionGroups(0xfffffffe);
  ball.setCollisionGroups(0xffffffff);
  return approach;
}

// Drops a ball, thrown down with a speed from five steps above the floor: the speeds before and after.
function drop(speed, step) {
  const world = new RAPIER.World({ x: 0, y: -9.81, z: 0 });
  world.timestep = step;
  world.createCollider(RAPIER.ColliderDesc.cuboid(1, 1, 1).setTranslation(0, -1, 0));
  const place = RAPIER.RigidBodyDesc.dynamic().setTranslation(0, radius + 5.3 * step * speed, 0);
  const body = world.createRigidBody(place.setLinvel(0, -speed, 0));
  const shape = RAPIER.ColliderDesc.ball(radius).setDensity(1000);
  const ball = world.createCollider(shape.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max), body);
  let before = 0;
  for (let i = 0; i < 20 && body.linvel().y < 0; ++i) {
    before = beforeStep(ball, { x: 0, y: 1, z: 0 });
    world.step();
  }
  return [before, body.linvel().y];
}

compare(drop, 1e-6);
