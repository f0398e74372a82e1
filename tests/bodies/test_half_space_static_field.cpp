// The field below a half-space at rest under small loads is Boussinesq's, below a half-plane Flamant's.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/half_space/field.hpp"

namespace stoss::bodies::half_space {
namespace {

using std::numbers::pi;

ContactPoints static_rings(std::size_t count, double half_width) {
  return {1.0, std::asin(half_width) / static_cast<double>(count), count};
}

/// Coordinates of the waves at rest under forces on the rings.
std::vector<double> at_rest(const Body& body, const ContactPoints& contact, const std::vector<double>& force) {
  const Surface surface = body.surface(contact);
  std::vector<double> coordinate;
  for (const ModeGroup& group : body.groups) {
    double load = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      load += force[i] * surface.shape[group.upper_row * force.size() + i];
    }
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      coordinate.push_back(-load * group.upper[l] / (group.omega[l] * group.omega[l]));
    }
  }
  return coordinate;
}

TEST(HalfSpaceField, IsBoussinesqsFarBelowASmallLoad) {
  constexpr double poisson = 0.3, mu = 0.5 / (1.0 + poisson);
  const Body body = stoss::half_space(HalfSpace{.poisson = poisson}, 6.0, 20.0);
  const ContactPoints contact = static_rings(2, 1e-3);
  const std::vector<double> force{0.7, 0.3}, distance{0.0, 0.2, 1.0, 2.5}, depth{0.3, 1.0, 3.0};
  const Field at = HalfSpaceField(poisson, body, contact, {distance, depth}).at(at_rest(body, contact, force), force);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    for (std::size_t j = 0; j < distance.size(); ++j) {
      const double z = depth[i], r = distance[j], away = std::hypot(r, z), unit = 1.0 / (4.0 * pi * mu * away);
      const double normal = unit * (2.0 * (1.0 - poisson) + z * z / (away * away));
      const double lateral = unit * (r * z / (away * away) - (1.0 - 2.0 * poisson) * r / (away + z));
      EXPECT_NEAR(at.normal[i * distance.size() + j], normal, 1e-5 * normal) << r << ' ' << z;
      EXPECT_NEAR(at.lateral[i * distance.size() + j], lateral, 1e-5 * normal) << r << ' ' << z;
    }
  }
}

TEST(HalfSpaceField, StrainsAHalfPlaneAsFlamantsLoad) {
  // Displacements under a line force have no zero: u_y between two depths, and u_x, are 2/π times (E = F = 1)
  //   ln(r₂/r₁) + ½(1 + ν)(sin²θ₂ − sin²θ₁) and −½(1 − ν)θ + ½(1 + ν) sin θ cos θ.
  constexpr double poisson = 0.33;
  const Body body = stoss::half_plane(HalfPlane{.poisson = poisson}, 6.0, 20.0);
  const ContactPoints contact = static_rings(2, 1e-3);
  const std::vector<double> force{0.7, 0.3}, distance{0.0, 0.5, 1.5}, depth{0.4, 1.0, 2.0};
  const Field at = HalfSpaceField(poisson, body, contact, {distance, depth}).at(at_rest(body, contact, force), force);
  const auto expected = [&](double x, double z) {
    const double sine = x / std::hypot(x, z);
    return -2.0 / pi * (std::log(std::hypot(x, z)) + 0.5 * (1.0 + poisson) * sine * sine);
  };
  for (std::size_t i = 0; i < depth.size(); ++i) {
    for (std::size_t j = 0; j < distance.size(); ++j) {
      const double z = depth[i], x = distance[j], theta = std::atan2(x, z);
      const double lateral =
          2.0 / pi * (-0.5 * (1.0 - poisson) * theta + 0.5 * (1.0 + poisson) * std::sin(theta) * std::cos(theta));
      EXPECT_NEAR(at.lateral[i * 3 + j], lateral, 2e-4) << x << ' ' << z;
      EXPECT_NEAR(at.normal[i * 3 + j] - at.normal[0], expected(x, z) - expected(0.0, depth[0]), 2e-4) << x << ' ' << z;
    }
  }
}

}  // namespace
}  // namespace stoss::bodies::half_space
