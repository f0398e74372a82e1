// A ball falls on the floor in Jolt and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format js
//       -o restitution.mjs
//   npm ci --omit=peer && node jolt.js
//
// Copy `touched`, which Jolt calls for each new contact and in each later step, and the setting of the threshold: below
// mMinVelocityForRestitution, 1 m/s unless it is set, nothing bounces. Gravity has acted before Jolt calls, and Jolt
// multiplies the velocity without it: so does `touched`. The ratio of the speeds is then that of the table to the
// rounding of float. Units are m, kg, s.
import initJolt from "jolt-physics";
import { compare } from "./compare.js";
import { stoss_restitution } from "./restitution.mjs";

const Jolt = await initJolt();
const [moving, fixed] = [0, 1];
const settings = new Jolt.JoltSettings();
const pairs = new Jolt.ObjectLayerPairFilterTable(2);
pairs.EnableCollision(moving, moving);
pairs.EnableCollision(moving, fixed);
const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
for (const layer of [moving, fixed]) layers.MapObjectToBroadPhaseLayer(layer, new Jolt.BroadPhaseLayer(layer));
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
const jolt = new Jolt.JoltInterface(settings);
const system = jolt.GetPhysicsSystem();
const gravity = [0, -9.81, 0];
system.SetGravity(new Jolt.Vec3(...gravity));
const physics = system.GetPhysicsSettings();
physics.mMinVelocityForRestitution = 0; // slow balls bounce too
system.SetPhysicsSettings(physics);

let [before, timeStep] = [0, 0];

// The velocity of a body along a normal, before gravity has acted in this step. (Of a ball its spin does not count.)
function along(normal, pointer) {
  const body = Jolt.wrapPointer(pointer, Jolt.Body);
  const velocity = body.GetLinearVelocity();
  const now = [velocity.GetX(), velocity.GetY(), velocity.GetZ()];
  const fallen = body.IsDynamic() ? timeStep * body.GetMotionProperties().GetGravityFactor() : 0;
  return normal.reduce((sum, n, i) => sum + n * (now[i] - fallen * gravity[i]), 0);
}

function touched(a, b, manifold, contact) {
  const axis = Jolt.wrapPointer(manifold, Jolt.ContactManifold).mWorldSpaceNormal; // from a to b
  const normal = [axis.GetX(), axis.GetY(), axis.GetZ()];
  const approach = along(normal, a) - along(normal, b);
  if (approach <= 0) return;
  Jolt.wrapPointer(contact, Jolt.ContactSettings).mCombinedRestitution = stoss_restitution(approach);
  before = approach;
}

const listener = new Jolt.ContactListenerJS();
listener.OnContactValidate = () => Jolt.ValidateResult_AcceptAllContactsForThisBodyPair;
listener.OnContactAdded = listener.OnContactPersisted = touched; // Jolt asks already where bodies come near
listener.OnContactRemoved = () => {};
system.SetContactListener(listener);

const bodies = system.GetBodyInterface();
function add(shape, height, motion, layer) {
  const where = new Jolt.RVec3(0, height, 0);
  const made = new Jolt.BodyCreationSettings(shape, where, new Jolt.Quat(0, 0, 0, 1), motion, layer);
  made.mLinearDamping = 0;
  const body = bodies.CreateBody(made);
  bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
  return body;
}

// Drops a ball, thrown down with a speed from five steps above the floor: the speeds before and after.
function drop(speed, step) {
  const radius = 0.1;
  timeStep = step;
  const shape = new Jolt.SphereShape(radius);
  const ball = add(shape, radius + 5.3 * step * speed, Jolt.EMotionType_Dynamic, moving);
  ball.SetLinearVelocity(new Jolt.Vec3(0, -speed, 0));
  for (let i = 0; i < 20 && ball.GetLinearVelocity().GetY() < 0; ++i) jolt.Step(step, 1);
  const after = ball.GetLinearVelocity().GetY();
  bodies.RemoveBody(ball.GetID());
  bodies.DestroyBody(ball.GetID());
  return [before, after];
}

add(new Jolt.BoxShape(new Jolt.Vec3(1, 1, 1), 0), -1, Jolt.EMotionType_Static, fixed);
compare(drop, 1e-6);
