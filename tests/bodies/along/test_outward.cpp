// Balls against forces alike all around the axis: what moves rings along it and out from it.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bodies/sphere/degree_sums.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"

namespace stoss {
namespace outward_bodies {
namespace {

using std::numbers::pi;

/// A displacement towards what the body meets, and out from the axis.
struct Move {
  double x, out;
};

Move of_degree(int n, double radial, double tangential, double theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  const double p = boost::math::legendre_p(n, c), slope = n > 0 ? -s * boost::math::legendre_p_prime(n, c) : 0.0;
  return {radial * p * c - tangential * slope * s, radial * p * s + tangential * slope * c};
}

TEST(OutwardSphere, IsMovedByItsModes) {
  constexpr double poisson = 0.3, cutoff = 9.0;
  const Body body = sphere(poisson, cutoff).outward({});
  const ContactPoints points{1.0, 0.21, 5};
  const Surface surface = body.surface(points);
  const auto modes = bodies::sphere::modes(poisson, cutoff);
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      ASSERT_EQ(modes[k].omega, group.omega[l]);
      for (std::size_t i = 0; i < 10; ++i) {
        const double moved = group.upper[l] * surface.shape[10 * group.upper_row + i] +
                             group.lower[l] * surface.shape[10 * group.lower_row + i];
        const Move move = of_degree(group.order, modes[k].radial, modes[k].tangential, points.angle(i % 5));
        EXPECT_NEAR(moved, i < 5 ? move.x : move.out, 1e-12) << group.order << ' ' << l << ' ' << i;
      }
    }
  }
  EXPECT_EQ(k, modes.size());
}

/// The static response of all degrees up to Nyquist, added up one by one.
std::vector<double> added_up(double poisson, const ContactPoints& points) {
  const std::size_t values = 2 * points.count;
  std::vector<double> sum(values * values);
  const auto nyquist = static_cast<int>(std::lround(pi / points.spacing));
  for (int n = 0; n <= nyquist; ++n) {
    const auto r = bodies::sphere::static_flexibility(poisson, n);
    const double weight = (n == nyquist ? 0.5 : 1.0) / (4.0 * pi / 3.0);
    std::vector<double> u, v;
    for (const bool out : {false, true}) {
      for (std::size_t i = 0; i < points.count; ++i) {
        const Move radial = of_degree(n, 1.0, 0.0, points.angle(i)),
                   tangential = of_degree(n, 0.0, 1.0, points.angle(i));
        u.push_back(out ? radial.out : radial.x);
        v.push_back(out ? tangential.out : tangential.x);
      }
    }
    for (std::size_t i = 0; i < values; ++i) {
      for (std::size_t j = 0; j < values; ++j) {
        sum[i * values + j] +=
            weight * (r.radial * u[i] * u[j] + r.mixed * (u[i] * v[j] + v[i] * u[j]) + r.tangential * v[i] * v[j]);
      }
    }
  }
  return sum;
}

// Wide rings have their degrees one by one, those of a small contact by quadrature.
TEST(OutwardSphere, AnswersStaticForcesWithAllDegrees) {
  for (const double spacing : {0.1, 1.5e-3}) {
    const ContactPoints points{1.0, spacing, 4};
    const std::vector<double> all = added_up(0.2, points);
    const std::vector<double> sum = bodies::sphere::sum_over_degrees({{0.2, true, {}}, false, {}, true}, points, {});
    ASSERT_EQ(sum.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_NEAR(sum[i], all[i], 1e-10 * all.front()) << spacing << ' ' << i;
  }
}

TEST(OutwardBodies, HavePositiveDefiniteResponses) {
  for (const double radius : {1.0, 0.3}) {
    for (const Body& body :
         {sphere(0.3, 6.0).outward({}), half_space(HalfSpace{.poisson = 0.3}, 6.0, 20.0).outward({})}) {
      const ContactPoints points{radius, 0.02, 12};
      const std::vector<double> compliance = body.residual_compliance(points, {});
      ASSERT_EQ(compliance.size(), 24U * 24U);
      const Eigen::MatrixXd matrix = Eigen::MatrixXd::Map(compliance.data(), 24, 24);
      EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-13 * matrix(0, 0));
      EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues()(0), 0.0) << body.name << radius;
    }
  }
}

// Boussinesq: a force on a ring draws what lies outside in by (1 + ν)(1 − 2ν)/2πr, as all of it at the axis would, and
// does not move what lies inside.
TEST(OutwardHalfSpace, IsDrawnInAsByAForceAtTheAxis) {
  constexpr double poisson = 0.2;
  const Body body = half_space(HalfSpace{.poisson = poisson}, 4.0, 12.0).outward({});
  const ContactPoints points{1.0, 0.02, 24};
  const Surface surface = body.surface(points);
  const std::size_t values = 2 * points.count, loaded = 7;
  std::vector<double> response = body.residual_compliance(points, {});
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      std::vector<double> moved(values);
      for (std::size_t i = 0; i < values; ++i) {
        moved[i] = group.upper[l] * surface.shape[values * group.upper_row + i] +
                   group.lower[l] * surface.shape[values * group.lower_row + i];
      }
      const double softness = 1.0 / (group.omega[l] * group.omega[l]);
      for (std::size_t i = 0; i < values; ++i) response[i * values + loaded] += softness * moved[i] * moved[loaded];
    }
  }
  const double strength = (1.0 + poisson) * (1.0 - 2.0 * poisson) / (2.0 * pi);
  for (std::size_t i = 0; i < points.count; ++i) {
    if (i + 3 > loaded && i < loaded + 3) continue;  // where the sum to the Nyquist wave number rings
    const double at = std::sin(points.angle(i)), drawn = i > loaded ? strength / at : 0.0;
    EXPECT_NEAR(response[(points.count + i) * values + loaded], drawn, 0.06 * strength / std::sin(points.angle(loaded)))
        << i;
  }
}

}  // namespace
}  // namespace outward_bodies
}  // namespace stoss
