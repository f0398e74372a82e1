// Modes of a sphere: their number, against published values, mpmath at 50 digits, and orthonormality by quadrature.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/errors.hpp"
#include "support/csv.hpp"
#include "support/field_tools.hpp"
#include "support/mode_tables.hpp"

namespace stoss {
using namespace bodies::sphere;

namespace {

TEST(SphereModes, CountsBelowACutoff) {
  EXPECT_EQ(bodies::sphere::modes(0.3, 12.5).size(), 69U);
  EXPECT_EQ(bodies::sphere::modes(0.3, 25.0).size(), 268U);
  EXPECT_EQ(bodies::sphere::modes(0.3, 50.0).size(), 1059U);
  EXPECT_EQ(bodies::sphere::modes(0.3, 100.0).size(), 4208U);
}

TEST(SphereModes, AgreeWithTheReferenceToItsDigits) {
  std::map<double, std::vector<Mode>> modes;
  for (const auto& row : test::read_csv("sphere_modes.csv")) {
    auto& all = modes[row.number("poisson")];
    if (all.empty()) all = bodies::sphere::modes(row.number("poisson"), 60.0);
    const auto found = std::find_if(all.begin(), all.end(), [&](const Mode& mode) {
      return mode.order == row.integer("degree") && mode.index == row.integer("index");
    });
    ASSERT_NE(found, all.end());
    EXPECT_NEAR(found->omega / row.number("omega"), 1.0, 1e-13);
    EXPECT_NEAR(found->radial, row.number("U"), 1e-12);
    EXPECT_NEAR(found->tangential, row.number("V"), 1e-12);
  }
}

TEST(SphereModes, HaveLambsFrequencies) {
  const auto modes = bodies::sphere::modes(0.25, 30.0);
  const auto omega = [&](int order, int index) {
    return std::find_if(modes.begin(), modes.end(),
                        [&](const Mode& mode) { return mode.order == order && mode.index == index; })
        ->omega;
  };
  const double shear = std::sqrt(2.5), pressure = std::sqrt(1.25 * 0.5 / 0.75);  // 1/c
  EXPECT_NEAR(omega(2, 0) * shear, 2.6399, 1e-4);
  EXPECT_NEAR(omega(1, 0) * shear, 3.4245, 1e-4);
  EXPECT_NEAR(omega(3, 0) * shear, 3.9163, 1e-4);
  EXPECT_NEAR(omega(4, 0) * shear, 5.0093, 1e-4);
  EXPECT_NEAR(omega(0, 0) * pressure, 2.5634, 1e-4);
  EXPECT_NEAR(omega(0, 1) * pressure, 6.0587, 1e-4);
}

TEST(SphereModes, AgreeWithMpmathInEveryWindow) {
  const auto root = [](int order) { return std::sqrt(order * (order + 1.0)); };
  const auto modes_of = [](double poisson) { return bodies::sphere::modes(poisson, 400.0); };
  EXPECT_GE(test::compare_with_mpmath("sphere_modes_mpmath.csv", "U", "V", modes_of, root), 500U);
}

class SphereModesOf : public ::testing::TestWithParam<double> {};

TEST_P(SphereModesOf, AreOrthonormal) {
  const double poisson = GetParam();
  const test::RadialRule rule;
  std::map<int, std::vector<Mode>> by_degree;
  for (const Mode& mode : bodies::sphere::modes(poisson, 40.0)) by_degree[mode.order].push_back(mode);
  for (const int order : {0, 1, 2, 3, 9, 20}) {
    std::vector<std::vector<Displacement>> field;
    for (const Mode& mode : by_degree[order]) field.push_back(displacement(poisson, mode, rule.radius));
    const double l = order * (order + 1.0);
    for (std::size_t a = 0; a < field.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < rule.radius.size(); ++i) {
          sum += rule.weight[i] * rule.radius[i] * rule.radius[i] *
                 (field[a][i].radial * field[b][i].radial + l * field[a][i].tangential * field[b][i].tangential);
        }
        EXPECT_NEAR(3.0 * sum / (2.0 * order + 1.0), a == b ? 1.0 : 0.0, 1e-11) << order << ": " << a << ", " << b;
      }
    }
  }
}

/// What modes above a cutoff carry of Σ x²/ω² falls as 1/cutoff.
TEST_P(SphereModesOf, AddUpToTheStaticFlexibilityAndSecondMoment) {
  const double poisson = GetParam();
  const auto modes = bodies::sphere::modes(poisson, 400.0);
  for (const int order : {0, 1, 2, 3, 8}) {
    Flexibility all = static_flexibility(poisson, order), half = all;
    Flexibility moment = static_second_moment(poisson, order);
    for (const Mode& mode : modes) {
      if (mode.order != order) continue;
      const double w = 1.0 / (mode.omega * mode.omega);
      const auto take = [&mode](Flexibility& from, double weight) {
        from.radial -= weight * mode.radial * mode.radial;
        from.mixed -= weight * mode.radial * mode.tangential;
        from.tangential -= weight * mode.tangential * mode.tangential;
      };
      take(all, w);
      if (mode.omega <= 200.0) take(half, w);
      take(moment, w * w);
    }
    // Single modes enter and leave: the limit is met to some share of what is left.
    EXPECT_NEAR(2.0 * all.radial / half.radial, 1.0, 0.25) << order;
    EXPECT_NEAR(all.radial, 0.0, 0.03) << order;
    EXPECT_NEAR(all.mixed, 0.0, 3e-4) << order;
    if (order > 0) {
      EXPECT_NEAR(2.0 * all.tangential / half.tangential, 1.0, 0.25) << order;
    }
    EXPECT_NEAR(moment.radial, 0.0, 1e-7) << order;
    EXPECT_NEAR(moment.mixed, 0.0, 1e-8) << order;
    EXPECT_NEAR(moment.tangential, 0.0, 1e-7) << order;
  }
}

INSTANTIATE_TEST_SUITE_P(Poisson, SphereModesOf, ::testing::Values(-0.95, -0.5, 0.0, 0.3, 0.45));

TEST(SphereModes, RefuseWhatTheyCannot) {
  EXPECT_THROW((void)bodies::sphere::modes(0.5, 25.0), InvalidInput);
  EXPECT_THROW((void)bodies::sphere::modes(-0.96, 25.0), InvalidInput);
  EXPECT_THROW((void)bodies::sphere::modes(0.3, 1.6), InvalidInput);
  EXPECT_THROW((void)bodies::sphere::modes(0.3, 1001.0), InvalidInput);
  EXPECT_THROW((void)static_flexibility(0.3, -1), InvalidInput);
  EXPECT_THROW((void)displacement(0.3, {2, 0, 1.6, 1.0, 1.0}, {1.1}), InvalidInput);
}

}  // namespace
}  // namespace stoss
