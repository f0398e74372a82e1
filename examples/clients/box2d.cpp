// A disk falls on the floor in Box2D 2.4 and leaves with the coefficient of restitution of its speed.
//
//   stoss table --body disk --poisson 0.4 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format c
//       -o restitution.h
//   c++ box2d.cpp -lbox2d && ./a.out
//
// Copy Restitution::PreSolve. Two things of Box2D matter:
// - Below a threshold, 1 m/s unless it is set, nothing bounces: SetRestitutionThreshold(0).
// - A step first calls PreSolve, then lets gravity act, then multiplies the relative velocity: `fall` adds what is
//   still to come. Where continuous physics meets a fast body within a step, gravity has acted before PreSolve, and
//   the term is too much; it is off here.
// The ratio of the speeds is then that of the table to the rounding of float, some 1e-7. Units are m, kg, s.
#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "restitution.h"

namespace {

constexpr float gravity = 9.81F;

class Restitution : public b2ContactListener {
 public:
  explicit Restitution(float step) : fall_(step * b2Vec2(0.0F, -gravity)) {}

  void PreSolve(b2Contact* contact, const b2Manifold*) override {
    const float speed = speed_of_approach(*contact);
    if (speed <= 0.0F) return;
    contact->SetRestitution(static_cast<float>(stoss_restitution(speed)));
    contact->SetRestitutionThreshold(0.0F);
    if (before == 0.0F) before = speed;
  }

  float before = 0.0F;  // of the first impact, for this example

 private:
  float speed_of_approach(const b2Contact& contact) const {
    const b2Body *a = contact.GetFixtureA()->GetBody(), *b = contact.GetFixtureB()->GetBody();
    b2WorldManifold manifold;
    contact.GetWorldManifold(&manifold);  // its normal points from a to b
    float greatest = 0.0F;
    for (int i = 0; i < contact.GetManifold()->pointCount; ++i) {
      const b2Vec2 point = manifold.points[i];
      const b2Vec2 relative = velocity(*a, point) - velocity(*b, point);
      greatest = std::max(greatest, b2Dot(relative, manifold.normal));
    }
    return greatest;
  }

  b2Vec2 velocity(const b2Body& body, const b2Vec2& point) const {
    const b2Vec2 now = body.GetLinearVelocityFromWorldPoint(point);
    return body.GetType() == b2_dynamicBody ? now + body.GetGravityScale() * fall_ : now;
  }

  b2Vec2 fall_;
};

struct Impact {
  double before, after;
};

// Drops a disk, thrown down with a speed from five steps above the floor.
Impact drop(float speed, float step) {
  const float radius = 0.1F;
  b2World world({0.0F, -gravity});
  world.SetContinuousPhysics(false);
  Restitution restitution(step);
  world.SetContactListener(&restitution);

  const b2BodyDef ground;
  b2EdgeShape floor;
  floor.SetTwoSided({-1.0F, 0.0F}, {1.0F, 0.0F});
  world.CreateBody(&ground)->CreateFixture(&floor, 0.0F);

  b2BodyDef thrown;
  thrown.type = b2_dynamicBody;
  thrown.position = {0.0F, radius + b2_polygonRadius + 5.3F * step * speed};
  thrown.linearVelocity = {0.0F, -speed};
  b2CircleShape disk;
  disk.m_radius = radius;
  b2Body* body = world.CreateBody(&thrown);
  body->CreateFixture(&disk, 1000.0F);
  for (int i = 0; i < 20 && restitution.before == 0.0F; ++i) world.Step(step, 8, 3);
  return {restitution.before, body->GetLinearVelocity().y};
}

}  // namespace

int main() {
  constexpr double accuracy = 1e-6;
  bool wrong = false;
  std::puts(" step/s  before/(m/s)  after/before  eps of the table +- its error  difference");
  for (const float speed : std::vector<float>{0.02F, 0.1F, 0.5F, 2.0F, 8.0F}) {
    for (const float step : std::vector<float>{1e-3F, 1.0F / 60.0F}) {
      const Impact impact = drop(speed, step);
      const double found = impact.after / impact.before, wanted = stoss_restitution(impact.before);
      std::printf("%7.5f %13.7f %13.9f %17.9f +- %.5f %11.1e\n", static_cast<double>(step), impact.before, found,
                  wanted, stoss_restitution_error(impact.before), found - wanted);
      if (!(std::abs(found - wanted) <= accuracy)) wrong = true;
    }
  }
  return wrong ? 1 : 0;
}
