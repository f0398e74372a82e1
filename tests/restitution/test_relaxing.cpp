// Bodies of a material that relaxes, to a tolerance.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/relaxation.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/csv.hpp"

namespace stoss {
namespace {

BodyMaker ball(const Relaxation& relaxation) { return relaxing(sphere(Sphere{0.3}), relaxation); }

}  // namespace

TEST(RelaxingBodies, AgreeWithFiniteElements) {
  for (const test::CsvRow& row : test::read_csv("relaxing_restitution.csv")) {
    const double poisson = row.number("poisson");
    const bool round = row.text("body") == "sphere";
    const BodyMaker body =
        relaxing(round ? sphere(Sphere{poisson}) : disk(Disk{poisson}), parse_relaxation("terms", row.text("terms")));
    const double mass = round ? 4.0 / 3.0 * std::numbers::pi : std::numbers::pi;
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      const Restitution result = restitution(body, row.number("speed"), {.tolerance = tolerance});
      EXPECT_TRUE(result.converged);
      EXPECT_NEAR(result.lost_fraction.value, row.number("lost_fraction"),
                  result.lost_fraction.error + row.number("uncertainty"))
          << row.text("terms") << " " << tolerance;
      EXPECT_NEAR(mass * result.max_force.value, row.number("max_force"), mass * result.max_force.error + 1e-4)
          << row.text("terms") << " " << tolerance;
    }
  }
}

TEST(RelaxingBodies, OfNoTermsAreElasticToTheLastBit) {
  const Restitution elastic = restitution(sphere(Sphere{0.3}), 0.05), same = restitution(ball({}), 0.05);
  EXPECT_EQ(same.restitution.value, elastic.restitution.value);
  EXPECT_EQ(same.finest.final_state.momentum, elastic.finest.final_state.momentum);
  EXPECT_EQ(same.steps, elastic.steps);
}

// What relaxes far more slowly than an impact is elastic with E(0), what relaxes far faster is so with E∞.
TEST(RelaxingBodies, AreElasticFarFromTheirTimes) {
  const double instantaneous = restitution(sphere(Sphere{0.3}), 0.05).lost_fraction.value;
  const Restitution slow = restitution(ball({{{0.5, 1e6}}}), 0.05);
  EXPECT_NEAR(slow.lost_fraction.value, instantaneous, 2.0 * slow.lost_fraction.error + 1e-5);
  // At √(E∞/E(0)) of the speed in c a ball of E∞ is as fast.
  const double relaxed = restitution(sphere(Sphere{0.3}), 0.05).lost_fraction.value;
  const Restitution fast = restitution(ball({{{0.5, 1e-5}}}), 0.05 * std::sqrt(0.5));
  EXPECT_NEAR(fast.lost_fraction.value, relaxed, 2.0 * fast.lost_fraction.error + 1e-4);
}

// Both bodies of one material: what one of them is to a wall at half the speed.
TEST(RelaxingBodies, ThatAreEqualAreEachAtAWall) {
  const Relaxation both{{{0.4, 0.5}, {0.2, 5.0}}};
  const Restitution pair = restitution(RefinableContact(ball(both), ball(both)), 0.1),
                    alone = restitution(ball(both), 0.05);
  EXPECT_NEAR(pair.lost_fraction.value, alone.lost_fraction.value,
              pair.lost_fraction.error + alone.lost_fraction.error);
  EXPECT_NEAR(pair.lost_to_first, pair.lost_to_second, 1e-6);
}

// The material of one body takes nothing from the other.
TEST(RelaxingBodies, DissipateInTheirOwnMaterial) {
  const Relaxation its{{{0.5, 2.0}}};
  const BodyMaker elastic = sphere(Sphere{0.3});
  const Restitution first = restitution(RefinableContact(ball(its), elastic), 0.05);
  const Restitution second = restitution(RefinableContact(elastic, ball(its)), 0.05);
  EXPECT_NEAR(first.lost_fraction.value, second.lost_fraction.value,
              first.lost_fraction.error + second.lost_fraction.error);
  EXPECT_NEAR(first.lost_to_first, second.lost_to_second, 1e-3);
  EXPECT_GT(first.dissipated, 0.05);
  EXPECT_LT(first.lost_to_second, 0.01);
  const Restitution block = restitution(RefinableContact(ball(its), half_space(HalfSpace{0.3})), 0.05);
  EXPECT_GT(block.lost_to_first, 0.05);
  const Restitution soft_block =
      restitution(RefinableContact(elastic, relaxing(half_space(HalfSpace{0.3}), its)), 0.05);
  EXPECT_GT(soft_block.lost_to_second, block.lost_to_second);
}

}  // namespace stoss
