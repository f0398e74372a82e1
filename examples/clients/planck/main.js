// A disk falls on the floor in planck.js and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body disk --poisson 0.4 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format json -o restitution.json
//   npm ci --omit=peer && node main.js restitution.json
//
// Copy `table` and the listener of pre-solve. planck is Box2D in JavaScript:
// - Below a threshold, 1 m/s unless it is set, nothing bounces: Settings.velocityThreshold = 0.
// - A step first calls pre-solve, then lets gravity act, then multiplies the relative velocity: `velocity` adds what is
//   still to come. Where continuous physics meets a fast body within a step, gravity has acted before pre-solve, and
//   the term is too much; it is off here.
// The ratio of the speeds is then that of the table to rounding. Units are m, kg, s.
import { readFileSync } from "node:fs";
import { Circle, Edge, Settings, Vec2, World, WorldManifold } from "planck";

// The function of a table: a cubic in ln v between its records; beyond them that at the nearer end.
function table(path) {
  const { records } = JSON.parse(readFileSync(path, "utf8"));
  const x = records.map((record) => Math.log(record.speed));
  return (speed) => {
    const at = Math.min(Math.max(Math.log(Math.abs(speed)), x[0]), x[x.length - 1]);
    let k = 0;
    for (let end = x.length - 1; end - k > 1; ) {
      const middle = (k + end) >> 1;
      if (x[middle] <= at) k = middle;
      else end = middle;
    }
    const [a, b] = [records[k], records[k + 1]];
    const h = x[k + 1] - x[k];
    const t = (at - x[k]) / h;
    const u = 1 - t;
    return (
      a.restitution * (1 + 2 * t) * u * u +
      b.restitution * t * t * (1 + 2 * u) +
      h * t * u * (a.slope * u - b.slope * t)
    );
  };
}

const restitution = table(process.argv[2]);
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
    contact.setRestitution(restitution(approach));
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

const accuracy = 1e-12;
console.log(" step/s  before/(m/s)  after/before  eps of the table  difference");
for (const speed of [0.02, 0.1, 0.5, 2, 8]) {
  for (const step of [1e-3, 1 / 60]) {
    const [before, after] = drop(speed, step);
    const [found, wanted] = [after / before, restitution(before)];
    const numbers = [before.toFixed(7).padStart(13), found.toFixed(9).padStart(13), wanted.toFixed(9).padStart(17)];
    console.log(step.toFixed(5), ...numbers, (found - wanted).toExponential(1).padStart(11));
    if (!(Math.abs(found - wanted) <= accuracy)) process.exitCode = 1;
  }
}
