// gauss_legendre against integrals of powers, and what it does when it is interrupted.
#include "numeric/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "stoss/poll.hpp"

namespace stoss {
using namespace numeric;

namespace {

double integral_of_power(const GaussRule& rule, int power) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rule.node.size(); ++i) sum += rule.weight[i] * std::pow(rule.node[i], power);
  return sum;
}

}  // namespace

TEST(GaussLegendre, IntegratesPowersOfTwiceItsNodes) {
  for (const int nodes : {1, 2, 7, 16, 501}) {
    const int power = 2 * nodes - 2;  // the highest even one
    EXPECT_NEAR(integral_of_power(gauss_legendre(nodes), power), 2.0 / (power + 1.0), 1e-14);
  }
}

/// Among the zeros, not before and after: ten thousand of them take 0.1 s.
TEST(GaussLegendre, PollsAsItGoes) {
  int polls = 0;
  (void)gauss_legendre(4001, [&] { ++polls; });
  EXPECT_GT(polls, 200);
}

TEST(GaussLegendre, IsMadeAfterAnInterruption) {
  constexpr int nodes = 777;
  const Poll interrupt = [] { throw std::runtime_error("interrupted"); };
  EXPECT_THROW((void)gauss_legendre(nodes, interrupt), std::runtime_error);
  EXPECT_NEAR(integral_of_power(gauss_legendre(nodes), 2), 2.0 / 3.0, 1e-14);
}

}  // namespace stoss
