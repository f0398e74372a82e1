// Slow impacts of materials that relax tend to those of Ting's law, which have no waves and a small contact.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic/relaxing_impact.hpp"
#include "stoss/relaxation.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {
namespace {

constexpr double ball_mass = 4.0 * std::numbers::pi / 3.0, ball_softness = 0.91;  // ν = 0.3

/// (m/k)^{2/5} v^{−1/5} of a ball at a hard wall: a third of its impact.
double slow_unit(double speed) { return std::pow(ball_mass * 0.75 * ball_softness, 0.4) * std::pow(speed, -0.2); }

BodyMaker slow_ball(const Relaxation& relaxation) { return relaxing(sphere(Sphere{0.3}), relaxation); }

/// 1 − ε of the engine over that of Ting's law, less 1, against what its error and the size of the contact explain.
void expect_limit(const Restitution& engine, const quasistatic::RelaxingImpact& slow, double size) {
  const double loss = 1.0 - slow.restitution;
  EXPECT_TRUE(engine.converged);
  EXPECT_NEAR((1.0 - engine.restitution.value) / loss, 1.0, engine.restitution.error / loss + size) << slow.speed;
}

}  // namespace

// What remains is that a ball is stiffer than Hertz' contact by some a/R ~ v^{2/5}: it loses less, by 0.10 to 0.14
// v^{2/5} of 1 − ε with a term of the unit of time, by 0.32 to 0.45 with one of ten times that.
TEST(SlowRelaxingBodies, TendToTingsLaw) {
  for (const double speed : {1e-4, 1e-6, 1e-8}) {
    for (const double ratio : {1.0, 10.0}) {
      const Relaxation its{{{0.5, ratio * slow_unit(speed)}}};
      expect_limit(restitution(slow_ball(its), speed, {.tolerance = 1e-4}),
                   quasistatic::relaxing_impact({1.0, {{{ball_softness, its}}}, ball_mass}, speed),
                   (ratio == 1.0 ? 0.15 : 0.5) * std::pow(speed, 0.4));
    }
  }
}

TEST(SlowRelaxingBodies, OfTwoMaterialsTendToTheLawOfBoth) {
  for (const double speed : {2e-4, 2e-6}) {
    const double unit = slow_unit(0.5 * speed);
    const Relaxation first{{{0.5, unit}}}, second{{{0.3, 0.3 * unit}, {0.3, 10.0 * unit}}};
    expect_limit(restitution(RefinableContact(slow_ball(first), slow_ball(second)), speed, {.tolerance = 1e-4}),
                 quasistatic::relaxing_impact(
                     {2.0, {{{ball_softness, first}, {ball_softness, second}}}, 0.5 * ball_mass}, speed),
                 0.06 * std::pow(speed, 0.4));
  }
}

}  // namespace stoss
