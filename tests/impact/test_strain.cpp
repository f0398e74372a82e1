// How far bodies are strained, and that it is said of each kind of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/restitution/curve.hpp"
#include "support/modal_sphere.hpp"

namespace stoss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Impact meeting(const BodyMaker& first, const BodyMaker& second, double speed, double cutoff = 12.0) {
  return impact(contact(first, second, cutoff, speed), speed);
}

void expect_flag(const Impact& impact) { EXPECT_EQ(impact.beyond_small_strain, impact.strain > small_strain_limit); }

// By Hertz and Tabor 0.2 a/R, and no less than v/c.
TEST(Strain, OfRoundBodiesIsThatOfTheirContact) {
  for (const double speed : {1e-2, 0.3}) {
    const Impact ball = impact(sphere(0.3, 12.0), HardWall{}, speed),
                 slice = impact(disk(0.3, 12.0), HardWall{}, speed);
    for (const Impact& each : {ball, slice}) {
      const double contact = 0.2 * each.max_half_width;
      EXPECT_GE(each.strain, std::max(speed, 0.85 * contact)) << each.contact << ' ' << speed;
      EXPECT_LE(each.strain, std::max(speed, 1.15 * contact)) << each.contact << ' ' << speed;
    }
    EXPECT_EQ(ball.beyond_small_strain, speed > 0.1);
    EXPECT_EQ(slice.beyond_small_strain, speed > 0.1);
  }
  const Impact modal = best_restitution(RefinableContact(modal_body(test::modal_sphere(0.3, 16.0))), 0.01, {}).finest;
  EXPECT_NEAR(modal.strain / (0.2 * modal.max_half_width), 1.0, 0.1);
}

// Of two bodies of one material each takes half of it at a wall; of unlike ones the softer nearly all.
TEST(Strain, IsThatOfTheSofterBody) {
  const BodyMaker ball = sphere(Sphere{.poisson = 0.3});
  const Impact equal = meeting(ball, half_space(HalfSpace{.poisson = 0.3}), 0.01);
  EXPECT_NEAR(equal.strain / (0.1 * equal.max_half_width), 1.0, 0.1);
  const Impact soft = meeting(ball, half_space(HalfSpace{.poisson = 0.3, .young = 0.02, .density = 0.1}), 0.01);
  EXPECT_NEAR(soft.strain / (0.2 * soft.max_half_width), 1.0, 0.15);
  const Impact hard = meeting(rigid(ball), half_space(HalfSpace{.poisson = 0.3}), 0.01);
  EXPECT_NEAR(hard.strain / (0.2 * hard.max_half_width), 1.0, 0.15);
  for (const Impact& each : {equal, soft, hard}) expect_flag(each);
}

TEST(Strain, OfRodsIsTheForceOverTheirSection) {
  const Impact wall = impact(rod(50.0), HardWall{}, 0.08);
  EXPECT_NEAR(wall.strain, 0.08, 1e-3);
  EXPECT_FALSE(wall.beyond_small_strain);
  // The second has a tenth of the modulus at its density, and an impedance of 0.316: v Z₁/(Z₁ + Z₂) over its c₂ =
  // 0.316.
  const Impact pair = meeting(rod(Rod{}), rod(Rod{.young = 0.1}), 0.08, 50.0);
  const double slow = std::sqrt(0.1);
  EXPECT_NEAR(pair.strain, 0.08 / (1.0 + slow) / slow, 3e-3);
  EXPECT_TRUE(pair.beyond_small_strain);
}

// A sheet that gives way by most of its thickness, and a thin soft layer on a hard block.
TEST(Strain, OfThinPlatesAndLayersCounts) {
  const BodyMaker ball = sphere(Sphere{.poisson = 0.3});
  const auto sheet = plate(Plate{.thickness = 0.02, .poisson = 0.3, .young = 0.015, .density = 0.1});
  const Impact slow = meeting(ball, sheet, 1e-6), fast = meeting(ball, sheet, 3e-4);
  EXPECT_FALSE(slow.beyond_small_strain);
  EXPECT_GT(fast.max_compression / 0.02, 0.5);
  EXPECT_LT(fast.max_half_width, 0.1);
  EXPECT_TRUE(fast.beyond_small_strain);

  const HalfSpace block{.poisson = 0.3};
  Plate coated{.thickness = 0.01, .poisson = 0.3, .young = 0.015, .density = 0.1};
  coated.below.push_back({infinity, block.poisson, block.young, block.density});
  const Impact bare = meeting(ball, half_space(block), 1e-3), on_paper = meeting(ball, plate(coated), 1e-3);
  EXPECT_FALSE(bare.beyond_small_strain);
  EXPECT_GT(on_paper.max_compression / 0.01, 0.4);
  EXPECT_TRUE(on_paper.beyond_small_strain);
  for (const Impact& each : {slow, fast, bare, on_paper}) expect_flag(each);
}

TEST(Strain, OfStripsCounts) {
  const RefinableContact contact(disk(Disk{.poisson = 0.3}), strip(Strip{.thickness = 2.0, .poisson = 0.3}));
  const Impact slow = best_restitution(contact, 0.01, {.tolerance = 0.05}).finest;
  EXPECT_FALSE(slow.beyond_small_strain);
  EXPECT_GE(slow.strain, 0.1 * 0.9 * slow.max_half_width);
  EXPECT_TRUE(best_restitution(contact, 0.1, {.tolerance = 0.05}).finest.beyond_small_strain);
}

TEST(Strain, IsExpectedWithoutAnImpact) {
  const BodyMaker ball = sphere(Sphere{.poisson = 0.3});
  for (const double speed : {1e-4, 1e-2}) {
    const Contact wall = contact(ball(12.0, {})),
                  block = contact(ball, half_space(HalfSpace{.poisson = 0.3}), 12.0, speed);
    EXPECT_NEAR(expected_strain(wall, speed) / impact(wall, speed).strain, 1.0, 0.1);
    EXPECT_NEAR(expected_strain(block, speed) / impact(block, speed).strain, 1.0, 0.1);
  }
  EXPECT_DOUBLE_EQ(expected_strain(contact(rod(20.0)), 0.2), 0.2);
}

}  // namespace
}  // namespace stoss
