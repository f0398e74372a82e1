// The paper's way to the coefficient of restitution must meet the hard wall's within both errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/extrapolation.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

/// Cheap: for the tests that do not ask for the value.
ExtrapolationOptions few_modes() { return {.cutoffs = {8.0, 10.0, 12.0}, .hardnesses = {100.0, 150.0, 300.0, 500.0}}; }

/// Least squares by the normal equations: intercept and its standard error.
Estimate line(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  const double sx = std::accumulate(x.begin(), x.end(), 0.0), sy = std::accumulate(y.begin(), y.end(), 0.0);
  const double sxx = std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
  const double sxy = std::inner_product(x.begin(), x.end(), y.begin(), 0.0);
  const double determinant = n * sxx - sx * sx;
  const double intercept = (sxx * sy - sx * sxy) / determinant, slope = (n * sxy - sx * sy) / determinant;
  double squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += std::pow(y[i] - intercept - slope * x[i], 2);
  return {intercept, std::sqrt(squares / (n - 2.0) * sxx / determinant)};
}

class Points : public testing::TestWithParam<std::pair<double, std::vector<double>>> {};

TEST_P(Points, MeetTheHardWallWithinBothErrors) {
  const auto& [poisson, speeds] = GetParam();
  const RefinableContact body(disk(poisson));
  std::vector<double> relative_errors;
  for (const double speed : speeds) {
    const Restitution hard = restitution(body, speed);
    const ExtrapolatedRestitution soft = extrapolated_restitution(poisson, speed);
    const std::string where = "nu = " + std::to_string(poisson) + ", v = " + std::to_string(speed);
    EXPECT_NEAR(soft.lost_fraction.value, hard.lost_fraction.value, soft.lost_fraction.error + hard.lost_fraction.error)
        << where;
    EXPECT_NEAR(soft.restitution.value, hard.restitution.value, soft.restitution.error + hard.restitution.error)
        << where;
    EXPECT_GT(soft.lost_fraction.error, 0.0) << where;
    EXPECT_GT(soft.restitution.error, 0.0) << where;
    relative_errors.push_back(soft.lost_fraction.error / soft.lost_fraction.value);
    EXPECT_LT(relative_errors.back(), 0.1) << where;
    ASSERT_EQ(soft.hard_wall.size(), 4U);
    const std::vector<double> mode_numbers{300, 400, 600, 940};
    for (std::size_t i = 0; i < 4; ++i) {
      // Each number of modes leaves out some that soften the impact.
      EXPECT_GT(soft.hard_wall[i].value, hard.lost_fraction.value) << where << ", cutoff " << i;
      EXPECT_GT(soft.hard_wall[i].error, 0.0) << where << ", cutoff " << i;
      EXPECT_NEAR(static_cast<double>(soft.impacts[4 * i].modes), mode_numbers[i], 1.0);
    }
  }
  std::sort(relative_errors.begin(), relative_errors.end());
  EXPECT_LT(relative_errors[relative_errors.size() / 2], 0.05);
}

INSTANTIATE_TEST_SUITE_P(Extrapolation, Points,
                         testing::Values(std::pair{0.33, std::vector{0.05, 0.1, 0.2, 0.3}},
                                         std::pair{0.9, std::vector{0.1, 0.3}}));

TEST(Extrapolation, IsWhatItsImpactsSay) {
  const ExtrapolationOptions options = few_modes();
  const ExtrapolatedRestitution result = extrapolated_restitution(0.33, 0.1, options);
  ASSERT_EQ(result.impacts.size(), 12U);
  ASSERT_EQ(result.hard_wall.size(), 3U);
  std::vector<double> roots, limits;
  long steps = 0;
  double squares = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Body body = disk(0.33, options.cutoffs[i]);
    std::vector<double> inverse, lost;
    for (std::size_t j = 0; j < 4; ++j) {
      const SoftImpact& one = result.impacts[4 * i + j];
      const Impact expected = impact(body, ExponentialWall{options.hardnesses[j]}, 0.1);
      EXPECT_EQ(one.cutoff, options.cutoffs[i]);
      EXPECT_EQ(one.hardness, options.hardnesses[j]);
      EXPECT_EQ(one.modes, static_cast<long>(mode_count(body)));
      EXPECT_EQ(one.lost_fraction, expected.lost_fraction);
      EXPECT_EQ(one.steps, expected.steps);
      steps += one.steps;
      inverse.push_back(1.0 / one.hardness);
      lost.push_back(one.lost_fraction);
    }
    const Estimate hard = line(inverse, lost);
    EXPECT_NEAR(result.hard_wall[i].value, hard.value, 1e-12);
    EXPECT_NEAR(result.hard_wall[i].error, 4.303 * hard.error, 1e-11);  // Student, two degrees of freedom
    roots.push_back(1.0 / std::sqrt(static_cast<double>(mode_count(body))));
    limits.push_back(result.hard_wall[i].value);
    if (i > 0) {
      EXPECT_GT(result.impacts[4 * i].modes, result.impacts[4 * i - 1].modes);
    }
  }
  EXPECT_EQ(result.steps, steps);
  const Estimate complete = line(roots, limits);
  EXPECT_NEAR(result.lost_fraction.value, complete.value, 1e-12);
  for (std::size_t i = 0; i < 3; ++i) {  // how much the intercept moves with each of the first lines
    std::vector<double> shifted = limits;
    shifted[i] += result.hard_wall[i].error;
    squares += std::pow(line(roots, shifted).value - complete.value, 2);
  }
  EXPECT_NEAR(result.lost_fraction.error, std::hypot(12.706 * complete.error, std::sqrt(squares)), 1e-10);
  EXPECT_NEAR(std::pow(result.restitution.value, 2), 1.0 - result.lost_fraction.value, 1e-14);
  EXPECT_NEAR(result.restitution.error * 2.0 * result.restitution.value, result.lost_fraction.error,
              std::pow(result.lost_fraction.error, 2));
}

TEST(Extrapolation, OfMoreWallsIsNoSurer) {
  // Four walls and seven over the same range: the deviations from the line are its curvature, not chance.
  ExtrapolationOptions options = few_modes();
  options.hardnesses = {250.0, 1000.0 / 3.0, 500.0, 1000.0};
  const auto four = extrapolated_restitution(0.33, 0.1, options);
  options.hardnesses = {250.0, 2000.0 / 7.0, 1000.0 / 3.0, 400.0, 500.0, 2000.0 / 3.0, 1000.0};
  const auto seven = extrapolated_restitution(0.33, 0.1, options);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GT(seven.hard_wall[i].error, 0.4 * four.hard_wall[i].error);
}

TEST(Extrapolation, GivesTheSameBitsAgain) {
  const auto first = extrapolated_restitution(0.9, 0.2, few_modes());
  const auto second = extrapolated_restitution(0.9, 0.2, few_modes());
  EXPECT_EQ(first.lost_fraction.value, second.lost_fraction.value);
  EXPECT_EQ(first.lost_fraction.error, second.lost_fraction.error);
  EXPECT_EQ(first.restitution.value, second.restitution.value);
  EXPECT_EQ(first.steps, second.steps);
}

TEST(Extrapolation, IsFiniteAtTheEndsOfItsRange) {
  for (const double poisson : {-0.95, 0.995}) {
    for (const double speed : {1e-3, 0.5}) {
      const auto result = extrapolated_restitution(poisson, speed, {.cutoffs = {25.0, 30.0, 35.0}, .hardnesses = {}});
      EXPECT_TRUE(std::isfinite(result.restitution.value)) << poisson << ", " << speed;
      EXPECT_TRUE(std::isfinite(result.restitution.error)) << poisson << ", " << speed;
      EXPECT_GT(result.restitution.error, 0.0) << poisson << ", " << speed;
    }
  }
}

TEST(Extrapolation, EndsWhenThePollThrows) {
  int calls = 0;
  ExtrapolationOptions options = few_modes();
  options.poll = [&calls] {
    if (++calls == 30) throw std::domain_error("enough");
  };
  EXPECT_EQ(test::message_of<std::domain_error>([&] { (void)extrapolated_restitution(0.33, 0.1, options); }), "enough");
  EXPECT_EQ(calls, 30);
}

TEST(Extrapolation, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  int polls = 0;
  const auto refused = [&](double poisson, double speed, ExtrapolationOptions options,
                           const std::vector<std::string>& parts) {
    options.poll = [&polls] { ++polls; };
    test::expect_refusal([&] { (void)extrapolated_restitution(poisson, speed, options); }, parts);
  };
  refused(1.5, 0.1, {}, {"poisson", "got 1.5,", "-0.95 to 0.995"});
  refused(-1.0, 0.1, {}, {"poisson", "got -1,"});
  refused(nan, 0.1, {}, {"poisson", "got nan,"});
  refused(0.33, 0.0009, {}, {"speed", "got 0.0009,", "0.001 to 0.5"});
  refused(0.33, 0.51, {}, {"speed", "got 0.51,"});
  refused(0.33, nan, {}, {"speed", "got nan,"});

  const auto walls = [&](const std::vector<double>& hardnesses, const std::vector<std::string>& parts) {
    refused(0.33, 0.1, {.cutoffs = {8.0, 10.0, 12.0}, .hardnesses = hardnesses}, parts);
  };
  walls({100.0, 200.0}, {"number of hardnesses", "got 2,", "3 to 1000"});
  walls({300.0, 200.0, 100.0}, {"hardnesses", "got 200,", "ascending"});
  walls({100.0, 100.5, 200.0}, {"hardnesses", "got 100.5,", "1 %"});
  walls({100.0, nan, 200.0}, {"hardnesses", "got nan,"});
  walls({100.0, 200.0, infinity}, {"hardnesses", "got inf,"});
  walls({-1.0, 100.0, 200.0}, {"hardnesses", "got -1,"});
  walls({0.5, 100.0, 200.0}, {"hardness", "got 0.5,", "1 to 1e6"});

  EXPECT_EQ(polls, 0) << "modes have been computed";

  const auto bodies = [&](const std::vector<double>& cutoffs, const std::vector<std::string>& parts) {
    refused(0.33, 0.1, {.cutoffs = cutoffs, .hardnesses = {}}, parts);
  };
  bodies({25.0}, {"number of cutoffs", "got 1,", "3 to 1000"});
  bodies({25.0, 20.0, 30.0}, {"cutoffs", "got 20,", "ascending"});
  bodies({25.0, nan, 30.0}, {"cutoffs", "got nan,"});
  bodies({25.0, 30.0, 2000.0}, {"cutoff", "got 2000,", "1000"});
  bodies({0.1, 30.0, 40.0}, {"cutoff", "got 0.1,"});
  bodies({2.0, 2.021, 30.0}, {"modes", "got 2,", "more than the cutoff before"});
}

}  // namespace
}  // namespace stoss
