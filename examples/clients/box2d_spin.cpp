// A rough ball in a plane hits the floor at an angle in Box2D 2.4, and leaves with the velocity and spin of the
// collision rule.
//
//   stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.2:1
//       --tolerance 0.05 --oblique -o rule.h
//   c++ box2d_spin.cpp -lbox2d && ./a.out
//
// Copy body_of, set and Rule. PreSolve sets velocities and spins of what approaches. The contact may stay on: the
// solver then finds bodies that part, and leaves them alone. What approaches slower than the table begins is left to
// Box2D, which so holds what rests; let the table begin above the 0.16 m/s that gravity adds in a step of 1/60 s.
// Where continuous physics meets a fast body within a step, gravity has acted before PreSolve, and the rule holds too;
// it is off here. Box2D limits a spin to a quarter turn a step. Bodies that move freely are balls, of moment
// 2/5 m R^2. A table of disks is for one friction, that of its command. Units are m, kg, s.
#include <box2d/box2d.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "rule.h"
#include "throws.h"

namespace {

constexpr float radius = 0.1F, gravity = 9.81F, friction = 0.3F, mass = 4.19F;

stoss_rule_body_2d body_of(const b2Fixture& fixture, const b2Vec2& point) {
  const b2Body& body = *fixture.GetBody();
  if (body.GetType() != b2_dynamicBody) {  // a wall, which moves as it does at the point
    const b2Vec2 velocity = body.GetLinearVelocityFromWorldPoint(point);
    return {0.0, 0.0, 0.0, {velocity.x, velocity.y}, 0.0};
  }
  const b2Vec2 velocity = body.GetLinearVelocity();
  return {1.0 / body.GetMass(),
          1.0 / body.GetInertia(),
          fixture.GetShape()->m_radius,
          {velocity.x, velocity.y},
          body.GetAngularVelocity()};
}

void set(b2Body& body, const stoss_rule_body_2d& round) {
  if (round.inverse_mass == 0.0) return;
  body.SetLinearVelocity({static_cast<float>(round.velocity[0]), static_cast<float>(round.velocity[1])});
  body.SetAngularVelocity(static_cast<float>(round.spin));
}

class Rule : public b2ContactListener {
 public:
  void PreSolve(b2Contact* contact, const b2Manifold*) override {
    b2WorldManifold manifold;
    contact->GetWorldManifold(&manifold);
    const double normal[2] = {manifold.normal.x, manifold.normal.y};  // from a to b
    b2Fixture &first = *contact->GetFixtureA(), &second = *contact->GetFixtureB();
    stoss_rule_body_2d a = body_of(first, manifold.points[0]), b = body_of(second, manifold.points[0]);
    const double speed = (a.velocity[0] - b.velocity[0]) * normal[0] + (a.velocity[1] - b.velocity[1]) * normal[1];
    if (speed < STOSS_RULE_SLOWEST || stoss_rule_collide_2d(&a, &b, normal, contact->GetFriction()) <= 0) return;
    set(*first.GetBody(), a);
    set(*second.GetBody(), b);
  }
};

// The motion of a ball before and after its first impact, or where it is after three seconds.
struct Flight {
  stoss_rule_body_2d before, after;
  float height;
};

Flight fly(const Throw& thrown, float step) {
  const float down = static_cast<float>(thrown.down);
  b2World world({0.0F, -gravity});
  world.SetContinuousPhysics(false);
  Rule rule;
  world.SetContactListener(&rule);
  const b2BodyDef ground;
  b2EdgeShape floor;
  floor.SetTwoSided({-9.0F, 0.0F}, {9.0F, 0.0F});
  world.CreateBody(&ground)
      ->CreateFixture(&floor, 0.0F)
      ->SetFriction(friction);  // the engine multiplies, then takes the root

  b2BodyDef start;
  start.type = b2_dynamicBody;
  start.position = {0.0F, radius + b2_polygonRadius + 1.3F * step * down};
  start.linearVelocity = {static_cast<float>(thrown.along), -down};
  start.angularVelocity = static_cast<float>(thrown.rim) / radius;
  b2CircleShape ball;
  ball.m_radius = radius;
  b2Body* body = world.CreateBody(&start);
  b2Fixture* fixture = body->CreateFixture(&ball, 1.0F);
  fixture->SetFriction(friction);
  const b2MassData data = {mass, {0.0F, 0.0F}, 0.4F * mass * radius * radius};
  body->SetMassData(&data);

  Flight flight = {{}, body_of(*fixture, start.position), 0.0F};
  for (float time = 0.0F; time < 3.0F && flight.after.velocity[1] < 0.1; time += step) {
    flight.before = flight.after;
    world.Step(step, 8, 3);
    flight.after = body_of(*fixture, start.position);
  }
  flight.height = body->GetPosition().y - b2_polygonRadius;
  return flight;
}

}  // namespace

int main() {
  constexpr double down[2] = {0.0, -1.0}, accuracy = 1e-6;
  bool wrong = false;
  std::puts(" step/s   down  along   rim/(m/s)  after: along, up, rim            difference from the rule");
  for (const Throw& thrown : throws) {
    for (const float step : {1e-3F, 1.0F / 60.0F}) {
      Flight flight = fly(thrown, step);
      stoss_rule_body_2d floor = {}, &wanted = flight.before, &found = flight.after;
      stoss_rule_collide_2d(&wanted, &floor, down, friction);
      wanted.velocity[1] -= static_cast<double>(gravity * step);  // which acts after PreSolve
      const double is[3] = {found.velocity[0], found.velocity[1], found.spin * found.radius};
      const double should[3] = {wanted.velocity[0], wanted.velocity[1], wanted.spin * wanted.radius};
      if (compare(&thrown, static_cast<double>(step), is, should, 3, accuracy) != 0) wrong = true;
    }
  }
  const float height = fly({0.03, 0.0, 0.0}, 1.0F / 60.0F).height;
  std::printf("a ball that falls slower than the table begins rests at %.4f m\n", static_cast<double>(height));
  if (!(std::abs(height - radius) < 0.05F * radius)) wrong = true;
  return wrong ? 1 : 0;
}
