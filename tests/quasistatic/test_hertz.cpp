// Hertz' contact in the plane: the closed stresses against the paper's integrals, against the axis, near the end of the
// contact and far away.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/quasistatic/hertz.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

using std::numbers::pi;

/// Paper eq. (46), the stress under the Hertz pressure, by adaptive quadrature over s = a sin θ.
PlaneStress by_quadrature(double force, double x, double y) {
  const double a = 2.0 * std::sqrt(force);
  const auto integral = [&](auto kernel) {
    const auto integrand = [&](double theta) {
      const double cosine = std::cos(theta), t = y - a * std::sin(theta);
      const double square = t * t + x * x;
      return 0.5 * a * cosine * a * cosine * kernel(t) / (square * square);
    };
    const double peak = std::asin(std::clamp(y / a, -1.0, 1.0));
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    return Rule::integrate(integrand, -0.5 * pi, peak, 25, 1e-13) +
           Rule::integrate(integrand, peak, 0.5 * pi, 25, 1e-13);
  };
  return {-2.0 * x * x * x / pi * integral([](double) { return 1.0; }),
          -2.0 * x / pi * integral([](double t) { return t * t; }),
          -2.0 * x * x / pi * integral([](double t) { return t; })};
}

/// McEwen's formulas as they are written, in 100 digits.
PlaneStress as_written(double force, double depth, double along) {
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>>;
  const Real x = depth, y = along, half = 2.0 * std::sqrt(force), square = half * half;
  const Real difference = square + x * x - y * y;
  const Real sum = sqrt(difference * difference + 4 * x * x * y * y);
  const Real m = sqrt((sum + difference) / 2), n = (along < 0.0 ? -1 : 1) * sqrt((sum - difference) / 2);
  const Real share = (x * x + n * n) / sum;
  return {static_cast<double>(-m / 2 * (1 - share)), static_cast<double>(-(m * (1 + share) - 2 * x) / 2),
          static_cast<double>(-n / 2 * (m * m - x * x) / sum)};
}

void expect_relative(const PlaneStress& found, const PlaneStress& expected, double tolerance, const char* where) {
  EXPECT_NEAR(found.xx, expected.xx, tolerance * std::abs(expected.xx)) << where;
  EXPECT_NEAR(found.yy, expected.yy, tolerance * std::abs(expected.yy)) << where;
  EXPECT_NEAR(found.xy, expected.xy, tolerance * std::abs(expected.xy)) << where;
}

TEST(QuasistaticHertz, HalfWidth) {
  EXPECT_DOUBLE_EQ(hertz_half_width(0.01), 0.2);
  for (const double force : {0.0, 1e-300, 1e-7, 0.03, 0.25}) {
    EXPECT_NEAR(0.25 * std::pow(hertz_half_width(force), 2), force, 4e-16 * force);
  }
}

TEST(QuasistaticHertz, PressureCarriesTheLoad) {
  boost::math::quadrature::tanh_sinh<double> integrate;
  for (const double force : {1e-12, 1e-4, 0.1}) {
    const double a = hertz_half_width(force);
    const double load = integrate.integrate([&](double y) { return hertz_pressure(force, y); }, -a, a);
    EXPECT_NEAR(load, pi * force, 1e-13 * pi * force);
    EXPECT_DOUBLE_EQ(hertz_pressure(force, 0.0), 2.0 * (pi * force) / (pi * a));  // eq. (45) with P = πF
    EXPECT_EQ(hertz_pressure(force, a), 0.0);
    EXPECT_EQ(hertz_pressure(force, -1.5 * a), 0.0);
  }
}

TEST(QuasistaticHertz, StressIsThePapersIntegral) {
  for (const double force : {1e-8, 1e-3, 0.1}) {
    const double a = hertz_half_width(force);
    for (const double x : {0.02, 0.1, 0.5, 1.0, 3.0, 20.0}) {
      for (const double y : {-2.5, -1.0, -0.3, 0.01, 0.9, 1.0, 1.3, 10.0}) {
        const PlaneStress expected = by_quadrature(force, a * x, a * y);
        const PlaneStress found = hertz_stress(force, a * x, a * y);
        const double tolerance = 1e-11 * std::max({-expected.xx, -expected.yy, std::abs(expected.xy)});
        EXPECT_NEAR(found.xx, expected.xx, tolerance) << x << " " << y;
        EXPECT_NEAR(found.yy, expected.yy, tolerance) << x << " " << y;
        EXPECT_NEAR(found.xy, expected.xy, tolerance) << x << " " << y;
      }
    }
  }
}

TEST(QuasistaticHertz, NothingIsLostNearTheEndOfTheContactNorFarAway) {
  // Against 100 digits.
  for (const double force : {1e-10, 1e-2}) {
    const double a = hertz_half_width(force);
    for (const double distance : {1e-14, 1e-10, 1e-5, 1e-2}) {
      for (const double angle : {0.1, 0.7, 1.5, 2.0, 3.0}) {
        const double x = a * distance * std::sin(angle), y = a + a * distance * std::cos(angle);
        expect_relative(hertz_stress(force, x, y), as_written(force, x, y), 1e-14, "end");
      }
    }
    for (double away = 1.0; away < 1e12; away *= 10.0) {
      for (const double angle : {1e-3, 0.4, 1.2, 1.57}) {
        const double x = a * away * std::cos(angle), y = a * away * std::sin(angle);
        expect_relative(hertz_stress(force, x, y), as_written(force, x, y), 1e-14, "away");
        expect_relative(hertz_stress(force, x, -y), as_written(force, x, -y), 1e-14, "away");
      }
    }
  }
}

TEST(QuasistaticHertz, AxisIsThePapersFormula) {
  for (const double force : {1e-6, 0.04}) {
    const double a = hertz_half_width(force);
    for (const double depth : {0.0, 0.1, 1.0, 5.0}) {
      const double x = depth * a, root = std::sqrt(a * a + x * x), load = pi * force;
      const PlaneStress stress = hertz_stress(force, x, 0.0);
      EXPECT_NEAR(stress.xx, -2.0 * load / pi / root, 1e-14 * a);
      EXPECT_NEAR(stress.yy, -2.0 * load / (pi * a * a) * ((a * a + 2.0 * x * x) / root - 2.0 * x), 1e-14 * a);
      EXPECT_EQ(stress.xy, 0.0);
    }
    // Maximum shear under the surface, Johnson section 4.2: 0.30 p₀ at 0.78 a.
    double greatest = 0.0, place = 0.0;
    for (double x = 0.0; x < 2.0; x += 1e-3) {
      const PlaneStress stress = hertz_stress(force, a * x, 0.0);
      const double shear = 0.5 * std::abs(stress.xx - stress.yy);
      if (shear > greatest) greatest = shear, place = x;
    }
    EXPECT_NEAR(greatest / (0.5 * a), 0.30, 5e-4);
    EXPECT_NEAR(place, 0.786, 2e-3);
  }
}

TEST(QuasistaticHertz, SurfaceHasThePressureAndNothingElse) {
  constexpr double force = 2e-3;
  const double a = hertz_half_width(force);
  for (const double t : {-3.0, -1.0001, -0.999, -0.4, 0.0, 0.7, 1.0 - 1e-12, 1.5, 100.0}) {
    const PlaneStress stress = hertz_stress(force, 0.0, t * a);
    EXPECT_NEAR(stress.xx, -hertz_pressure(force, t * a), 1e-15 * a);
    EXPECT_NEAR(stress.yy, stress.xx, 1e-15 * a);  // in plane pressure under a pressure
    EXPECT_EQ(stress.xy, 0.0);
  }
  const PlaneStress end = hertz_stress(force, 0.0, a);
  EXPECT_EQ(end.xx, 0.0);
  EXPECT_EQ(end.yy, 0.0);
  EXPECT_EQ(end.xy, 0.0);
  EXPECT_EQ(hertz_stress(0.0, 0.0, 0.0).xx, 0.0);
}

TEST(QuasistaticHertz, RefusesOtherPlacesAndForces) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {-1e-12, 0.2501, nan}) {
    test::expect_refusal([&] { (void)hertz_half_width(wrong); }, {"force", "0 to 0.25"});
    test::expect_refusal([&] { (void)hertz_pressure(wrong, 0.0); }, {"force"});
    test::expect_refusal([&] { (void)hertz_stress(wrong, 0.1, 0.0); }, {"force"});
  }
  test::expect_refusal([&] { (void)hertz_stress(0.1, -0.1, 0.0); }, {"depth", "-0.1", "0 or more"});
  test::expect_refusal([&] { (void)hertz_stress(0.1, 0.1, nan); }, {"y: got nan"});
  test::expect_refusal([&] { (void)hertz_pressure(0.1, nan); }, {"y: got nan"});
}

}  // namespace
}  // namespace stoss
