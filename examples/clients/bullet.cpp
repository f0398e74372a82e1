// A ball falls on the floor in Bullet 3 and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format c
//       -o restitution.h
//   c++ bullet.cpp $(pkg-config --cflags --libs bullet) && ./a.out
//
// Copy point_added and the settings of `drop` that have a comment. Bullet multiplies the relative velocity that bodies
// have in the callback, before gravity acts in this step. But it brakes what comes near before it touches, pushes apart
// what overlaps by adding to its velocity, and lets nothing bounce below 0.2 m/s: as it is set up, the ratio of the
// speeds may be anything. With these settings it is that of the table to the rounding of float. Units are m, kg, s.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "restitution.h"

namespace {

double before = 0.0;  // of the first impact, for this example

btVector3 velocity(const btCollisionObjectWrapper& object, const btVector3& point) {
  const btRigidBody* body = btRigidBody::upcast(object.getCollisionObject());
  return body->getVelocityInLocalPoint(point - body->getCenterOfMassPosition());
}

bool point_added(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int, const btCollisionObjectWrapper* b,
                 int, int) {
  const btVector3 relative = velocity(*b, point.getPositionWorldOnB()) - velocity(*a, point.getPositionWorldOnA());
  const double speed = relative.dot(point.m_normalWorldOnB);  // from b to a
  if (speed <= 0.0) return false;
  point.m_combinedRestitution = static_cast<btScalar>(stoss_restitution(speed));
  if (before == 0.0 && point.getDistance() <= 0) before = speed;
  return true;
}

// Drops a ball, thrown down with a speed from five steps above the floor; returns how fast it leaves.
double drop(btScalar speed, btScalar step) {
  const btScalar radius = 0.1F, mass = 4.19F;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, -9.81F, 0});
  world.getSolverInfo().m_restitutionVelocityThreshold = 0;      // slow balls bounce too
  world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;  // what pushes apart adds nothing to velocities
  gContactAddedCallback = point_added;

  btStaticPlaneShape plane({0, 1, 0}, 0);
  btRigidBody floor(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  btSphereShape sphere(radius);
  btVector3 inertia;
  sphere.calculateLocalInertia(mass, inertia);
  btRigidBody ball(btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &sphere, inertia));
  ball.setCollisionFlags(ball.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);  // ask us
  ball.setContactProcessingThreshold(0);  // what has not touched does not count
  ball.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), {0, radius + 5.3F * step * speed, 0}));
  ball.setLinearVelocity({0, -speed, 0});
  world.addRigidBody(&floor);
  world.addRigidBody(&ball);
  before = 0.0;
  for (int i = 0; i < 20 && before == 0.0; ++i) world.stepSimulation(step, 0);
  world.removeRigidBody(&ball);
  world.removeRigidBody(&floor);
  return ball.getLinearVelocity().y();
}

}  // namespace

int main() {
  constexpr double accuracy = 1e-6;
  bool wrong = false;
  std::puts(" step/s  before/(m/s)  after/before  eps of the table +- its error  difference");
  for (const btScalar speed : std::vector<btScalar>{0.02F, 0.1F, 0.5F, 2.0F, 8.0F}) {
    for (const btScalar step : std::vector<btScalar>{1e-3F, 1.0F / 60.0F}) {
      const double after = drop(speed, step), found = after / before, wanted = stoss_restitution(before);
      std::printf("%7.5f %13.7f %13.9f %17.9f +- %.5f %11.1e\n", static_cast<double>(step), before, found, wanted,
                  stoss_restitution_error(before), found - wanted);
      if (!(std::abs(found - wanted) <= accuracy)) wrong = true;
    }
  }
  return wrong ? 1 : 0;
}
