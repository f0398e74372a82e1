// bessel_pairs, BesselTaylor and bessel_j01 against Boost.Math in long double, and against series where J_n itself
// underflows.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>
#include <cmath>
#include <vector>

#include "numeric/bessel.hpp"

namespace stoss {
using namespace numeric;

namespace {

constexpr int highest = 900;

std::vector<BesselPair> pairs_at(double x) {
  std::vector<BesselPair> pairs(highest + 1);
  bessel_pairs(x, pairs);
  return pairs;
}

/// x J_{n+1}(x) / J_n(x) for n > x by Gauss's continued fraction.
long double ratio_by_continued_fraction(int n, long double x) {
  long double ratio = 0.0L;  // J_{k}/J_{k−1}
  for (int k = n + 400; k > n; --k) ratio = 1.0L / (2.0L * k / x - ratio);
  return x * ratio;
}

/// ln J_n(x) for n > x²/4 by the power series.
long double log_by_series(int n, long double x) {
  const long double square = -0.25L * x * x;
  long double term = 1.0L;
  long double sum = 1.0L;
  for (int k = 1; k < 60; ++k) sum += term *= square / (static_cast<long double>(k) * (n + k));
  return n * std::log(0.5L * x) - std::lgamma(n + 1.0L) + std::log(sum);
}

class BesselPairs : public ::testing::TestWithParam<double> {};

TEST_P(BesselPairs, AgreeWithBoost) {
  const double x = GetParam();
  const auto pairs = pairs_at(x);
  long double here = boost::math::cyl_bessel_j(0, static_cast<long double>(x));
  for (int n = 0; n <= highest; ++n) {
    const long double next = boost::math::cyl_bessel_j(n + 1, static_cast<long double>(x));
    // The scale of the error is that of the wave, not of a value near its zero.
    const long double scale = std::hypot(here, next);
    if (scale < 1e-4000L) break;
    const BesselPair& pair = pairs[static_cast<std::size_t>(n)];
    const long double value = std::ldexp(static_cast<long double>(pair.value), pair.exponent);
    const long double x_next = std::ldexp(static_cast<long double>(pair.next), pair.exponent);
    // Every step of the sweep rounds.
    const long double tolerance = (3e-14L + 5e-17L * n) * scale;
    ASSERT_LE(std::abs(value - here), tolerance) << "J_" << n << "(" << x << ")";
    ASSERT_LE(std::abs(x_next / x - next), tolerance) << "J_" << n + 1 << "(" << x << ")";
    here = next;
  }
}

TEST_P(BesselPairs, RatioBeyondTheTurningPointIsTheContinuedFraction) {
  const double x = GetParam();
  const auto pairs = pairs_at(x);
  int compared = 0;
  for (int n = static_cast<int>(x + 5.0 * std::cbrt(x)) + 1; n <= highest; ++n, ++compared) {
    const BesselPair& pair = pairs[static_cast<std::size_t>(n)];
    ASSERT_TRUE(std::isnormal(pair.value)) << "order " << n;
    const long double expected = ratio_by_continued_fraction(n, x);
    ASSERT_NEAR(static_cast<double>(pair.next / pair.value / expected), 1.0, 1e-14) << "order " << n;
  }
  if (compared == 0) GTEST_SKIP() << "no order up to " << highest << " lies beyond the turning point";
}

TEST_P(BesselPairs, MagnitudeOfTheUnderflowingIsThatOfTheSeries) {
  const double x = GetParam();
  if (0.25 * x * x > highest - 100) GTEST_SKIP() << "nothing underflows up to order " << highest;
  const auto pairs = pairs_at(x);
  for (int n = static_cast<int>(0.25 * x * x) + 100; n <= highest; n += 7) {
    const BesselPair& pair = pairs[static_cast<std::size_t>(n)];
    const long double logarithm = std::log(static_cast<long double>(pair.value)) + pair.exponent * std::log(2.0L);
    ASSERT_NEAR(static_cast<double>(logarithm - log_by_series(n, x)), 0.0, 1e-13) << "order " << n;
  }
}

TEST_P(BesselPairs, DoNotDependOnHowManyOrdersAreAsked) {
  const double x = GetParam();
  const auto many = pairs_at(x);
  std::vector<BesselPair> few(3);
  bessel_pairs(x, few);
  for (std::size_t n = 0; n < few.size(); ++n) {
    const double scale = std::ldexp(std::hypot(many[n].value, many[n].next / x), many[n].exponent);
    EXPECT_NEAR(std::ldexp(few[n].value, few[n].exponent), std::ldexp(many[n].value, many[n].exponent), 1e-14 * scale);
  }
}

INSTANTIATE_TEST_SUITE_P(Arguments, BesselPairs,
                         ::testing::Values(1e-3, 0.1, 0.5, 1.0, 2.404825557695773, 3.7, 10.0, 31.4, 99.5, 250.0, 421.7,
                                           640.0, 888.8, 899.5, 1234.5, 2000.0));

TEST(BesselSlope, IsTheDerivative) {
  for (const double x : {0.3, 4.0, 57.0, 700.0}) {
    const auto pairs = pairs_at(x);
    for (const int n : {0, 1, 2, 9, 60, 300}) {
      const BesselPair& pair = pairs[static_cast<std::size_t>(n)];
      const long double expected = x * boost::math::cyl_bessel_j_prime(n, static_cast<long double>(x));
      const long double scale =
          std::ldexp(static_cast<long double>(std::hypot((n + x) * pair.value, pair.next)), pair.exponent);
      const long double found = std::ldexp(static_cast<long double>(slope(n, pair)), pair.exponent);
      EXPECT_LE(std::abs(found - expected), 1e-14L * scale) << "n = " << n << ", x = " << x;
    }
  }
}

class BesselTaylorAt : public ::testing::TestWithParam<double> {};

TEST_P(BesselTaylorAt, ContinuesThePairsOverItsReach) {
  const double center = GetParam();
  const auto left = pairs_at(center);
  int compared = 0;
  for (const double reach : {0.015625, 0.125, 0.5}) {
    for (const double share : {0.0, 0.25, 0.625, 1.0}) {
      const double x = center + share * reach;  // exact: all are short binary fractions
      const auto expected = pairs_at(x);
      for (const int n : {1, 2, 3, 10, 47, 100, 333, 640, 900}) {
        // Modes lie where n ≲ κ′, and the search steps by at most 0.5 in κ′ and in proportion in κ.
        if (n * reach > 0.6 * center) continue;
        const BesselPair& from = left[static_cast<std::size_t>(n)];
        const BesselPair& to = expected[static_cast<std::size_t>(n)];
        const BesselPair found = BesselTaylor(n, center, from, reach)(x - center);
        EXPECT_EQ(found.exponent, from.exponent);
        const int rescale = to.exponent - found.exponent;
        const double tolerance = 6e-14 * std::ldexp(std::hypot(to.value, to.next / x), rescale);
        EXPECT_NEAR(found.value, std::ldexp(to.value, rescale), tolerance) << "n = " << n << ", x = " << x;
        EXPECT_NEAR(found.next / x, std::ldexp(to.next, rescale) / x, tolerance) << "n = " << n << ", x = " << x;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 10);
}

INSTANTIATE_TEST_SUITE_P(Centers, BesselTaylorAt, ::testing::Values(1.0, 1.5, 5.0, 33.25, 150.0, 700.0, 1999.0));

TEST(BesselJ01, IsGoodToRounding) {
  for (const double x :
       {0.0,  1e-9, 0.06,   0.0625, 0.07,  0.18,  0.5, 2.404825557695773, 3.5628, 5.3137, 8.0, 12.5, 24.99,
        25.0, 40.0, 127.93, 127.94, 128.0, 333.0, 1e5}) {
    const auto [zeroth, first] = bessel_j01(x);
    const auto exact = static_cast<long double>(x);
    EXPECT_NEAR(zeroth, static_cast<double>(boost::math::cyl_bessel_j(0, exact)), 1e-15) << x;
    EXPECT_NEAR(first, static_cast<double>(boost::math::cyl_bessel_j(1, exact)), 3e-15) << x;
    EXPECT_EQ(bessel_j0(x), zeroth) << x;
  }
}

}  // namespace
}  // namespace stoss
