// The speed at which a sphere begins to yield, against Johnson's numbers and the static stress.
#include "stoss/quasistatic/yield.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/impact.hpp"
#include "support/refusal.hpp"

namespace stoss::quasistatic {
namespace {

Material steel(std::optional<double> strength) { return {2.1e11, 0.3, 7850.0, strength}; }

// K. L. Johnson, Contact Mechanics, section 11.5(a): ½mV² ≈ 53 R³Y⁵/E*⁴, ρV²/Y = 26 (Y/E*)⁴, and 0.14 m/s for a hard
// steel sphere (Y = 1000 N/mm²) at a steel half-space, for which E* is that of two equal halves.
TEST(YieldSpeed, IsJohnsons) {
  const double reduced = 2.1e11 / (1.0 - 0.09), strength = 1e9;
  const double v = yield_speed(steel(strength), 0.01).value();
  const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-6 * 7850.0;
  EXPECT_NEAR(0.5 * mass * v * v / (1e-6 * std::pow(strength, 5) / std::pow(reduced, 4)), 53.0, 0.5);
  EXPECT_NEAR(7850.0 * v * v / strength / std::pow(strength / reduced, 4), 26.0, 0.5);
  const Material at_steel{0.5 * 2.1e11, 0.3, 7850.0, strength};
  EXPECT_NEAR(yield_speed(at_steel, 0.01).value(), 0.14, 0.005);
}

TEST(YieldSpeed, DoesNotDependOnTheRadius) {
  EXPECT_NEAR(yield_speed(steel(1e9), 1e-6).value() / yield_speed(steel(1e9), 10.0).value(), 1.0, 1e-13);
}

TEST(YieldSpeed, OfEqualSpheresIsTwiceThatAtAWall) {
  const double wall = yield_speed(steel(1e9), 0.01).value();
  EXPECT_NEAR(yield_speed(steel(1e9), 0.01, steel(1e9), 0.01).value() / (2.0 * wall), 1.0, 1e-14);
}

TEST(YieldSpeed, OfAPairIsThatOfTheWeaker) {
  const Material glass{7e10, 0.22, 2500.0, 5e8};
  const double both = yield_speed(steel(1e9), 0.01, glass, 0.02).value();
  EXPECT_EQ(both, yield_speed(steel({}), 0.01, glass, 0.02));
  EXPECT_NEAR(both / yield_speed(glass, 0.02, steel(1e9), 0.01).value(), 1.0, 1e-14);
  EXPECT_GT(yield_speed(steel(1e9), 0.01, {7e10, 0.22, 2500.0}, 0.02), both);
}

TEST(YieldSpeed, AtAGreatHardSphereIsThatAtAWall) {
  const Material diamond{1e30, 0.2, 1e10};
  const double pair = yield_speed(steel(1e9), 0.01, diamond, 1e6).value();
  EXPECT_NEAR(pair / yield_speed(steel(1e9), 0.01).value(), 1.0, 1e-6);
}

// Two spheres of which one grows: the error is of the order of R/R₂.
TEST(YieldSpeed, AtAHalfSpaceIsTheLimitOfAGreatSphere) {
  constexpr double half_space = std::numeric_limits<double>::infinity();
  const Material glass{7e10, 0.22, 2500.0, 5e8};
  const double limit = yield_speed(steel(1e9), 0.01, glass, half_space).value();
  EXPECT_NEAR(yield_speed(steel(1e9), 0.01, glass, 1e4).value() / limit, 1.0, 1e-5);
  EXPECT_NEAR(yield_speed(glass, half_space, steel(1e9), 0.01).value() / limit, 1.0, 1e-14);
  const double wall = yield_speed(steel(1e9), 0.01).value();  // v ∝ 1/E*²: of one material it is twice as soft
  EXPECT_NEAR(yield_speed(steel(1e9), 0.01, steel(1e9), half_space).value() / wall, 4.0, 1e-12);
}

TEST(YieldSpeed, OfARigidSphereIsTheLimitOfAHardOne) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Material glass{7e10, 0.22, 2500.0, 5e8}, rigid{infinity, 0.3, 7850.0, 1.0}, hard{1e20, 0.3, 7850.0};
  const double limit = yield_speed(rigid, 0.01, glass, infinity).value();
  EXPECT_NEAR(yield_speed(hard, 0.01, glass, infinity).value() / limit, 1.0, 1e-8);
  EXPECT_FALSE(yield_speed(rigid, 0.01, steel({}), infinity));  // it does not yield itself
  EXPECT_THROW((void)yield_speed(rigid, 0.01, rigid, infinity), InvalidInput);
  EXPECT_THROW((void)yield_speed(glass, infinity, glass, infinity), InvalidInput);
}

TEST(YieldSpeed, IsNotKnownWithoutAStrength) {
  EXPECT_FALSE(yield_speed(steel({}), 0.01));
  EXPECT_FALSE(yield_speed(steel({}), 0.01, steel({}), 0.02));
}

// In the computed impact at that speed the maximum force is that of Hertz' pressure 1.6 Y, F = π³R²p₀³/(6E*²), but for
// what is beyond Hertz, of the order of a/R = 0.01.
TEST(YieldSpeed, IsThatOfTheComputedImpact) {
  const Material material = steel(1e9);
  const double radius = 0.01, reduced = 2.1e11 / 0.91, pressure = 1.6 * 1e9;
  const Scales si = scales(Sphere{0.3, radius, 2.1e11, 7850.0});
  const double v = yield_speed(material, radius).value() / si.speed;
  const Impact hit = impact(contact(sphere(0.3, 25.0)), v);
  const double force = std::pow(std::numbers::pi * pressure, 3) * radius * radius / (6.0 * reduced * reduced);
  EXPECT_NEAR(hit.max_force * si.force / force, 1.0, 0.01) << v;
}

TEST(YieldSpeed, RefusesWhatNoMaterialHas) {
  EXPECT_THROW((void)yield_speed(steel(-1.0), 0.01), InvalidInput);
  EXPECT_THROW((void)yield_speed(steel(0.0), 0.01), InvalidInput);
  EXPECT_THROW((void)yield_speed(steel(1e9), 0.0), InvalidInput);
  EXPECT_THROW((void)yield_speed(steel({}), 0.01, steel(1e9), -1.0), InvalidInput);
}

}  // namespace
}  // namespace stoss::quasistatic
