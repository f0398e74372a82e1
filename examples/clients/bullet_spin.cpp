// A rough ball hits the floor at an angle in Bullet 3 and leaves with the velocity and spin of the collision rule.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.2:1
//       --tolerance 0.05 --oblique -o rule.h
//   c++ bullet_spin.cpp $(pkg-config --cflags --libs bullet) && ./a.out
//
// Copy body_of, set, point_added and the settings of `fly` that have a comment. The callback sets velocities and spins
// of what approaches. The contact stays on: the solver then finds bodies that part, and leaves them alone. What
// approaches slower than the table begins is left to Bullet, which so holds what rests; let the table begin above the
// 0.16 m/s that gravity adds in a step of 1/60 s. Bodies that move freely are spheres. Units are m, kg, s.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "rule.h"
#include "throws.h"

namespace {

constexpr btScalar radius = 0.1F, gravity = 9.81F, friction = 0.3F;

stoss_rule_body_3d body_of(const btRigidBody& body, const btVector3& point) {
  if (body.isStaticOrKinematicObject()) {  // a wall, which moves as it does at the point
    const btVector3 v = body.getVelocityInLocalPoint(point - body.getCenterOfMassPosition());
    return {0.0, 0.0, 0.0, {v.x(), v.y(), v.z()}, {0.0, 0.0, 0.0}};
  }
  const btVector3 &v = body.getLinearVelocity(), &spin = body.getAngularVelocity();
  return {body.getInvMass(),
          body.getInvInertiaDiagLocal().x(),
          static_cast<const btSphereShape*>(body.getCollisionShape())->getRadius(),
          {v.x(), v.y(), v.z()},
          {spin.x(), spin.y(), spin.z()}};
}

btVector3 vector(const double* v) {
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}

void set(btRigidBody& body, const stoss_rule_body_3d& round) {
  if (round.inverse_mass == 0.0) return;
  body.setLinearVelocity(vector(round.velocity));
  body.setAngularVelocity(vector(round.spin));
}

btRigidBody& body_in(const btCollisionObjectWrapper* object) {
  return *const_cast<btRigidBody*>(btRigidBody::upcast(object->getCollisionObject()));
}

bool point_added(btManifoldPoint& point, const btCollisionObjectWrapper* first, int, int,
                 const btCollisionObjectWrapper* second, int, int) {
  if (point.getDistance() > 0) return false;  // near, not yet in touch
  const btVector3 n = -point.m_normalWorldOnB;
  const double normal[3] = {n.x(), n.y(), n.z()};  // from a to b
  stoss_rule_body_3d a = body_of(body_in(first), point.getPositionWorldOnA());
  stoss_rule_body_3d b = body_of(body_in(second), point.getPositionWorldOnB());
  double speed = 0.0;
  for (int i = 0; i < 3; ++i) speed += (a.velocity[i] - b.velocity[i]) * normal[i];
  if (speed < STOSS_RULE_SLOWEST || stoss_rule_collide_3d(&a, &b, normal, point.m_combinedFriction) <= 0) return false;
  set(body_in(first), a);
  set(body_in(second), b);
  return false;
}

// The motion of a ball before and after its first impact, or where it is after three seconds.
struct Flight {
  stoss_rule_body_3d before, after;
  btScalar height;
};

Flight fly(const Throw& thrown, btScalar step) {
  const auto down = static_cast<btScalar>(thrown.down), along = static_cast<btScalar>(thrown.along);
  const btScalar mass = 4.19F, spin = static_cast<btScalar>(thrown.rim) / radius;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, -gravity, 0});
  world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;  // what pushes apart adds nothing to velocities
  gContactAddedCallback = point_added;

  btStaticPlaneShape plane({0, 1, 0}, 0);
  btRigidBody floor(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  btSphereShape sphere(radius);
  btVector3 inertia;
  sphere.calculateLocalInertia(mass, inertia);
  btRigidBody ball(btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &sphere, inertia));
  ball.setCollisionFlags(ball.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);  // ask us
  ball.setFriction(friction);
  floor.setFriction(1);                   // the engine multiplies
  ball.setContactProcessingThreshold(0);  // what has not touched does not count
  ball.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), {0, radius + 1.3F * step * down, 0}));
  ball.setLinearVelocity({along, -down, 0.5F * along});
  ball.setAngularVelocity({-0.3F * spin, 2, spin});
  world.addRigidBody(&floor);
  world.addRigidBody(&ball);
  Flight flight = {{}, body_of(ball, ball.getCenterOfMassPosition()), 0};
  for (btScalar time = 0; time < 3 && flight.after.velocity[1] < 0.1; time += step) {
    flight.before = flight.after;
    world.stepSimulation(step, 0);
    flight.after = body_of(ball, ball.getCenterOfMassPosition());
  }
  flight.height = ball.getCenterOfMassPosition().y();
  world.removeRigidBody(&ball);
  world.removeRigidBody(&floor);
  return flight;
}

}  // namespace

int main() {
  constexpr double down[3] = {0.0, -1.0, 0.0}, accuracy = 1e-6;
  bool wrong = false;
  std::puts(" step/s   down  along   rim/(m/s)  after: velocity, then spin times radius     difference from the rule");
  for (const Throw& thrown : throws) {
    for (const btScalar step : {1e-3F, 1.0F / 60.0F}) {
      Flight flight = fly(thrown, step);
      stoss_rule_body_3d floor = {}, &wanted = flight.before;
      const stoss_rule_body_3d& found = flight.after;
      stoss_rule_collide_3d(&wanted, &floor, down, friction);
      wanted.velocity[1] -= static_cast<double>(gravity * step);  // which acts after the callback
      double is[6], should[6];
      for (int i = 0; i < 3; ++i) {
        is[i] = found.velocity[i];
        should[i] = wanted.velocity[i];
        is[3 + i] = found.spin[i] * found.radius;
        should[3 + i] = wanted.spin[i] * wanted.radius;
      }
      if (compare(&thrown, static_cast<double>(step), is, should, 6, accuracy) != 0) wrong = true;
    }
  }
  const btScalar height = fly({0.03, 0.0, 0.0}, 1.0F / 60.0F).height;
  std::printf("a ball that falls slower than the table begins rests at %.4f m\n", static_cast<double>(height));
  if (!(std::abs(height - radius) < 0.05F * radius)) wrong = true;
  return wrong ? 1 : 0;
}
