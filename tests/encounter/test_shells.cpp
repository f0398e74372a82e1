// Where linear elasticity ends in hollow spheres, from which speed they yield, and what is said of both.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/moving.hpp"
#include "stoss/prediction/prediction.hpp"

namespace stoss {
namespace {

Encounter hollow_ball(double inner, double strength = 0.0) {
  Participant first{.kind = "hollow-sphere", .values = {{"radius", 0.02}, {"inner", inner}}};
  first.material = Material{.young = 2.5e9, .poisson = 0.35, .density = 1400.0};
  if (strength > 0.0) first.material->yield_strength = strength;
  return {.first = first};
}

TEST(Shells, EndTheirLinearRangeAtTheLoadOfReissnerTimesTheirThickness) {
  const auto limit = shell_limit(hollow_ball(0.98));
  ASSERT_TRUE(limit);
  const double stiffness = 4.0 * 2.5e9 * 16e-8 / (0.02 * std::sqrt(3.0 * (1.0 - 0.35 * 0.35)));
  EXPECT_NEAR(limit->force / (stiffness * 0.4e-3), 1.0, 1e-12);
  const double mass = 1400.0 * 4.0 / 3.0 * M_PI * 8e-6 * (1.0 - std::pow(0.98, 3));
  EXPECT_NEAR(limit->speed / (0.4e-3 * std::sqrt(stiffness / mass)), 1.0, 1e-12);
  EXPECT_FALSE(shell_limit({.first = {.kind = "sphere", .values = {{"poisson", 0.3}}}}));
}

TEST(Shells, OfTwoEqualBallsTakeTwiceTheSpeedOfOne) {
  Encounter pair = hollow_ball(0.98);
  pair.against = of_kind("same");
  EXPECT_NEAR(shell_limit(pair)->speed / shell_limit(hollow_ball(0.98))->speed, 2.0, 1e-12);
}

TEST(Shells, AreWarnedOfFromTheirLimitsOn) {
  const Encounter its = hollow_ball(0.98);
  const double begins = shell_limit(its)->speed;
  EXPECT_TRUE(shell_warnings(its, 0.99 * begins).empty());
  ASSERT_EQ(shell_warnings(its, 1.5 * begins).size(), 1U);
  EXPECT_EQ(shell_warnings(its, 1.5 * begins).front().find("buckles"), std::string::npos);
  EXPECT_NE(shell_warnings(its, 2.5 * begins).front().find("buckles"), std::string::npos);
  EXPECT_NE(material_warnings(its, 1.5 * begins).front().find("thickness"), std::string::npos);
  EXPECT_NE(shell_warnings(hollow_ball(0.98, 5e7), begins).front().find("bending"), std::string::npos);
}

TEST(Shells, YieldLaterThanAsSolidBallsOfTheirMassWould) {
  Encounter solid = hollow_ball(1e-6, 5e7);
  solid.first.kind = "sphere", solid.first.values.erase("inner");
  const double whole = *yield_speed(solid);
  EXPECT_NEAR(*yield_speed(hollow_ball(1e-6, 5e7)) / whole, 1.0, 0.02);  // by a spring that is made for thin shells
  EXPECT_GT(*yield_speed(hollow_ball(0.9, 5e7)), whole / std::sqrt(1.0 - 0.729));
}

TEST(Shells, ArePredicted) {
  const auto made = predict(hollow_ball(0.9, 5e7), {0.1}, {.influences = false});
  EXPECT_GT(made.front().restitution.value, 0.9);
  EXPECT_GT(made.front().share(Channel::ringing), 0.0);
}

TEST(Shells, MoveWithTheirOwnMassAndInertia) {
  const MovingPair pair = moving_pair(hollow_ball(0.9));
  EXPECT_NEAR(pair.first.inverse_inertia / pair.first.inverse_mass, 2.5 * (1.0 - 0.729) / (1.0 - std::pow(0.9, 5)),
              1e-12);
}

}  // namespace
}  // namespace stoss
