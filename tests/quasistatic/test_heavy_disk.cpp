// A disk that stands under its weight on a wall: Michell's solution for a point of contact, the paper's for a contact
// of finite width, and what integrating the strains on the axis gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/quasistatic/compression.hpp"
#include "stoss/quasistatic/hertz.hpp"
#include "stoss/quasistatic/static_contact.hpp"
#include "support/body_tools.hpp"
#include "support/field_tools.hpp"
#include "support/heavy_disk.hpp"
#include "support/printed_law.hpp"

namespace stoss {
using namespace bodies::disk;
using namespace quasistatic;

namespace {

using std::numbers::pi;
using test::heavy_disk_stress;
using test::HeavyDiskContact;
constexpr std::array contacts{HeavyDiskContact::point, HeavyDiskContact::hertz};

struct Traction {
  double x, y;
};

/// Traction on the edge at the angle φ from the point of contact, as seen from the centre.
Traction on_edge(HeavyDiskContact contact, double force, double phi) {
  const double half = std::sin(0.5 * phi);
  const double x = 2.0 * half * half, y = std::sin(phi);
  const PlaneStress stress = heavy_disk_stress(contact, force, x, y);
  return {stress.xx * (x - 1.0) + stress.xy * y, stress.xy * (x - 1.0) + stress.yy * y};
}

TEST(QuasistaticHeavyDisk, CarriesItsWeight) {
  constexpr double force = 1e-3, h = 2e-3;
  for (const auto contact : contacts) {
    for (const double x : {0.2, 0.5, 1.0, 1.9}) {
      for (const double y : {-0.4, 0.0, 0.1, 0.3}) {
        if (std::hypot(x - 1.0, y) > 0.95) continue;
        std::array<double, 2> divergence{};
        for (std::size_t k = 0; k < 9; ++k) {
          const double step = (static_cast<double>(k) - 4.0) * h;
          const PlaneStress across = heavy_disk_stress(contact, force, x + step, y);
          const PlaneStress along = heavy_disk_stress(contact, force, x, y + step);
          divergence[0] += test::derivative_weights[k] / h * (across.xx + along.xy);
          divergence[1] += test::derivative_weights[k] / h * (across.xy + along.yy);
        }
        EXPECT_NEAR(divergence[0] / force, 1.0, 1e-8) << x << " " << y;
        EXPECT_NEAR(divergence[1] / force, 0.0, 1e-8) << x << " " << y;
      }
    }
  }
}

TEST(QuasistaticHeavyDisk, EdgeIsFreeAllAroundAPointOfContact) {
  for (double phi = 1e-3; phi < 2.0 * pi - 1e-3; phi += 0.01) {
    const Traction traction = on_edge(HeavyDiskContact::point, 1.0 / 16.0, phi);
    const double size = 1.0 / 16.0 / std::abs(std::sin(0.5 * phi));  // of each part
    EXPECT_NEAR(traction.x, 0.0, 1e-15 * size) << phi;
    EXPECT_NEAR(traction.y, 0.0, 1e-15 * size) << phi;
  }
}

TEST(QuasistaticHeavyDisk, EdgeIsFreeToHigherOrderAroundAHertzContact) {
  for (const double phi : {0.3, 1.0, 2.0, 3.0, 5.0}) {
    double previous = 0.0;
    for (const double force : {1e-3, 1e-4, 1e-5, 1e-6}) {
      const Traction traction = on_edge(HeavyDiskContact::hertz, force, phi);
      const double size = std::hypot(traction.x, traction.y);
      EXPECT_LT(size, force * force / (1.0 - std::cos(phi)) * (1.0 + 20.0 * force)) << force << " " << phi;
      // F², that is a² compared with the stress F of the load.
      if (previous > 0.0) {
        EXPECT_NEAR(std::log10(previous / size), 2.0, 0.05) << force << " " << phi;
      }
      previous = size;
    }
  }
}

TEST(QuasistaticHeavyDisk, EdgeInAndNearAHertzContactHasThePressure) {
  for (const double force : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const double a = hertz_half_width(force);
    double greatest = 0.0;
    for (double t = 0.0; t < 3.0; t += 1e-4) {
      const Traction traction = on_edge(HeavyDiskContact::hertz, force, t * a);
      greatest = std::max(greatest, std::hypot(traction.x - hertz_pressure(force, std::sin(t * a)), traction.y));
    }
    EXPECT_LT(greatest, 0.7 * std::pow(force, 0.75)) << force;  // ½√a of the maximum pressure
    EXPECT_GT(greatest, 0.4 * std::pow(force, 0.75)) << force;
  }
}

TEST(QuasistaticHeavyDisk, AxisIsAsPrinted) {
  constexpr double force = 1e-2;
  const double a = hertz_half_width(force), load = pi * force;
  for (const double x : {0.0, 0.01, 0.2, 1.0, 2.0}) {
    const PlaneStress stress = heavy_disk_stress(HeavyDiskContact::hertz, force, x, 0.0);
    const double root = std::sqrt(a * a + x * x);
    EXPECT_NEAR(stress.xx, -load / pi * (2.0 / root - 0.5 * x), 1e-15);
    EXPECT_NEAR(stress.yy,
                -load / pi * (2.0 * (a * a + 2.0 * x * x) / (a * a * root) - 4.0 * x / (a * a) + 0.5 * (x - 2.0)),
                1e-14);
  }
}

TEST(QuasistaticHeavyDisk, StrainsOnTheAxisGiveTheDiameterWithoutPoisson) {
  boost::math::quadrature::tanh_sinh<double> integrate;
  for (const double poisson : {0.0, 0.33, 0.9, -0.5}) {
    for (const double force : {1e-2, 1e-3, 1e-5, 1e-8}) {
      const auto strain = [&](double x) {
        const PlaneStress stress = heavy_disk_stress(HeavyDiskContact::hertz, force, x, 0.0);
        return stress.xx - poisson * stress.yy;
      };
      const double a = hertz_half_width(force);
      const double shortening =
          -integrate.integrate(strain, 0.0, 10.0 * a) - integrate.integrate(strain, 10.0 * a, 2.0);
      // Terms of order F² are left out of the law.
      EXPECT_NEAR(shortening, compression(CompressionLaw::diameter, poisson, force),
                  1.5 * force * force + 1e-13 * force);
      if (poisson != 0.0) {
        const double printed = test::printed_compression(poisson, force);
        EXPECT_NEAR(shortening - printed, poisson * force, 1.5 * force * force + 1e-13 * force);
      }
    }
  }
}

/// Components of the stress in the frame of heavy_disk_stress at the point (r, φ) of a Field.
PlaneStress in_plane(const Field& field, std::size_t k, double phi) {
  const double c = std::cos(phi), s = std::sin(phi);
  const double rr = field.stress_rr[k], pp = field.stress_pp[k], rp = field.stress_rp[k];
  return {rr * c * c + pp * s * s - 2.0 * rp * c * s, rr * s * s + pp * c * c + 2.0 * rp * c * s,
          -((rr - pp) * c * s + rp * (c * c - s * s))};  // x points the other way
}

TEST(QuasistaticHeavyDisk, IsTheStaticFieldOfTheDisk) {
  const double poisson = 0.33;
  const Body body = disk(poisson, 12.5);
  const PolarGrid points{{0.0, 0.3, 0.6, 0.85}, {0.0, 0.4, 1.2, 2.2, pi}};
  // To a share of the load that falls like 1/d² with the distance from the contact.
  const auto compare = [&](const ContactGrid& grid, const std::vector<double>& node_force, HeavyDiskContact contact,
                           double force, double share) {
    const Field field =
        DiskField(poisson, body, grid.points, points).at(test::static_coordinates(body, grid, node_force), node_force);
    std::size_t k = 0;
    for (const double r : points.radius) {
      for (const double phi : points.angle) {
        const PlaneStress found = in_plane(field, k++, phi);
        const double x = 1.0 - r * std::cos(phi), y = r * std::sin(phi);
        const PlaneStress expected = heavy_disk_stress(contact, force, x, y);
        const double tolerance = share * force / (x * x + y * y);
        EXPECT_NEAR(found.xx, expected.xx, tolerance) << r << " " << phi;
        EXPECT_NEAR(found.yy, expected.yy, tolerance) << r << " " << phi;
        EXPECT_NEAR(found.xy, expected.xy, tolerance) << r << " " << phi;
      }
    }
  };
  // One node and its mirror image, 2e-4 apart.
  const ContactGrid fine = test::grid_of(body, 3.2e-3, 16);
  std::vector<double> single(fine.coordinate.size(), 0.0);
  single.front() = 1e-3;
  compare(fine, single, HeavyDiskContact::point, 1e-3, 1e-6);
  // The exact contact: the superposition is wrong by a share of a² = 4F.
  for (const double delta : {6e-4, 6e-3, 6e-2}) {
    const StaticContact exact = static_contact(poisson, delta, {.nodes = 64});
    const auto nodes = static_cast<int>(exact.position.size());
    const ContactGrid grid = test::grid_of(body, (1.0 - 1e-12) * nodes * exact.spacing, nodes);
    EXPECT_NEAR(grid.coordinate.back(), exact.position.back(), 1e-14);
    std::vector<double> forces;
    for (const double p : exact.pressure) forces.push_back(2.0 * exact.spacing * p / pi);
    compare(grid, forces, HeavyDiskContact::hertz, exact.force, 2.0 * exact.force);
  }
}

}  // namespace
}  // namespace stoss
