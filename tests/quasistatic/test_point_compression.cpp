// The laws of compression of a sphere: the constant of the law of the centre against its digamma formula, and inverse
// and energy against the law itself.
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/quasistatic/compression.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

using std::numbers::pi;

TEST(PointCompression, ConstantIsThatOfTheDigammaFormula) {
  // K₁ = D₀ + D₁ − g + r + α(1 − γ) − 2 Re[c₊ ψ(2 − n₊)], with complex digamma functions in 30 digits.
  constexpr double table[][2] = {{-0.95, 18.759550485732698}, {-0.5, -1.4588209397216958},  {0.0, -1.9310809935613071},
                                 {0.2, -1.6833938572683946},  {0.3, -1.5400510709227213},   {0.45, -1.3604397158639984},
                                 {0.49, -1.3325479854736721}, {0.4999, -1.3278143172510175}};
  for (const auto& [poisson, expected] : table)
    EXPECT_NEAR(center_constant(poisson), expected, 2e-14 * (1.0 + std::abs(expected))) << poisson;
}

TEST(PointCompression, ConstantIsASumOverDegrees) {
  // The rest of the plain sum beyond N is c/N + O(1/N²): two sums give it to the second order.
  for (const double nu : {-0.9, 0.3}) {
    const double g = 0.5 * (1.0 - 2.0 * nu) * (1.0 - 2.0 * nu) / (1.0 - nu);
    const auto excess = [&](int n) {
      return bodies::sphere::static_flexibility(nu, n).radial / (4.0 / 3.0 * (1.0 - nu * nu)) - 1.0;
    };
    double sum = excess(0), half = 0.0;
    constexpr int last = 20000;
    for (int n = 1; n <= last; ++n) {
      sum += excess(n) - g / n;
      if (n == last / 2) half = sum;
    }
    EXPECT_NEAR(2.0 * sum - half, center_constant(nu), 1e-6);
  }
}

TEST(PointCompression, IsTheLawWithItsInverseAndEnergy) {
  boost::math::quadrature::tanh_sinh<double> integrate;
  for (const double nu : {-0.5, 0.0, 0.3, 0.49}) {
    const double modulus = 1.0 / (1.0 - nu * nu), mass = 4.0 * pi / 3.0;
    const double g = 0.5 * (1.0 - 2.0 * nu) * (1.0 - 2.0 * nu) / (1.0 - nu);
    for (const double f : {1e-30, 1e-9, 1e-4, 0.05}) {
      const double load = f * mass;  // ER²
      const double a = std::cbrt(0.75 * load / modulus);
      const double law = a * a + load / pi *
                                     ((1.0 - nu * nu) * (g * (19.0 / 12.0 - std::log(2.0 * a)) + center_constant(nu)) -
                                      0.5 * (1.0 + nu) * (1.0 - 2.0 * nu));
      EXPECT_NEAR(compression(PointLaw::center, nu, f), law, 1e-14 * a * a);
      EXPECT_NEAR(compression(PointLaw::hertz, nu, f), a * a, 1e-14 * a * a);
      EXPECT_NEAR(contact_radius(PointLaw::center, nu, f), a, 1e-14 * a);
      for (const PointLaw which : {PointLaw::hertz, PointLaw::center}) {
        const double delta = compression(which, nu, f);
        EXPECT_NEAR(compression_force(which, nu, delta), f, 1e-13 * f);
        const double energy =
            integrate.integrate([&](double d) { return compression_force(which, nu, d); }, 0.0, delta);
        EXPECT_NEAR(compression_energy(which, nu, f), energy, 1e-11 * energy);
      }
    }
  }
}

TEST(PointCompression, EndsWhereTheLawHasItsMaximumOrTheContactIsAsWideAsTheSphere) {
  for (const double nu : {-0.9, 0.0, 0.3, 0.49}) {
    for (const PointLaw which : {PointLaw::hertz, PointLaw::center}) {
      const double limit = limit_force(which, nu);
      const double greatest = compression(which, nu, limit);
      EXPECT_LE(contact_radius(which, nu, limit), 1.0);
      EXPECT_GT(greatest, compression(which, nu, 0.999 * limit));
      EXPECT_NEAR(compression_force(which, nu, greatest), limit, 1e-6 * limit);
    }
  }
  EXPECT_NEAR(contact_radius(PointLaw::center, 0.3, limit_force(PointLaw::center, 0.3)), 0.8977, 1e-4);
}

TEST(PointCompression, RefusesNonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {-1e-3, 0.3, nan}) {
    test::expect_refusal([&] { (void)compression(PointLaw::center, 0.3, wrong); }, {"force", "limit_force"});
  }
  test::expect_refusal([] { (void)compression_force(PointLaw::center, 0.3, 0.9); }, {"compression: got 0.9"});
  test::expect_refusal([] { (void)compression(PointLaw::hertz, 0.5, 1e-3); }, {"poisson: got 0.5", "0.4999"});
}

}  // namespace
}  // namespace stoss
