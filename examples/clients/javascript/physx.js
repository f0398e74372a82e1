// A ball falls on the floor in PhysX and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format js
//       -o restitution.mjs
//   npm ci --omit=peer && node physx.js
//
// Copy beforeStep and the settings of `drop` that have a comment. PhysX in JavaScript asks nobody for a restitution (in
// C++ PxContactModifyCallback does): it is set before each step, as that of the ball's own material by the rule of the
// maximum, and holds for all that the ball meets in this step. Gravity acts first, then PhysX multiplies the velocity:
// beforeStep adds what is still to come. The ratio of the speeds is then that of the table to the rounding of float.
// Units are m, kg, s.
import { readFileSync } from "node:fs";
import load from "physx-js-webidl";
import { compare } from "./compare.js";
import { stoss_restitution } from "./restitution.mjs";

// The package is made for browsers alone: there `await load()` does.
const wasmBinary = readFileSync(new URL("physx-js-webidl.wasm", import.meta.resolve("physx-js-webidl")));
const { process } = globalThis;
Object.assign(globalThis, { window: globalThis, process: undefined });
const PhysX = await load({ wasmBinary });
globalThis.process = process;

const version = PhysX.PHYSICS_VERSION;
const told = [new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback()];
const scale = new PhysX.PxTolerancesScale();
const physics = PhysX.CreatePhysics(version, PhysX.CreateFoundation(version, ...told), scale);
const { eSCENE_QUERY_SHAPE, eSIMULATION_SHAPE } = PhysX.PxShapeFlagEnum;
const flags = new PhysX.PxShapeFlags(eSCENE_QUERY_SHAPE | eSIMULATION_SHAPE);
const gravity = [0, -9.81, 0];

function place(y) {
  const pose = new PhysX.PxTransform(PhysX.PxIDENTITYEnum.PxIdentity);
  pose.set_p(new PhysX.PxVec3(0, y, 0));
  return pose;
}

function add(scene, actor, geometry, material) {
  const shape = physics.createShape(geometry, material, true, flags);
  shape.setSimulationFilterData(new PhysX.PxFilterData(1, 1, 0, 0));
  actor.attachShape(shape);
  scene.addActor(actor);
  return actor;
}

// Before each step, of each ball that may meet something at rest whose normal, towards the ball, is known.
function beforeStep(ball, material, normal, step) {
  const velocity = ball.getLinearVelocity();
  const now = [velocity.get_x(), velocity.get_y(), velocity.get_z()];
  const approach = -normal.reduce((sum, n, i) => sum + n * (now[i] + step * gravity[i]), 0);
  if (approach > 0) material.setRestitution(stoss_restitution(approach));
  return approach;
}

// Drops a ball, thrown down with a speed from five steps above the floor: the speeds before and after.
function drop(speed, step) {
  const radius = 0.1;
  const settings = new PhysX.PxSceneDesc(scale);
  settings.set_gravity(new PhysX.PxVec3(...gravity));
  settings.set_cpuDispatcher(PhysX.DefaultCpuDispatcherCreate(0));
  settings.set_filterShader(PhysX.DefaultFilterShader());
  settings.set_bounceThresholdVelocity(1e-3); // slow balls bounce too
  const scene = physics.createScene(settings);
  const material = physics.createMaterial(0, 0, 0); // of this ball alone
  material.setRestitutionCombineMode(PhysX.PxCombineModeEnum.eMAX);
  const box = new PhysX.PxBoxGeometry(1, 1, 1);
  add(scene, physics.createRigidStatic(place(-1)), box, physics.createMaterial(0, 0, 0));
  const sphere = new PhysX.PxSphereGeometry(radius);
  const ball = add(scene, physics.createRigidDynamic(place(radius + 5.3 * step * speed)), sphere, material);
  PhysX.PxRigidBodyExt.prototype.setMassAndUpdateInertia(ball, 4.19);
  ball.setLinearDamping(0);
  ball.setLinearVelocity(new PhysX.PxVec3(0, -speed, 0));
  let before = 0;
  for (let i = 0; i < 20 && ball.getLinearVelocity().get_y() < 0; ++i) {
    before = beforeStep(ball, material, [0, 1, 0], step);
    scene.simulate(step);
    scene.fetchResults(true);
  }
  const after = ball.getLinearVelocity().get_y();
  scene.release();
  return [before, after];
}

compare(drop, 1e-6);
