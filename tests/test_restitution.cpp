// The coefficient of restitution with its error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/restitution.hpp"
#include "stoss/version.hpp"
#include "support/csv.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

TEST(Restitution, LiesWithinThreeErrorsOfTheReference) {
  std::map<double, RefinedBody> bodies;
  for (const auto& row : test::read_csv("restitution_hard_wall.csv")) {
    const double poisson = row.number("poisson"), speed = row.number("speed");
    if (!bodies.contains(poisson)) bodies.emplace(poisson, refine(disk(poisson)));
    const Restitution result = restitution(bodies.at(poisson), speed);
    EXPECT_GT(result.error, 0.0);
    EXPECT_GT(result.lost_fraction_error, 0.0);
    EXPECT_LT(result.lost_fraction_error, 1e-3 + 0.01 * result.lost_fraction);
    EXPECT_NEAR(result.lost_fraction, row.number("lost_fraction"),
                3.0 * result.lost_fraction_error + row.number("uncertainty"))
        << poisson << ", " << speed;
    EXPECT_NEAR(result.value, row.number("restitution"), 3.0 * result.error + row.number("uncertainty"))
        << poisson << ", " << speed;
  }
}

TEST(Restitution, OfARodIsOneWithinItsError) {
  const Restitution result = restitution(rod(), 0.1);
  EXPECT_GT(result.error, 0.0);
  EXPECT_NEAR(result.value, 1.0, result.error);
}

TEST(Restitution, BelongsToTheFinerOfTwoImpacts) {
  const RefinedBody body = refine(disk(0.5));
  EXPECT_EQ(mode_count(body.coarse), mode_count(disk(0.5, body.coarse.cutoff)));
  EXPECT_GT(body.fine.cutoff, body.coarse.cutoff);
  const Restitution result = restitution(body, 0.1);
  const Impact fine = impact(body.fine, HardWall{}, 0.1), coarse = impact(body.coarse, HardWall{}, 0.1);
  EXPECT_EQ(result.value, fine.restitution);
  EXPECT_EQ(result.lost_fraction, fine.lost_fraction);
  const double difference = std::abs(fine.lost_fraction - coarse.lost_fraction);
  EXPECT_EQ(result.lost_fraction_error, std::max(difference, std::abs(fine.energy_error)));
  // ε = √(1 − loss) carries the error of the loss over 2 ε, where that is small.
  EXPECT_NEAR(result.error * 2.0 * result.value / result.lost_fraction_error, 1.0, 1e-3);
  EXPECT_EQ(result.finest.restitution, fine.restitution);
  EXPECT_EQ(result.finest.cutoff, body.fine.cutoff);
  EXPECT_EQ(result.finest.body, body.fine.name);
  EXPECT_EQ(result.steps, fine.steps + coarse.steps);
  EXPECT_EQ(restitution(disk(0.5), 0.1).value, result.value);
}

TEST(Restitution, RefusesBadInput) {
  test::expect_refusal([] { (void)restitution(disk(0.33), 0.0); }, {"speed", "got 0,", "1e-8 to 1"});
  test::expect_refusal([] { (void)restitution(disk(1.5), 0.1); }, {"poisson", "got 1.5,", "-0.95 to 0.995"});
}

TEST(Version, HasThreeNumbers) {
  int major = -1, minor = -1, patch = -1;
  EXPECT_EQ(std::sscanf(std::string(version()).c_str(), "%d.%d.%d", &major, &minor, &patch), 3);
}

}  // namespace
}  // namespace stoss
