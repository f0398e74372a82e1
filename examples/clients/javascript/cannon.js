// A ball falls on the floor in cannon-es and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format js
//       -o restitution.mjs
//   npm ci --omit=peer && node cannon.js
//
// Copy `collided`. cannon-es calls it where a contact begins, before it solves it, and multiplies the velocity that
// bodies have before gravity acts. But its contacts are springs with a dashpot, which change the velocity too, by up to
// 0.3 of it. So `collided` makes this contact, in this step alone, so stiff and so slow that neither counts. The ratio
// of the speeds is then that of the table to 1e-9. Units are m, kg, s.
import { Body, Plane, Sphere, Vec3, World } from "cannon-es";
import { compare } from "./compare.js";
import { stoss_restitution } from "./restitution.mjs";

let before = 0;

// Listens to `collide` of one of two bodies.
function collided({ target, contact }) {
  const approach = contact.getImpactVelocityAlongNormal();
  if (approach <= 0) return;
  contact.restitution = stoss_restitution(approach);
  contact.setSpookParams(1e15, 1e9, target.world.dt); // stiffness, and relaxation in steps
  before = approach;
}

// Drops a ball, thrown down with a speed from five steps above the floor: the speeds before and after.
function drop(speed, step) {
  const radius = 0.1;
  const world = new World({ gravity: new Vec3(0, -9.81, 0) });
  const floor = new Body({ mass: 0, shape: new Plane() });
  floor.quaternion.setFromEuler(-Math.PI / 2, 0, 0);
  world.addBody(floor);
  const ball = new Body({
    mass: 4.19,
    shape: new Sphere(radius),
    position: new Vec3(0, radius + 5.3 * step * speed, 0),
    velocity: new Vec3(0, -speed, 0),
    linearDamping: 0,
  });
  ball.addEventListener("collide", collided);
  world.addBody(ball);
  for (let i = 0; i < 20 && ball.velocity.y < 0; ++i) world.step(step);
  return [before, ball.velocity.y];
}

compare(drop, 1e-8);
