// The static field of forces on the edge, against the closed solution of a disk that point forces accelerate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/contact/grid.hpp"
#include "support/body_tools.hpp"
#include "support/field_tools.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

using std::numbers::pi;

struct Stress {
  double xx = 0.0, yy = 0.0, xy = 0.0;
};

/// Stress of a disk that forces ½πF in the direction −x at the edge points ±φ accelerate: two fields of Flamant, whose
/// tractions on the edge (a circle through the point of attack) are uniform, plus a uniform tension and the field of
/// the inertia that take these tractions away. The shear tractions of the two points cancel.
Stress accelerated_disk(double force, double phi, double x, double y) {
  const double tension = 0.5 * force * std::cos(phi), g = -force;
  Stress stress{tension + 0.5 * g * x, tension - 0.5 * g * x, 0.5 * g * y};
  for (const double side : {-1.0, 1.0}) {
    const double dx = x - std::cos(phi), dy = y - side * std::sin(phi);
    const double square = dx * dx + dy * dy;
    const double factor = -2.0 / pi * (-0.5 * pi * force * dx) / (square * square);
    stress.xx += factor * dx * dx;
    stress.yy += factor * dy * dy;
    stress.xy += factor * dx * dy;
  }
  return stress;
}

class StaticFieldUnderForces : public ::testing::TestWithParam<double> {
 protected:
  const double poisson = GetParam();
  const Body body = disk(poisson, 12.5);
  const ContactGrid contact = test::grid_of(body, 0.6, 64);  // Nyquist order 335

  [[nodiscard]] Field at_rest(const std::vector<double>& force, const PolarGrid& points) const {
    return DiskField(poisson, body, contact.points, points).at(test::static_coordinates(body, contact, force), force);
  }

  [[nodiscard]] std::vector<double> single(std::size_t node, double force) const {
    std::vector<double> forces(contact.coordinate.size(), 0.0);
    forces[node] = force;
    return forces;
  }

  [[nodiscard]] std::vector<double> several() const {
    std::vector<double> forces;
    for (std::size_t i = 0; i < contact.coordinate.size(); ++i)
      forces.push_back(1.0 + std::cos(3.7 * static_cast<double>(i)));
    return forces;
  }
};

TEST_P(StaticFieldUnderForces, IsTheClosedSolutionOfAnAcceleratedDisk) {
  const PolarGrid points{{0.0, 0.05, 0.3, 0.6, 0.8}, {0.0, 0.2, 1.0, pi / 2, 2.5, pi, -0.7}};
  std::vector<std::vector<double>> cases{single(0, 1.0), single(0, -0.01), single(63, 1.0), several()};
  for (const std::vector<double>& force : cases) {
    const Field field = at_rest(force, points);
    std::size_t k = 0;
    for (const double r : points.radius) {
      for (const double phi : points.angle) {
        const double c = std::cos(phi), s = std::sin(phi);
        Stress sum;
        for (std::size_t i = 0; i < force.size(); ++i) {
          const Stress one = accelerated_disk(force[i], contact.coordinate[i], r * c, r * s);
          sum = {sum.xx + one.xx, sum.yy + one.yy, sum.xy + one.xy};
        }
        const double tolerance =
            1e-13 *
            std::accumulate(force.begin(), force.end(), 0.0, [](double a, double b) { return a + std::abs(b); }) /
            ((1.0 - r) * (1.0 - r));
        EXPECT_NEAR(field.stress_rr[k], sum.xx * c * c + sum.yy * s * s + 2.0 * sum.xy * c * s, tolerance);
        EXPECT_NEAR(field.stress_pp[k], sum.xx * s * s + sum.yy * c * c - 2.0 * sum.xy * c * s, tolerance);
        EXPECT_NEAR(field.stress_rp[k], (sum.yy - sum.xx) * c * s + sum.xy * (c * c - s * s), tolerance);
        ++k;
      }
    }
  }
}

TEST_P(StaticFieldUnderForces, KeepsTheCentreOfMass) {
  const std::vector<double> force = several();
  const test::RadialRule rule;
  const PolarGrid points{rule.radius, test::whole_turn(512)};
  const Field field = at_rest(force, points);
  double mean = 0.0;
  for (std::size_t i = 0; i < rule.radius.size(); ++i) {
    for (std::size_t a = 0; a < points.angle.size(); ++a) {
      const std::size_t k = i * points.angle.size() + a;
      mean += rule.weight[i] * rule.radius[i] / 512.0 *
              (field.radial[k] * std::cos(points.angle[a]) - field.tangential[k] * std::sin(points.angle[a]));
    }
  }
  EXPECT_NEAR(mean, 0.0, 1e-13 * std::accumulate(force.begin(), force.end(), 0.0));
}

TEST_P(StaticFieldUnderForces, DoesNotDependOnTheCutoff) {
  const Body finer = disk(poisson, 25.0);
  const PolarGrid points{{0.0, 0.4, 0.9, 1.0}, {0.0, 0.1, 0.7, 2.0, pi}};
  for (const std::vector<double>& force : {single(0, 1.0), several()}) {
    const Field coarse = at_rest(force, points);
    const Field fine = DiskField(poisson, finer, test::grid_of(finer, 0.6, 64).points, points)
                           .at(test::static_coordinates(finer, contact, force), force);
    const double largest = *std::max_element(fine.stress_pp.begin(), fine.stress_pp.end(),
                                             [](double a, double b) { return std::abs(a) < std::abs(b); });
    for (std::size_t k = 0; k < fine.radial.size(); ++k) {
      EXPECT_NEAR(fine.radial[k], coarse.radial[k], 1e-13 * std::abs(largest));
      EXPECT_NEAR(fine.tangential[k], coarse.tangential[k], 1e-13 * std::abs(largest));
      EXPECT_NEAR(fine.stress_rr[k], coarse.stress_rr[k], 1e-13 * std::abs(largest));
      EXPECT_NEAR(fine.stress_pp[k], coarse.stress_pp[k], 1e-13 * std::abs(largest));
      EXPECT_NEAR(fine.stress_rp[k], coarse.stress_rp[k], 1e-13 * std::abs(largest));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Poisson, StaticFieldUnderForces, ::testing::Values(-0.9, 0.0, 0.33, 0.9));

}  // namespace
}  // namespace stoss
