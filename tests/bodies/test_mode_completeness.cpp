// No mode missed: the paper's equation sampled by brute force, and the static sum rules, for every order.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "support/eigenvalue_equation.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

double bessel(int n, double x) {
  using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  return boost::math::cyl_bessel_j(n, x, Policy());
}

/// Where two neighbouring samples have one sign but |D| dips between: follows the dip and tells whether D crosses.
bool crosses_twice(double poisson, int n, double low, double high) {
  const auto d = [&](double omega) {
    const double kappa = omega * std::sqrt(1.0 - poisson * poisson);
    const double shear = omega * std::sqrt(2.0 * (1.0 + poisson));
    const int lower = n == 0 ? 0 : n - 1;
    return test::eigenvalue_equation<double>(poisson, n, kappa, shear, bessel(lower, kappa), bessel(lower + 1, kappa),
                                             bessel(lower, shear), bessel(lower + 1, shear));
  };
  const double sign = d(low) > 0.0 ? 1.0 : -1.0;
  for (int i = 0; i < 45; ++i) {
    const double left = low + 0.382 * (high - low), right = low + 0.618 * (high - low);
    const double at_left = sign * d(left), at_right = sign * d(right);
    if (at_left < 0.0 || at_right < 0.0) return true;
    (at_left < at_right ? high : low) = at_left < at_right ? right : left;
  }
  return false;
}

/// Number of roots of the paper's equations in (0, cutoff) for n = 0 … orders−1.
std::vector<int> count_by_brute_force(double poisson, double cutoff, int orders) {
  constexpr double step = 0.01;
  const double per_omega = std::sqrt(1.0 - poisson * poisson);
  const double shear_per_omega = std::sqrt(2.0 * (1.0 + poisson));
  const auto count = static_cast<std::size_t>(orders);
  std::vector<int> roots(count, 0);
  std::vector<double> last(count, 0.0), before_last(count, 0.0);
  std::vector<double> j(count + 1), j_shear(count + 1);
  for (int i = 100; i * step <= cutoff + 0.5 * step; ++i) {
    const double omega = i * step;
    const double kappa = omega * per_omega, shear = omega * shear_per_omega;
    // The slowest edge wave of any ν ≥ −0.95 runs at 0.47 c, so ω < 0.4 n holds no root.
    const int highest = std::min(orders - 1, static_cast<int>(2.5 * omega));
    for (int n = 0; n <= highest + 1 && n <= orders; ++n) {
      j[static_cast<std::size_t>(n)] = bessel(n, kappa);
      j_shear[static_cast<std::size_t>(n)] = bessel(n, shear);
    }
    for (int n = 0; n <= highest; ++n) {
      const auto k = static_cast<std::size_t>(n);
      const std::size_t lower = n == 0 ? 0 : k - 1;
      const double here = test::eigenvalue_equation<double>(poisson, n, kappa, shear, j[lower], j[lower + 1],
                                                            j_shear[lower], j_shear[lower + 1]);
      EXPECT_TRUE(std::isfinite(here) && here != 0.0) << "n = " << n << ", omega = " << omega;
      if (here * last[k] < 0.0) {
        ++roots[k];
      } else if (last[k] * before_last[k] > 0.0 && std::abs(last[k]) < std::abs(before_last[k]) &&
                 std::abs(last[k]) < std::abs(here) && crosses_twice(poisson, n, omega - 2.0 * step, omega)) {
        roots[k] += 2;
      }
      before_last[k] = last[k];
      last[k] = here;
    }
  }
  return roots;
}

class Completeness : public ::testing::TestWithParam<double> {};

TEST_P(Completeness, OfEveryOrderByBruteForce) {
  const double poisson = GetParam();
  constexpr double cutoff = 40.0;
  std::map<int, int> found;
  int highest = 0;
  for (const Mode& mode : bodies::disk::modes(poisson, cutoff)) {
    EXPECT_EQ(mode.index, found[mode.order]++);
    highest = std::max(highest, mode.order);
  }
  const auto expected = count_by_brute_force(poisson, cutoff, highest + 8);
  for (int n = 0; n < highest + 8; ++n) EXPECT_EQ(found[n], expected[static_cast<std::size_t>(n)]) << "order " << n;
}

/// F_n less the given modes, of which `doubled` counts twice.
Flexibility remainder(double poisson, int order, const std::vector<Mode>& modes, const Mode* doubled = nullptr) {
  Flexibility rest = static_flexibility(poisson, order);
  for (const Mode& mode : modes) {
    const double compliance = (&mode == doubled ? 2.0 : 1.0) / (mode.omega * mode.omega);
    rest.radial -= mode.radial * mode.radial * compliance;
    rest.mixed -= mode.radial * mode.tangential * compliance;
    rest.tangential -= mode.tangential * mode.tangential * compliance;
  }
  return rest;
}

double smallest_eigenvalue(const Flexibility& f) {
  return 0.5 * (f.radial + f.tangential) - std::hypot(0.5 * (f.radial - f.tangential), f.mixed);
}

/// What the modes above the cutoff are expected to hold, and by how much one order may differ: the modes come one by
/// one, each with about 2/ω², and their density shifts by (n/κ)².
struct Tail {
  double radial, tangential, tolerance;
};

Tail expected_tail(double poisson, int order, double cutoff) {
  const double scale = 2.0 / (std::numbers::pi * cutoff);
  const double wave = std::sqrt(1.0 - poisson * poisson), shear_wave = std::sqrt(2.0 * (1.0 + poisson));
  const double curvature = order / (cutoff * std::min(wave, shear_wave));
  return {scale * wave * (order == 0 ? 0.5 : 1.0), scale * shear_wave * (order == 0 ? 0.0 : 1.0),
          2.5 / (cutoff * cutoff) + curvature * curvature * scale * shear_wave};
}

bool sum_rule_holds(const Flexibility& rest, const Tail& tail) {
  return smallest_eigenvalue(rest) > -1e-12 && std::abs(rest.radial - tail.radial) < tail.tolerance &&
         std::abs(rest.tangential - tail.tangential) < tail.tolerance;
}

std::map<int, std::vector<Mode>> by_order(double poisson, double cutoff) {
  std::map<int, std::vector<Mode>> groups;
  for (const Mode& mode : bodies::disk::modes(poisson, cutoff)) groups[mode.order].push_back(mode);
  return groups;
}

TEST_P(Completeness, StaticSumRuleOfEveryOrderLeavesAPositiveRemainder) {
  const double poisson = GetParam();
  for (const double cutoff : {50.0, 100.0}) {
    for (const auto& [order, modes] : by_order(poisson, cutoff)) {
      const Flexibility rest = remainder(poisson, order, modes);
      EXPECT_GE(smallest_eigenvalue(rest), -1e-13) << "order " << order;
      if (order == 0) {
        EXPECT_EQ(rest.mixed, 0.0);
        EXPECT_EQ(rest.tangential, 0.0);
      }
      // One mode too many is seen in every order: what is left cannot bear it.
      const Mode& lowest = modes.front();
      EXPECT_LT(smallest_eigenvalue(remainder(poisson, order, modes, &lowest)), 0.0) << "order " << order;
    }
  }
}

TEST_P(Completeness, RemainderFallsAsPredicted) {
  const double poisson = GetParam();
  for (const double cutoff : {50.0, 100.0, 200.0, 400.0}) {
    const auto groups = by_order(poisson, cutoff);
    for (int order = 0; order <= 4; ++order) {
      const Flexibility rest = remainder(poisson, order, groups.at(order));
      const Tail tail = expected_tail(poisson, order, cutoff);
      EXPECT_TRUE(sum_rule_holds(rest, tail))
          << "order " << order << ", cutoff " << cutoff << ": radial " << rest.radial << " for " << tail.radial
          << ", tangential " << rest.tangential << " for " << tail.tangential << ", tolerance " << tail.tolerance;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Poisson, Completeness, ::testing::Values(-0.9, -0.5, 0.0, 0.2, 0.33, 0.5, 0.9, 0.99));

TEST(StaticFlexibility, HasItsClosedFormForOrders0And1And5) {
  const double nu = 0.33;
  const Flexibility zero = static_flexibility(nu, 0), one = static_flexibility(nu, 1), five = static_flexibility(nu, 5);
  EXPECT_DOUBLE_EQ(zero.radial, 0.335);
  EXPECT_EQ(zero.mixed, 0.0);
  EXPECT_EQ(zero.tangential, 0.0);
  EXPECT_DOUBLE_EQ(one.radial, 0.335);
  EXPECT_DOUBLE_EQ(one.mixed, 0.335);
  EXPECT_DOUBLE_EQ(one.tangential, 1.665);
  EXPECT_DOUBLE_EQ(five.radial, 9.33 / 24.0);
  EXPECT_DOUBLE_EQ(five.mixed, (5.0 * 0.67 - 2.0) / 24.0);
  EXPECT_DOUBLE_EQ(five.tangential, five.radial);
}

}  // namespace
}  // namespace stoss
