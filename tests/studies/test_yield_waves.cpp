// Explicit finite elements of studies/yield/waves: their bodies, and an elastic impact.
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/curve.hpp"
#include "yield/waves/collision.hpp"
#include "yield/waves/mesh.hpp"

namespace {

using namespace yield_study;

constexpr double without_end = std::numeric_limits<double>::infinity();

TEST(YieldWaves, HaveBodiesOfTheirVolume) {
  const Mover ball(free_body(sphere(12, 0.03), 0.3, without_end));
  EXPECT_NEAR(ball.mass(), 4.0 / 3.0 * std::numbers::pi, 0.003 * ball.mass());
  const Mover half(free_body(block(12, 0.03, 40.0), 0.3, without_end));
  EXPECT_NEAR(half.mass(), 2.0 / 3.0 * std::numbers::pi * 64e3, 0.003 * half.mass());
  for (int node = 0; node <= 12; ++node) {
    const double r = half.body().mesh().nodes[static_cast<std::size_t>(node)][0];
    EXPECT_NEAR(ball.body().mesh().nodes[static_cast<std::size_t>(node)][0], r, 3e-4 * r);
    EXPECT_NEAR(ball.place(node), 0.5 * r * r, 3e-4 * r * r);
  }
}

/// Step by step, as the implicit program keeps states.
TEST(YieldWaves, FollowTheLawOfTheImplicitBody) {
  Body one = free_body(sphere(4, 0.3), 0.3, 1e-3), other = one;
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(one.size());
  for (int step = 1; step < 5; ++step) {
    for (int k = 0; k < one.size(); ++k) unknowns[k] = 1e-3 * step * std::sin(step + 2.0 * k);
    one.assemble(unknowns);
    one.keep();
    other.follow(unknowns);
    EXPECT_LT((one.forces() - other.forces()).norm(), 1e-12 * one.forces().norm());
  }
  EXPECT_GT(one.energies().dissipated, 0.0);
  EXPECT_NEAR(one.energies().dissipated, other.energies().dissipated, 1e-12 * one.energies().dissipated);
}

TEST(YieldWaves, AreThoseOfTheElasticEngine_long) {
  constexpr double speed = 1e-4;  // faster: a wide contact, and a large step
  const Outcome its = collide({0.3, without_end, without_end, speed, 8, 0.05, 40.0});
  const stoss::Restitution engine =
      stoss::restitution({stoss::sphere(stoss::Sphere{.poisson = 0.3}), stoss::half_space({.poisson = 0.3})}, speed);
  EXPECT_NEAR(its.imbalance, 0.0, 1e-5);
  EXPECT_NEAR(1.0 - its.restitution * its.restitution, engine.lost_fraction.value, 0.02 * engine.lost_fraction.value);
  EXPECT_NEAR(its.force, engine.max_force.value, 0.01 * engine.max_force.value);
  EXPECT_NEAR(its.time, engine.contact_time.value, 0.01 * engine.contact_time.value);
  EXPECT_NEAR(its.deepest, engine.max_compression.value, 0.01 * engine.max_compression.value);
}

}  // namespace
