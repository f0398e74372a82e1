// A rough ball in a plane hits the floor at an angle in planck.js, and leaves with the velocity and spin of the
// collision rule.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.2:1
//       --tolerance 0.05 --oblique --format js -o rule.mjs
//   npm ci --omit=peer && node planck_spin.js
//
// Copy motion, collide and the listener of pre-solve, which sets velocities and spins of what approaches.
// The contact may stay on: the solver then finds bodies that part, and leaves them alone. What approaches slower than
// the table begins is left to planck, which so holds what rests; let the table begin above the 0.16 m/s that gravity
// adds in a step of 1/60 s. Bodies that move freely are balls, of moment 2/5 m R^2. Units are m, kg, s.
import { Circle, Edge, Settings, Vec2, World, WorldManifold } from "planck";
import { STOSS_RULE_SLOWEST, stoss_rule_collide_2d } from "./rule.mjs";

// A body as the rule takes it; a wall moves as it does at the point.
function motion(fixture, point) {
  const body = fixture.getBody();
  if (!body.isDynamic()) {
    const { x, y } = body.getLinearVelocityFromWorldPoint(point);
    return { inverse_mass: 0, inverse_inertia: 0, radius: 0, velocity: [x, y], spin: 0 };
  }
  const { x, y } = body.getLinearVelocity();
  return {
    inverse_mass: 1 / body.getMass(),
    inverse_inertia: 1 / body.getInertia(),
    radius: fixture.getShape().getRadius(),
    velocity: [x, y],
    spin: body.getAngularVelocity(),
  };
}

// Changes the motions of two bodies by the rule, with the normal from a to b; false where they are slower than its
// table begins, or do not approach.
function collide(a, b, [x, y], friction) {
  const approach = (a.velocity[0] - b.velocity[0]) * x + (a.velocity[1] - b.velocity[1]) * y;
  return approach >= STOSS_RULE_SLOWEST && stoss_rule_collide_2d(a, b, [x, y], friction) === 1;
}

const [radius, mass, friction, gravity] = [0.1, 4.19, 0.3, Vec2(0, -9.81)];

// The motions of a ball before and after its first impact, and its height; after three seconds if none.
function fly([down, along, rim], step) {
  const world = new World({ gravity, continuousPhysics: false });
  world.on("pre-solve", (contact) => {
    const fixtures = [contact.getFixtureA(), contact.getFixtureB()];
    const { normal, points } = contact.getWorldManifold(new WorldManifold());
    const bodies = fixtures.map((fixture) => motion(fixture, points[0]));
    if (!collide(...bodies, [normal.x, normal.y], contact.getFriction())) return;
    fixtures.forEach((fixture, i) => {
      if (!fixture.getBody().isDynamic()) return;
      fixture.getBody().setLinearVelocity(Vec2(...bodies[i].velocity));
      fixture.getBody().setAngularVelocity(bodies[i].spin);
    });
  });
  world.createBody().createFixture({ shape: new Edge(Vec2(-9, 0), Vec2(9, 0)), friction });
  const body = world.createBody({
    type: "dynamic",
    position: Vec2(0, radius + Settings.polygonRadius + 1.3 * step * down),
    linearVelocity: Vec2(along, -down),
    angularVelocity: rim / radius,
  });
  const ball = body.createFixture({ shape: new Circle(radius), friction });
  body.setMassData({ mass, center: Vec2(0, 0), I: 0.4 * mass * radius ** 2 });
  let before;
  let after = motion(ball);
  for (let time = 0; time < 3 && after.velocity[1] < 0.1; time += step) {
    before = after;
    world.step(step, 8, 3);
    after = motion(ball);
  }
  return { before, after, height: body.getPosition().y - Settings.polygonRadius };
}

const throws = [
  [0.3, 0, 0], [0.3, 0.05, 0], [0.4, 0.3, 0], [0.8, 3, 0],
  [0.3, 0, 0.4], [0.5, 0.2, -0.7], [0.8, -0.3, 0.2], [0.9, 0.4, 2],
]; // down, along, spin times radius, m/s
console.log(" step/s  after: along, up, spin times radius  difference from the rule");
for (const thrown of throws) {
  for (const step of [1e-3, 1 / 60]) {
    const { before: wanted, after } = fly(thrown, step);
    const floor = { inverse_mass: 0, inverse_inertia: 0, radius: 0, velocity: [0, 0], spin: 0 };
    collide(wanted, floor, [0, -1], friction);
    wanted.velocity[1] += gravity.y * step; // which acts after pre-solve
    const found = [...after.velocity, after.spin * radius];
    const should = [...wanted.velocity, wanted.spin * radius];
    const difference = Math.max(...found.map((value, i) => Math.abs(value - should[i])));
    const numbers = found.map((x) => x.toFixed(6).padStart(11));
    console.log(step.toFixed(5), ...numbers, difference.toExponential(1).padStart(10));
    if (!(difference <= 1e-12)) process.exitCode = 1;
  }
}
const { height } = fly([0.03, 0, 0], 1 / 60);
console.log(`a ball that falls slower than the table begins rests at ${height.toFixed(4)} m`);
if (!(Math.abs(height - radius) < 0.05 * radius)) process.exitCode = 1;
