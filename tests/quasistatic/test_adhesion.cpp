// Adhesion of round bodies: the published numbers, and the work between both jumps.
#include "stoss/quasistatic/adhesion.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>

namespace stoss {
using namespace quasistatic;

namespace {

using std::numbers::pi;

TEST(Adhesion, HasThePublishedNumbers) {
  const PointPair pair{2.0, 0.5};
  const double work = 3.0, radius = 0.5, modulus = 2.0;
  const double published = 7.09 * std::cbrt(std::pow(work, 5) * std::pow(radius, 4) / (modulus * modulus));
  EXPECT_NEAR(adhesion_energy(pair, work), published, 1e-3 * published);
  const double speed = std::sqrt(14.18 / 7.0) * std::pow(std::pow(work, 5) * std::pow(radius, 4) / 4.0, 1.0 / 6.0);
  EXPECT_NEAR(sticking_speed(pair, work, 7.0), speed, 1e-3 * speed);
}

TEST(Adhesion, TakesTheWorkBetweenItsJumps) {
  // Johnson, Kendall and Roberts in E* = R = κ = 1: F = 4/3 s⁶ − 2s³ at δ = s⁴ − s, from the touch to the parting.
  boost::math::quadrature::tanh_sinh<double> integrator;
  const auto work = [](double s) {
    return -(4.0 / 3.0 * std::pow(s, 6) - 2.0 * std::pow(s, 3)) * (4.0 * s * s * s - 1.0);
  };
  const double between = integrator.integrate(work, std::cbrt(0.25), 1.0);
  const double unit = std::pow(2.0 * pi, 5.0 / 3.0);  // over (w⁵R⁴/E*²)^{1/3}
  EXPECT_NEAR(between * unit, adhesion_energy({1.0, 1.0}, 1.0), 1e-7);
}

}  // namespace
}  // namespace stoss
