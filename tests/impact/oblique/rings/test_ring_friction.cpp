// Coulomb's law on rings that also slide outward.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "contact/friction.hpp"
#include "impact/oblique/rings/ring_slide.hpp"

namespace stoss {
namespace ring_frictions {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(RingMean, IsTheMeanOverTheDirections) {
  for (const double x : {0.0, 0.1, 0.7, 0.99, 1.3, 2.5, 3.99, 4.01, 7.0, 100.0}) {
    const auto share = [x](double phi) {
      return (x + std::cos(phi)) / std::sqrt(1.0 + 2.0 * x * std::cos(phi) + x * x) / std::numbers::pi;
    };
    const double mean =
        boost::math::quadrature::gauss_kronrod<double, 61>::integrate(share, 0.0, std::numbers::pi, 12, 1e-9);
    EXPECT_NEAR(ring_mean(x).value, mean, std::abs(x - 1.0) < 0.1 ? 2e-3 : 1e-4) << x;
    EXPECT_EQ(ring_mean(-x).value, -ring_mean(x).value);
    EXPECT_EQ(ring_mean(-x).slope, ring_mean(x).slope);
    EXPECT_NEAR((ring_mean(x + 0.01).value - ring_mean(x).value) / 0.01, ring_mean(x + 0.005).slope, 0.05) << x;
  }
}

struct Problem {
  MatrixXd compliance;
  VectorXd give, free, limit;

  explicit Problem(std::mt19937& random) : give(rings), free(rings), limit(rings) {
    std::normal_distribution<double> normal;
    MatrixXd a(rings, rings);
    for (double& value : a.reshaped()) value = normal(random);
    compliance = a * a.transpose() + 0.5 * MatrixXd::Identity(rings, rings);
    for (Index i = 0; i < rings; ++i) {
      give(i) = std::abs(normal(random));
      free(i) = normal(random);
      limit(i) = i + 2 < rings ? std::abs(normal(random)) : 0.0;
    }
  }

  static constexpr Index rings = 8;
};

RingLimits limits(const Problem& its, double share, double reach, double free) {
  return {its.limit, VectorXd::Constant(Problem::rings, share), VectorXd::Constant(Problem::rings, reach),
          VectorXd::Constant(Problem::rings, free)};
}

TEST(RingLaw, GrowsFromWhatFrictionOutwardLeaves) {
  std::mt19937 random(3);
  const RingLimits rings = limits(Problem(random), 0.6, 0.01, 1.0);
  double last = 0.0;
  for (double slip = 1e-3; slip < 100.0; slip *= 1.3) {
    const double now = ring_law(rings, 0, slip / 0.01).value;
    EXPECT_GE(now, last);
    EXPECT_EQ(ring_law(rings, 0, -slip / 0.01).value, -now);
    last = now;
  }
  EXPECT_NEAR(ring_law(rings, 0, 30.0).value, 0.6, 1e-3);
  EXPECT_NEAR(last, 1.0, 1e-4);
}

TEST(RingFriction, ObeysItsLaw) {
  std::mt19937 random(1);
  for (int k = 0; k < 50; ++k) {
    const Problem its(random);
    RingFriction law(its.compliance);
    RingLimits rings = limits(its, k % 2 == 0 ? 1.0 : 0.7, 0.02, k % 2 == 0 ? 0.0 : 0.5);
    if (k % 2 == 0) rings.reach = VectorXd::LinSpaced(Problem::rings, 0.02, 1.0);
    VectorXd force = VectorXd::Zero(Problem::rings);
    for (int step = 0; step < 3; ++step) {
      const VectorXd before = force;
      law.solve(its.give, its.free, rings, force);
      const VectorXd slip = its.free - its.compliance * force - its.give.cwiseProduct(force - before);
      for (Index i = 0; i < Problem::rings; ++i) {
        EXPECT_NEAR(force(i), its.limit(i) * ring_law(rings, i, slip(i) / rings.reach(i)).value, 1e-3) << k;
      }
    }
  }
}

TEST(RingFriction, IsCoulombsLawWhereNothingSlidesOutward) {
  std::mt19937 random(2);
  for (int k = 0; k < 50; ++k) {
    const Problem its(random);
    RingFriction law(its.compliance);
    VectorXd force = VectorXd::Zero(Problem::rings);
    law.solve(its.give, its.free, limits(its, 1.0, 1e-4, 0.0), force);
    Friction coulomb(Problem::rings);
    std::vector<double> exact(Problem::rings);
    const auto values = [](const auto& from) { return std::vector<double>(from.data(), from.data() + from.size()); };
    coulomb.solve(values(its.compliance), values(its.give), values(its.free), its.limit.data(), exact);
    for (Index i = 0; i < Problem::rings; ++i) EXPECT_NEAR(force(i), exact[static_cast<std::size_t>(i)], 3e-3);
  }
}

}  // namespace
}  // namespace ring_frictions
}  // namespace stoss
