// A rough ball in a plane hits the floor at an angle in planck.js, and leaves with the velocity and spin of the
// collision rule.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.2:1
//       --tolerance 0.05 --oblique --format json -o rule.json
//   npm ci --omit=peer && node spin.js rule.json
//
// Copy readRule, motion, collide and the listener of pre-solve, which sets velocities and spins of what approaches.
// The contact may stay on: the solver then finds bodies that part, and leaves them alone. What approaches slower than
// the table begins is left to planck, which so holds what rests; let the table begin above the 0.16 m/s that gravity
// adds in a step of 1/60 s. Bodies that move freely are balls, of moment 2/5 m R^2. Units are m, kg, s.
import { readFileSync } from "node:fs";
import { Circle, Edge, Settings, Vec2, World, WorldManifold } from "planck";

// The interval of x in which a place is, and the weights of values and slopes at its ends.
function cubic(x, place) {
  if (x.length === 1) return { k: 0, value: [1], slope: [0] }; // nothing depends on it
  const at = Math.min(Math.max(place, x[0]), x[x.length - 1]);
  let k = 0;
  while (k + 2 < x.length && x[k + 1] <= at) ++k;
  const h = x[k + 1] - x[k];
  const t = (at - x[k]) / h;
  const u = 1 - t;
  return { k, value: [(1 + 2 * t) * u * u, t * t * (1 + 2 * u)], slope: [h * t * u * u, -h * t * t * u] };
}

// A table of one ratio of radii: functions of the speed of approach, the sliding and the friction.
function readRule(path) {
  const { records } = JSON.parse(readFileSync(path, "utf8"));
  const [restitution, sliding] = ["restitution", "sliding"].map((name) => {
    const { speed, slip, nodes } = records.find((record) => record.quantity === name);
    const x = speed.map(Math.log);
    const numbers = slip.length > 1 ? 4 : 2; // of each node
    return (v, place) => {
      const [a, b] = [cubic(x, Math.log(v)), cubic(slip, place)];
      let sum = 0;
      for (const i of [0, 1]) {
        for (const j of b.value.keys()) {
          const node = numbers * ((a.k + i) * slip.length + b.k + j);
          const [value, byX, bySlip = 0, byBoth = 0] = nodes.slice(node, node + numbers);
          sum += b.value[j] * (a.value[i] * value + a.slope[i] * byX);
          sum += b.slope[j] * (a.value[i] * bySlip + a.slope[i] * byBoth);
        }
      }
      return sum;
    };
  });
  return (v, s, friction) => {
    const scale = Math.abs(s) + friction * v;
    const slip = scale > 0 ? (Math.abs(s) - friction * v) / scale : -1;
    const most = Math.abs(s);
    const after = Math.min(Math.max(sliding(v, slip) * scale, -most), most);
    return { restitution: Math.min(Math.max(restitution(v, slip), 0), 1), sliding: Math.sign(s) * after };
  };
}

// Velocity, spin, radius and inverse masses of a ball; a wall moves as it does at the point.
function motion(fixture, point) {
  const body = fixture.getBody();
  if (!body.isDynamic()) {
    return { velocity: body.getLinearVelocityFromWorldPoint(point), spin: 0, radius: 0, mobility: 0, turning: 0 };
  }
  return {
    velocity: body.getLinearVelocity().clone(),
    spin: body.getAngularVelocity(),
    radius: fixture.getShape().getRadius(),
    mobility: 1 / body.getMass(),
    turning: 1 / body.getInertia(),
  };
}

// Changes the motions of two bodies by the rule, with the normal from a to b; false if it has nothing to say.
function collide(rule, slowest, a, b, normal, friction) {
  const tangent = Vec2(-normal.y, normal.x);
  const relative = Vec2.sub(a.velocity, b.velocity);
  const v = Vec2.dot(relative, normal);
  if (!(v >= slowest)) return false;
  const s = Vec2.dot(relative, tangent) + a.radius * a.spin + b.radius * b.spin;
  const after = rule(v, s, friction);
  const mobility = a.mobility + b.mobility;
  const push = ((1 + after.restitution) * v) / mobility;
  const drag = (s - after.sliding) / (mobility + a.radius ** 2 * a.turning + b.radius ** 2 * b.turning);
  const impulse = Vec2.combine(push, normal, drag, tangent);
  for (const [body, sign] of [[a, -1], [b, 1]]) {
    body.velocity = Vec2.combine(1, body.velocity, sign * body.mobility, impulse);
    body.spin -= body.radius * body.turning * drag;
  }
  return true;
}

const rule = readRule(process.argv[2]);
const slowest = JSON.parse(readFileSync(process.argv[2], "utf8")).records[0].speed[0];
const [radius, mass, friction, gravity] = [0.1, 4.19, 0.3, Vec2(0, -9.81)];

// The motions of a ball before and after its first impact, and its height; after three seconds if none.
function fly([down, along, rim], step) {
  const world = new World({ gravity, continuousPhysics: false });
  world.on("pre-solve", (contact) => {
    const fixtures = [contact.getFixtureA(), contact.getFixtureB()];
    const { normal, points } = contact.getWorldManifold(new WorldManifold());
    const bodies = fixtures.map((fixture) => motion(fixture, points[0]));
    if (!collide(rule, slowest, ...bodies, normal, contact.getFriction())) return;
    fixtures.forEach((fixture, i) => {
      if (!fixture.getBody().isDynamic()) return;
      fixture.getBody().setLinearVelocity(bodies[i].velocity);
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
  for (let time = 0; time < 3 && after.velocity.y < 0.1; time += step) {
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
    const floor = { velocity: Vec2(0, 0), spin: 0, radius: 0, mobility: 0, turning: 0 };
    collide(rule, slowest, wanted, floor, Vec2(0, -1), friction);
    wanted.velocity.y += gravity.y * step; // which acts after pre-solve
    const found = [after.velocity.x, after.velocity.y, after.spin * radius];
    const should = [wanted.velocity.x, wanted.velocity.y, wanted.spin * radius];
    const difference = Math.max(...found.map((value, i) => Math.abs(value - should[i])));
    const numbers = found.map((x) => x.toFixed(6).padStart(11));
    console.log(step.toFixed(5), ...numbers, difference.toExponential(1).padStart(10));
    if (!(difference <= 1e-12)) process.exitCode = 1;
  }
}
const { height } = fly([0.03, 0, 0], 1 / 60);
console.log(`a ball that falls slower than the table begins rests at ${height.toFixed(4)} m`);
if (!(Math.abs(height - radius) < 0.05 * radius)) process.exitCode = 1;
