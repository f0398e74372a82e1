// Impacts of bodies that yield beside explicit finite elements with waves (studies/yield/waves).
#include <gtest/gtest.h>

#include <cmath>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/curve.hpp"
#include "support/csv.hpp"

namespace stoss {
namespace {

BodyMaker of_strength(const BodyMaker& maker, double strength) {
  return std::isinf(strength) ? maker : yielding(maker, {strength});
}

/// Of the finest meshes, whose force is good to 1 %, where both bodies yield or none. Where one yields the engine,
/// which does not ask which, is known to be low.
TEST(YieldingWaves, AreThoseOfFiniteElements) {
  std::size_t count = 0;
  for (const auto& row : test::read_csv("yield_waves.csv")) {
    const double of_ball = row.number("of_ball"), of_block = row.number("of_block"), speed = row.number("speed");
    if (row.integer("elements") < 24 || std::isinf(of_ball) != std::isinf(of_block)) continue;
    const double poisson = row.number("poisson");
    const Restitution its = restitution({of_strength(sphere(Sphere{.poisson = poisson}), of_ball),
                                         of_strength(half_space(HalfSpace{.poisson = poisson}), of_block)},
                                        speed);
    const auto expect_near = [&](double value, const char* name, double share) {
      EXPECT_NEAR(value, row.number(name), share * row.number(name)) << name << " at " << speed;
    };
    const bool yields = !std::isinf(of_ball);
    expect_near(its.restitution.value, "restitution", yields ? 0.015 : 1e-4);
    expect_near(its.max_force.value, "force", yields ? 0.02 : 0.002);
    expect_near(its.contact_time.value, "time", 0.01);
    expect_near(its.max_compression.value, "deepest", 0.01);
    if (yields) {
      expect_near(its.finest.dent, "dent", 0.02);
    }
    ++count;
  }
  EXPECT_GE(count, 3U);
}

}  // namespace
}  // namespace stoss
