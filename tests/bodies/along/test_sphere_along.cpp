// The sphere against forces along its surface: toroidal modes, rows as means over rings, and its static response.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <vector>

#include "bodies/sphere/along/toroidal.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"

namespace stoss {
namespace {

using bodies::sphere::toroidal_flexibility;
using bodies::sphere::toroidal_modes;
using bodies::sphere::toroidal_second_moment;
using bodies::sphere::ToroidalMode;
using std::numbers::pi;
constexpr double mass = 4.0 * pi / 3.0;

double shear_speed(double poisson) { return 1.0 / std::sqrt(2.0 * (1.0 + poisson)); }

double bessel(int n, double x) { return boost::math::sph_bessel(static_cast<unsigned>(n), x); }

Body along(const Body& body) { return body.along({}).front(); }

TEST(ToroidalModes, AreFreeAndHaveTheMassOfTheSphere) {
  constexpr double poisson = 0.3;
  for (const ToroidalMode& mode : toroidal_modes(poisson, 12.0, {})) {
    const int n = mode.order;
    const double kappa = mode.omega / shear_speed(poisson), edge = bessel(n, kappa);
    EXPECT_NEAR((n - 1.0) * edge, kappa * bessel(n + 1, kappa), 1e-12) << n << ' ' << mode.index;
    const auto inside = [&](double r) {
      const double u = mode.amplitude * bessel(n, kappa * r) / edge;
      return r * r * u * u;
    };
    const double norm = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(inside, 0.0, 1.0);
    EXPECT_NEAR(n * (n + 1.0) * norm, (2.0 * n + 1.0) / 3.0, 1e-11) << n << ' ' << mode.index;
  }
  const auto modes = toroidal_modes(0.0, 5.0, {});
  EXPECT_NEAR(modes[0].omega / shear_speed(0.0), 5.76345919689455, 1e-14);
  EXPECT_NEAR(modes[1].omega / shear_speed(0.0), 2.50113262040940, 1e-14);
}

TEST(ToroidalModes, AddUpToTheStaticSums) {
  constexpr double cutoff = 150.0;
  for (const double poisson : {-0.5, 0.0, 0.3, 0.4999}) {
    std::map<int, double> compliance, moment;
    for (const ToroidalMode& mode : toroidal_modes(poisson, cutoff, {})) {
      const double share = std::pow(mode.amplitude / mode.omega, 2.0);
      compliance[mode.order] += share;
      moment[mode.order] += share / (mode.omega * mode.omega);
    }
    for (const int n : {1, 2, 3, 7, 12}) {
      const double above = (2.0 * n + 1.0) / (3.0 * n * (n + 1.0)) * 2.0 / (pi * shear_speed(poisson) * cutoff);
      EXPECT_NEAR((toroidal_flexibility(poisson, n) - compliance[n]) / above, 1.0, 0.15) << poisson << ' ' << n;
      EXPECT_NEAR(moment[n] / toroidal_second_moment(poisson, n), 1.0, 1e-3) << poisson << ' ' << n;
    }
  }
}

TEST(ToroidalModes, AppearOneByOneAsTheCutoffRises) {
  const auto all = toroidal_modes(0.3, 20.0, {});
  for (const double cutoff : {0.5, 1.4, 1.551, 1.5512, 3.57, 3.58, 8.0, 13.7}) {
    const auto below = [cutoff](const ToroidalMode& mode) { return mode.omega <= cutoff; };
    EXPECT_EQ(static_cast<long>(toroidal_modes(0.3, cutoff, {}).size()), std::count_if(all.begin(), all.end(), below))
        << cutoff;
  }
}

/// dP_n/dx
double slope(int n, double x) { return boost::math::legendre_p_prime(n, x); }

/// √(2/L) P_n¹(cos θ) and its derivative.
double first(int n, double theta) {
  return std::sqrt(2.0 / (n * (n + 1.0))) * std::sin(theta) * slope(n, std::cos(theta));
}

double first_slope(int n, double theta) {
  const double x = std::cos(theta), sine = std::sin(theta);
  // sin θ dP′/dθ by Legendre's equation
  const double curved = (2.0 * x * slope(n, x) - n * (n + 1.0) * boost::math::legendre_p(n, x)) / (sine * sine);
  return std::sqrt(2.0 / (n * (n + 1.0))) * (x * slope(n, x) - sine * sine * curved);
}

TEST(SphereAlong, MovesRingsByTheMeanOverEachOfThem) {
  constexpr double poisson = 0.3, cutoff = 9.0;
  const Body body = sphere(poisson, cutoff), twin = along(body);
  const auto modes = bodies::sphere::modes(poisson, cutoff);
  const ContactPoints points{1.0, 0.11, 9};
  const Surface surface = twin.surface(points);
  std::size_t spheroidal = 0;
  for (const ModeGroup& group : twin.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const int n = group.order;
      const bool toroidal = group.upper_row == group.lower_row;
      double radial = 0.0, tangential = 0.0;
      for (const auto& mode : modes) {
        if (mode.order != n || mode.omega != group.omega[l] || toroidal) continue;
        radial = mode.radial;
        tangential = mode.tangential;
        ++spheroidal;
      }
      for (std::size_t i = 0; i < points.count; ++i) {
        const double theta = points.angle(i), sine = std::sin(theta), cosine = std::cos(theta);
        const double f = first(n, theta), rise = first_slope(n, theta);
        double expected = 0.5 * (radial * f * sine + tangential * (rise * cosine + f / sine));
        if (toroidal) {
          for (const ToroidalMode& mode : toroidal_modes(poisson, cutoff, {})) {
            if (mode.order == n && mode.index == static_cast<int>(l)) {
              expected = 0.5 * mode.amplitude * (f * cosine / sine + rise);
            }
          }
        }
        const double moved = group.upper[l] * surface.shape[group.upper_row * points.count + i] +
                             group.lower[l] * surface.shape[group.lower_row * points.count + i];
        EXPECT_NEAR(moved, expected, 1e-11) << n << ' ' << l << ' ' << toroidal;
      }
    }
  }
  const auto of_none = static_cast<std::size_t>(
      std::count_if(modes.begin(), modes.end(), [](const auto& mode) { return mode.order == 0; }));
  EXPECT_EQ(spheroidal, modes.size() - of_none);
  EXPECT_EQ(mode_count(twin), spheroidal + toroidal_modes(poisson, cutoff, {}).size());
}

/// W of a sphere without modes as the sum over all degrees of means over rings.
double plain_sum(double poisson, const ContactPoints& points, std::size_t i, std::size_t j) {
  const long highest = std::lround(pi / points.spacing);
  const double x = points.angle(i), y = points.angle(j);
  double xb = 0.0, xh = 1.0, yb = 0.0, yh = 1.0, sum = 0.0;
  double xr = 0.0, yr = 0.0;  // P_n − P_{n−1}
  for (long n = 0; n <= highest; ++n) {
    const auto degree = static_cast<double>(n);
    const auto next = [degree](double rise, double here, double theta) {
      return (degree * rise - (2.0 * degree + 1.0) * 2.0 * std::pow(std::sin(0.5 * theta), 2.0) * here) /
             (degree + 1.0);
    };
    xr = next(xr, xh, x);
    yr = next(yr, yh, y);
    const double xa = xh + xr, ya = yh + yr;
    if (n > 0) {
      const auto f = bodies::sphere::static_flexibility(poisson, static_cast<int>(n));
      const double root = std::sqrt(0.5 * degree * (degree + 1.0)), unit = root / (2.0 * degree + 1.0);
      const double ux = unit * (xb - xa), uy = unit * (yb - ya);
      const double vx = unit * (degree * xa + (degree + 1.0) * xb), vy = unit * (degree * ya + (degree + 1.0) * yb);
      const double w = root * root * xh * yh * toroidal_flexibility(poisson, degree);
      sum += (n == highest ? 0.5 : 1.0) *
             (f.radial * ux * uy + f.mixed * (ux * vy + vx * uy) + f.tangential * vx * vy + w);
    }
    xb = xh;
    yb = yh;
    xh = xa;
    yh = ya;
  }
  return sum / mass;
}

TEST(SphereAlong, HasTheComplianceOfTheSumOverDegreesAtAnyContactRadius) {
  constexpr std::size_t count = 24;
  for (const double poisson : {0.0, 0.45}) {
    const Body twin = along(sphere(Sphere{poisson}, 0.5));
    EXPECT_TRUE(twin.groups.empty());
    for (const double half_width : {0.5, 0.03, 1e-3}) {
      const ContactPoints points{1.0, pi / std::floor(pi * count / half_width), count};
      const auto matrix = twin.residual_compliance(points, {});
      for (const auto& [i, j] :
           {std::pair{0UL, 0UL}, std::pair{23UL, 23UL}, std::pair{3UL, 17UL}, std::pair{1UL, 0UL}}) {
        const double expected = plain_sum(poisson, points, i, j);
        EXPECT_NEAR(matrix[i * count + j] / expected, 1.0, 1e-10) << half_width << ' ' << i << ' ' << j;
      }
    }
  }
}

TEST(SphereAlong, IsAsSoftAsCerrutiSaysNearTheContact) {
  constexpr std::size_t count = 16;
  for (const double poisson : {-0.5, 0.0, 0.3, 0.49}) {
    const Body body = sphere(Sphere{poisson}, 0.5), twin = along(body);
    const ContactPoints points{1.0, pi / std::floor(pi * count / 1e-5), count};
    const auto normal = body.residual_compliance(points, {}), across = twin.residual_compliance(points, {});
    EXPECT_NEAR(twin.softness / body.softness, (2.0 - poisson) / (2.0 * (1.0 - poisson)), 1e-14);
    for (std::size_t k = 0; k < normal.size(); ++k) {
      EXPECT_NEAR(across[k] / normal[k], twin.softness / body.softness, 2e-4) << poisson;
    }
  }
}

TEST(SphereAlong, HasPositiveResidualMatricesOnTheCircleOfASmallerPartner) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  constexpr std::size_t count = 24;
  const Body twin = along(sphere(Sphere{0.3}, 12.0));
  for (const double radius : {1.0, 0.6, 0.2}) {
    const ContactPoints points{radius, pi / 64.0, count};
    const auto compliance = twin.residual_compliance(points, {}), moment = twin.residual_second_moment(points, {});
    const Eigen::Map<const Matrix> w(compliance.data(), count, count), v(moment.data(), count, count);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix>(w).eigenvalues().minCoeff(), 0.0) << radius;
    const auto of_moment = Eigen::SelfAdjointEigenSolver<Matrix>(v).eigenvalues().eval();
    EXPECT_GT(of_moment.minCoeff(), -1e-14 * of_moment.maxCoeff()) << radius;
  }
}

TEST(SphereAlong, KeepsWhatIsNotOfItsDirection) {
  Sphere given{0.3, 2.0, 3.0, 4.0, 0.2};
  const Body body = sphere(given, 9.0), twin = along(body);
  EXPECT_DOUBLE_EQ(body.inertia, 0.4 * body.mass);
  EXPECT_EQ(twin.mass, body.mass);
  EXPECT_EQ(twin.name, body.name);
  EXPECT_EQ(twin.loss_time, body.loss_time);
  EXPECT_EQ(twin.cutoff, body.cutoff);
  EXPECT_NO_THROW(validate(twin));
  EXPECT_TRUE(along(rigid(body)).groups.empty());
  EXPECT_EQ(along(rigid(body)).softness, 0.0);
}

}  // namespace
}  // namespace stoss
