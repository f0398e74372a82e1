// Central impacts of balls whose surfaces rub each other as they spread: reference values of an independent program,
// limits and balances.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "contact/along.hpp"
#include "impact/oblique/rings/outward_impact.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {
namespace outward_impacts {
namespace {

Resolution resolved(const Contact& contact, int rings, double share = 0.25) {
  Resolution resolution;
  resolution.step = share / contact.cutoff;
  resolution.nodes = rings;
  return resolution;
}

OutwardImpact rubbed(const Contact& contact, double speed, double friction, int rings, double share = 0.25) {
  return outward_impact(contact, contact_outward(contact, {}), speed, friction, resolved(contact, rings, share));
}

struct Reference {
  double speed, cutoff;
  int rings;
  double friction, restitution, loss;
};

void PrintTo(const Reference& its, std::ostream* out) { *out << "v " << its.speed << ", mu " << its.friction; }

class OutwardReference : public ::testing::TestWithParam<Reference> {};

// ν = 0.3 at a rigid wall.
TEST_P(OutwardReference, IsThatOfAnIndependentProgram) {
  const Reference& its = GetParam();
  const ObliqueImpact impact = rubbed(contact(sphere(0.3, its.cutoff)), its.speed, its.friction, its.rings).impact;
  EXPECT_NEAR(impact.restitution, its.restitution, 1e-6);
  EXPECT_NEAR(impact.energy.friction, its.loss, 6e-6);
}

INSTANTIATE_TEST_SUITE_P(
    All, OutwardReference,
    ::testing::Values(Reference{1e-3, 6.0, 24, 0.1, 0.998079, 3.60e-3},
                      Reference{1e-3, 6.0, 48, 0.1, 0.998116, 3.52e-3}, Reference{1e-3, 6.0, 24, 0.3, 0.999511, 7.3e-4},
                      Reference{1e-3, 6.0, 48, 0.3, 0.999631, 4.9e-4}, Reference{1e-3, 6.0, 24, 1.0, 0.999877, 0.0},
                      Reference{0.1, 12.0, 24, 0.0, 0.991231, 0.0}, Reference{0.1, 12.0, 24, 0.1, 0.991346, 8.04e-4},
                      Reference{0.1, 12.0, 24, 0.3, 0.991732, 5.91e-4},
                      Reference{0.1, 12.0, 24, 1.0, 0.992000, 1.97e-4}));

TEST(OutwardImpact, IsCentralWithoutFriction) {
  const Contact wall = contact(sphere(0.3, 8.0));
  for (const double speed : {1e-3, 0.1}) {
    const Impact central = impact(wall, speed, {.resolution = resolved(wall, 24)});
    const ObliqueImpact smooth = rubbed(wall, speed, 0.0, 24).impact;
    EXPECT_NEAR(smooth.restitution, central.restitution, 2e-5);
    EXPECT_NEAR(smooth.normal.max_force, central.max_force, 2e-4 * central.max_force);  // both directions in the tail
    EXPECT_EQ(smooth.energy.friction, 0.0);
    EXPECT_NEAR(rubbed(wall, speed, 1e-7, 24).impact.restitution, smooth.restitution, 1e-8);
  }
}

TEST(OutwardImpact, IsThatWithoutFrictionBetweenEqualSpheres) {
  const Contact equal = contact(sphere(0.3, 6.0), sphere(0.3, 6.0));
  const double central = impact(equal, 0.02, {.resolution = resolved(equal, 24)}).restitution;
  const double smooth = rubbed(equal, 0.02, 0.0, 24).impact.restitution;
  EXPECT_NEAR(smooth, central, 1e-13);
  for (const double friction : {0.1, 0.3, 2.0}) {
    EXPECT_EQ(rubbed(equal, 0.02, friction, 24).impact.restitution, smooth) << friction;
  }
}

TEST(OutwardImpact, ClosesItsBalances) {
  const RefinableContact soft(sphere(0.3), half_space(HalfSpace{.poisson = 0.1, .young = 4.0}));
  const Contact& on_half_space = soft.at(6.0, 1.5, {});
  const Contact unlike = contact(sphere(Sphere{0.1}), sphere(Sphere{.poisson = 0.4, .radius = 0.7, .young = 3.0}), 6.0);
  for (const Contact& each : {contact(sphere(0.0, 6.0)), unlike, on_half_space}) {
    double last = 1.0;
    for (const double share : {0.5, 0.25}) {
      const auto [impact, momentum, resolution, steps] = rubbed(each, 0.05, 0.2, 20, share);
      double impulse = 0.0;
      for (const OutwardStep& step : steps) impulse += step.force.sum() * resolution.step;
      EXPECT_NEAR(impulse, each.mass * 0.05 * (1.0 + impact.restitution), 1e-10) << name(each);
      EXPECT_GE(impact.energy.friction, 0.0);
      EXPECT_LT(std::abs(impact.energy_error), 2e-4) << name(each);
      EXPECT_LT(std::abs(impact.energy_error), 0.5 * last) << name(each);
      last = std::abs(impact.energy_error);
      for (const OutwardStep& step : steps) {
        EXPECT_TRUE((step.friction.cwiseAbs().array() <= 0.2 * step.force.array() * (1.0 + 1e-9)).all());
      }
    }
  }
}

TEST(OutwardImpact, DoesNotKnowWhoIsTheFirst) {
  const auto one = sphere(Sphere{0.1}), other = sphere(Sphere{.poisson = 0.4, .young = 3.0});
  const Contact there = contact(one, other, 6.0), back = contact(other, one, 6.0 / std::sqrt(3.0));
  const double to = rubbed(there, 0.05, 0.2, 20).impact.restitution;
  EXPECT_NEAR(rubbed(back, 0.05 / std::sqrt(3.0), 0.2, 20).impact.restitution, to, 1e-7);
}

TEST(OutwardImpact, ConvergesWithRings) {
  const Contact wall = contact(sphere(0.3, 6.0));
  const double fine = rubbed(wall, 1e-3, 0.1, 64).impact.restitution;
  const double coarse = std::abs(rubbed(wall, 1e-3, 0.1, 16).impact.restitution - fine);
  EXPECT_LT(std::abs(rubbed(wall, 1e-3, 0.1, 32).impact.restitution - fine), 0.6 * coarse);
  EXPECT_LT(coarse, 1.5e-4);
}

}  // namespace
}  // namespace outward_impacts
}  // namespace stoss
