// Tables of the collision rule, of values that are given: limits, symmetries, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "stoss/table/rule_table.hpp"
#include "support/refusal.hpp"
#include "support/rules.hpp"

namespace stoss {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

TEST(RuleTable, HasItsValuesAtItsPlaces) {
  const RuleValues values = test::some_rule();
  const RuleTable rule(values);
  const TableValues& grid = values.sliding;
  constexpr double friction = 0.4;
  std::size_t i = 0;
  for (const double v : grid.speeds) {
    for (const double z : grid.slips) {
      const double q = grid.values[i++].value;
      if (z == 1.0) continue;
      const double s = friction * v * (1.0 + z) / (1.0 - z);
      EXPECT_NEAR(rule(v, s, friction).sliding_after, q * (s + friction * v), 1e-14) << v << ' ' << z;
    }
  }
  for (std::size_t k = 0; k < values.restitution.speeds.size(); ++k) {
    EXPECT_NEAR(rule(values.restitution.speeds[k], 0.1, 0.3).restitution.value, values.restitution.values[k].value,
                1e-15);
  }
}

TEST(RuleTable, DependsOnTheSlidingOverTheFriction) {
  const RuleTable rule(test::some_rule());
  for (const double w : {0.1, 1.0, 4.0, 30.0}) {
    const Rule one = rule(0.03, w * 0.1 * 0.03, 0.1), other = rule(0.03, w * 0.7 * 0.03, 0.7);
    EXPECT_NEAR(one.sliding_after / 0.1, other.sliding_after / 0.7, 1e-15) << w;
    EXPECT_EQ(rule(-0.03, -w, 0.1).sliding_after, -rule(0.03, w, 0.1).sliding_after);
  }
}

TEST(RuleTable, SlidesThroughoutWhereFrictionIsSmall) {
  // q is a straight line in z from z = 0.8 on: s − s′ no longer depends on s.
  const RuleTable rule(test::some_rule());
  const auto change = [&](double w) {
    const double s = w * 0.2 * 0.03;
    return (s - rule(0.03, s, 0.2).sliding_after) / (0.2 * 0.03);
  };
  for (const double w : {12.0, 50.0, 1e3, 1e6}) EXPECT_NEAR(change(w), change(9.0), 1e-14 * w + 1e-13) << w;
}

TEST(RuleTable, KnowsWhatNothingDoes) {
  const RuleTable rule(test::some_rule(), Beyond::clamp);
  EXPECT_EQ(rule(0.03, 0.0, 0.3).sliding_after, 0.0);
  EXPECT_EQ(rule(0.03, 0.2, 0.0).sliding_after, 0.2);
  EXPECT_EQ(rule(0.03, -0.2, 0.0).sliding_after, -0.2);
  EXPECT_EQ(rule(0.0, 0.2, 0.3).sliding_after, 0.2);
  EXPECT_EQ(rule(0.0, 0.0, 0.3).sliding_after, 0.0);
  EXPECT_EQ(rule(0.0, 0.2, 0.3).sliding_error, unbounded);
}

TEST(RuleTable, NeverGainsEnergy) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const RuleTable rule(test::wild_rule(5), Beyond::clamp);
  for (int i = 0; i < 100'000; ++i) {
    const double v = std::pow(10.0, -4.0 * uniform(random)), s = std::pow(10.0, 4.0 - 8.0 * uniform(random)) * v;
    const Rule after = rule(v, s, 2.0 * uniform(random));
    ASSERT_LE(std::abs(after.sliding_after), s);
    ASSERT_GE(after.restitution.value, 0.0);
    ASSERT_LE(after.restitution.value, 1.0);
  }
}

TEST(RuleTable, SaysWhereItSaysNothing) {
  const RuleTable rule(test::some_rule());
  const auto refuse = [&](double v, double s, double friction, const std::vector<std::string>& parts) {
    test::expect_refusal([&] { (void)rule(v, s, friction); }, parts);
    EXPECT_TRUE(std::isnan(rule.unchecked(v, s, friction).sliding_after));
    EXPECT_TRUE(std::isnan(rule.unchecked(v, s, friction).restitution.value));
  };
  refuse(0.009, 0.1, 0.3, {"speed", "0.009", "0.01 to 0.2"});
  refuse(0.0, 0.1, 0.3, {"speed: got 0"});
  for (const double bad : {no_number, unbounded}) {
    refuse(bad, 0.1, 0.3, {"speed"});
    refuse(0.1, bad, 0.3, {"sliding"});
    refuse(0.1, 0.1, bad, {"friction"});
  }
  refuse(0.1, 0.1, -0.1, {"friction: got -0.1"});
  RuleValues values = test::some_rule();
  values.friction = 0.3;
  const RuleTable fixed(values);
  EXPECT_TRUE(std::isfinite(fixed(0.1, 0.1, 0.3).sliding_after));
  test::expect_refusal([&] { (void)fixed(0.1, 0.1, 0.2); }, {"friction: got 0.2, allowed 0.3"});
  const RuleTable mixture(test::some_rule({0.5, 1.0, 2.0}));
  test::expect_refusal([&] { (void)mixture(0.1, 0.1, 0.3, 2.1); }, {"ratio: got 2.1, allowed 0.5 to 2"});
  test::expect_refusal([&] { (void)mixture(0.1, 0.1, 0.3, -1.0); }, {"ratio: got -1"});
}

TEST(RuleTable, RefusesValuesOfNoTable) {
  const auto refuse = [](const std::function<void(RuleValues&)>& spoil, const char* part) {
    RuleValues values = test::some_rule();
    spoil(values);
    test::expect_refusal([&] { (void)RuleTable(values); }, {part});
  };
  refuse([](RuleValues& values) { values.sliding.speeds[1] = 0.01; }, "speeds");
  refuse([](RuleValues& values) { values.sliding.slips.back() = 0.9; }, "slips");
  refuse([](RuleValues& values) { values.sliding.slips[1] = -1.0; }, "slips");
  refuse([](RuleValues& values) { values.sliding.values.pop_back(); }, "sliding");
  refuse([](RuleValues& values) { values.restitution.speeds.back() = 0.3; }, "ends");
  refuse([](RuleValues& values) { values.sliding.alike = true; }, "ends");
  refuse([](RuleValues& values) { values.sliding = values.restitution; }, "slips");
  refuse([](RuleValues& values) { values.friction = 0.0; }, "friction");
}

}  // namespace
}  // namespace stoss
