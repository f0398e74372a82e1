// Masses and moments of inertia of those who meet.
#include "stoss/encounter/moving.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

#include "support/refusal.hpp"

namespace stoss {
namespace {

// Of homogeneous bodies: m and I of a shell are those of the ball less those of its hole.
TEST(MovingPairs, HaveMassesAndMomentsOfInertia) {
  const auto of = [](const char* kind, Values values) {
    return Participant{.kind = kind, .values = std::move(values)};
  };
  const double mass = 4.0 / 3.0 * std::numbers::pi;
  const MovingPair balls = moving_pair(
      {.first = of("sphere", {{"poisson", 0.3}}), .against = of("hollow-sphere", {{"inner", 0.5}, {"radius", 2.0}})});
  EXPECT_EQ(balls.dimension, 3);
  EXPECT_DOUBLE_EQ(balls.first.inverse_mass * mass, 1.0);
  EXPECT_DOUBLE_EQ(balls.first.inverse_inertia * 0.4 * mass, 1.0);
  EXPECT_DOUBLE_EQ(balls.second.radius, 2.0);
  EXPECT_DOUBLE_EQ(balls.second.inverse_mass * mass * (8.0 - 1.0), 1.0);
  EXPECT_DOUBLE_EQ(balls.second.inverse_inertia * 0.4 * mass * (32.0 - 1.0), 1.0);
  const MovingPair larger = balls.resized(3.0, 4.0);
  EXPECT_DOUBLE_EQ(larger.first.inverse_mass * mass * 27.0, 1.0);
  EXPECT_DOUBLE_EQ(larger.second.inverse_inertia, balls.second.inverse_inertia / 32.0);
  const MovingPair disk = moving_pair({.first = of("disk", {{"poisson", 0.3}})});
  EXPECT_EQ(disk.dimension, 2);
  EXPECT_DOUBLE_EQ(disk.first.inverse_inertia * 0.5 * std::numbers::pi, 1.0);
  EXPECT_EQ(disk.second.inverse_mass, 0.0);
  test::expect_refusal([] { (void)moving_pair({.first = of_kind("rod")}); }, {"body", "rods cannot be moved"});
}

}  // namespace
}  // namespace stoss
