// The sphere as a body: its rings, and the response of the modes that are not kept against sums degree by degree.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/legendre.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using bodies::sphere::Flexibility;
using std::numbers::pi;
constexpr double mass = 4.0 * pi / 3.0;

/// Rings across a half-width, their Nyquist degree whole.
ContactPoints rings(std::size_t count, double half_width) {
  return {1.0, pi / std::floor(pi * static_cast<double>(count) / half_width), count};
}

/// (1/m) Σ_n … between two rings, as it stands, in long double.
long double plain_sum(double poisson, const ContactPoints& points, std::size_t i, std::size_t j) {
  const long double h = points.spacing;
  const long highest = std::lround(pi / points.spacing);
  struct At {
    long double cosine, sine, fall, value = 1.0L, rise = 0.0L, below = 0.0L;
    explicit At(long double theta)
        : cosine(std::cos(theta)), sine(std::sin(theta)), fall(2.0L * std::pow(std::sin(theta / 2.0L), 2.0L)) {}
    /// sin θ dP_n/dθ = n (cos θ P_n − P_{n−1})
    [[nodiscard]] long double slope(long double n) const { return n * (rise - fall * value); }
    void advance(long double n) {
      below = value;
      rise = (n * rise - (2.0L * n + 1.0L) * fall * value) / (n + 1.0L);
      value += rise;
    }
  };
  At x((static_cast<long double>(i) + 0.5L) * h), y((static_cast<long double>(j) + 0.5L) * h);
  long double sum = 0.0L;
  for (long n = 0; n <= highest; ++n) {
    const Flexibility f = bodies::sphere::static_flexibility(poisson, static_cast<int>(n));
    const auto degree = static_cast<long double>(n);
    const long double ax = x.cosine * x.value, ay = y.cosine * y.value, bx = x.slope(degree), by = y.slope(degree);
    sum += (n == highest ? 0.5L : 1.0L) * (f.radial * ax * ay - f.mixed * (ax * by + bx * ay) + f.tangential * bx * by);
    x.advance(degree);
    y.advance(degree);
  }
  return sum / static_cast<long double>(mass);
}

TEST(SphereBody, HasTheComplianceOfTheSumOverDegreesAtAnyContactRadius) {
  constexpr std::size_t count = 24;
  for (const double poisson : {-0.5, 0.3, 0.49}) {
    for (const double width : {1.5, 0.1, 0.01, 1e-3, 1e-4}) {
      const ContactPoints points = rings(count, width);
      const std::vector<double> w = bodies::sphere::sum_over_degrees({{poisson, true, {}}}, points, {});
      const auto largest = static_cast<long double>(w[0]);
      for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 0}, {7, 3}, {23, 22}, {23, 0}}) {
        const double error = static_cast<double>((w[i * count + j] - plain_sum(poisson, points, i, j)) / largest);
        EXPECT_NEAR(error, 0.0, 1e-12) << poisson << ", " << width << ": " << i << ", " << j;
        EXPECT_EQ(w[i * count + j], w[j * count + i]);
      }
    }
  }
}

TEST(SphereBody, IsTheWholeFlexibilityOnceItsModesAreBack) {
  const Body body = sphere(0.3, 25.0);
  const ContactPoints points = rings(40, 0.9);
  const Surface surface = body.surface(points);
  std::vector<double> w = body.residual_compliance(points, {});
  std::vector<double> v = body.residual_second_moment(points, {});
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const double compliance = 1.0 / (body.mass * group.omega[l] * group.omega[l]);
      const auto moved = [&](std::size_t i) {
        return group.upper[l] * surface.shape[group.upper_row * 40 + i] +
               group.lower[l] * surface.shape[group.lower_row * 40 + i];
      };
      for (std::size_t i = 0; i < 40; ++i) {
        for (std::size_t j = 0; j < 40; ++j) {
          w[i * 40 + j] += compliance * moved(i) * moved(j);
          v[i * 40 + j] += compliance / (group.omega[l] * group.omega[l]) * moved(i) * moved(j);
        }
      }
    }
  }
  const std::vector<double> all = bodies::sphere::sum_over_degrees({{0.3, true, {}}}, points, {});
  for (std::size_t k = 0; k < w.size(); ++k) EXPECT_NEAR(w[k], all[k], 1e-12 * all[0]);
  // In the second moment the degrees up to 8 cutoffs, here all up to Nyquist.
  std::vector<Flexibility> moments;
  for (int n = 0; n <= 200; ++n) moments.push_back(bodies::sphere::static_second_moment(0.3, n));
  const std::vector<double> moment = bodies::sphere::sum_over_degrees({{0.3, false, moments}}, points, {});
  for (std::size_t k = 0; k < v.size(); ++k) EXPECT_NEAR(v[k], moment[k], 1e-12 * moment[0]);
}

TEST(SphereBody, ResolvesTheRingsOfASmallerPartner) {
  constexpr std::size_t count = 48;
  const auto softest = [](const ContactPoints& points) {
    const std::vector<double> w = bodies::sphere::sum_over_degrees({{0.3, true, {}}}, points, {});
    const auto size = static_cast<Eigen::Index>(points.count);
    const Eigen::Map<const Eigen::MatrixXd> matrix(w.data(), size, size);
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(0);
  };
  // In units of the partner the same material is as stiff whatever its size, wide as the contact may be.
  for (const double width : {0.05, 0.6, 1.3}) {
    const double own = softest({1.0, width / count, count});
    for (const double radius : {0.8, 0.5, 0.1}) {
      EXPECT_NEAR(softest({radius, width / count, count}) * radius / own, 1.0, 0.1) << width << ", " << radius;
    }
  }
}

TEST(SphereBody, HasLegendreFunctionsOfAnyDegree) {
  const Eigen::ArrayXd angle = Eigen::ArrayXd::LinSpaced(9, 1e-4, 0.1);
  const bodies::sphere::LegendreOfRealDegree real(angle);
  bodies::sphere::LegendreSequence sequence(angle);
  for (int n = 0; n <= 400; ++n, sequence.advance()) {
    const Eigen::ArrayXd between = n >= 100 ? real(n) : sequence.value();
    for (Eigen::Index i = 0; i < angle.size(); ++i) {
      const double expected = boost::math::legendre_p(n, std::cos(angle(i)));
      EXPECT_NEAR(sequence.value()(i), expected, 1e-11) << n;
      EXPECT_NEAR(between(i), expected, 1e-11) << n;
    }
  }
}

TEST(SphereBody, StandsForItsWholeSurface) {
  const Body body = sphere(0.3, 12.5);
  for (const double radius : {1.0, 0.5}) {
    const ContactPoints points{radius, 0.5 * pi / 64.0, 64};  // to the equator of their circle
    const Surface surface = body.surface(points);
    double area = 0.0;
    for (const double each : surface.measure) area += each;
    EXPECT_NEAR(area, 2.0 * pi * (1.0 - std::sqrt(1.0 - radius * radius)), 1e-13);
    const double theta = std::asin(radius * std::sin(points.angle(20)));
    EXPECT_NEAR(surface.recess[20], 1.0 - std::cos(theta), 1e-15);
    EXPECT_NEAR(surface.shape[7 * 64 + 20], boost::math::legendre_p(7, std::cos(theta)), 1e-14);
  }
  EXPECT_EQ(body.softness, 1.0 - 0.3 * 0.3);
  EXPECT_NEAR(body.mass, mass, 1e-15);
  EXPECT_EQ(mode_count(body), 69U);
}

TEST(SphereBody, MovesARingAsItsModesDo) {
  const Body body = sphere(0.3, 12.5);
  const ContactPoints points = rings(16, 1.2);
  const Surface surface = body.surface(points);
  const auto modes = bodies::sphere::modes(0.3, 12.5);
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const auto& mode = modes[k];
      const double theta = points.angle(9), x = std::cos(theta);
      const double slope = mode.order == 0 ? 0.0 : boost::math::legendre_p_prime(mode.order, x) * -std::sin(theta);
      const double expected =
          mode.radial * boost::math::legendre_p(mode.order, x) * x - mode.tangential * slope * std::sin(theta);
      EXPECT_NEAR(group.upper[l] * surface.shape[group.upper_row * 16 + 9] +
                      group.lower[l] * surface.shape[group.lower_row * 16 + 9],
                  expected, 1e-12);
    }
  }
}

TEST(SphereBody, RefusesWhatItCannotBe) {
  EXPECT_THROW((void)sphere(0.5, 25.0), InvalidInput);
  EXPECT_THROW((void)sphere(0.3, 1.0), InvalidInput);
  EXPECT_NO_THROW((void)sphere(Sphere{0.3}, 1.0));
}

}  // namespace
}  // namespace stoss
