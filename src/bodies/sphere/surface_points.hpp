#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stoss/body/body.hpp"

namespace stoss::bodies::sphere {

/// Angle θ on the sphere of what lies at the angle α on the circle of the contact points: sin θ = radius · sin α.
[[nodiscard]] inline double polar_angle(const ContactPoints& points, double alpha) {
  return points.radius == 1.0 ? alpha : std::asin(std::min(1.0, points.radius * std::sin(alpha)));
}

/// θ of the ring i.
[[nodiscard]] inline double ring_angle(const ContactPoints& points, std::size_t i) {
  return polar_angle(points, points.angle(i));
}

/// Area that the ring i stands for: the band between the angles halfway to its neighbours.
[[nodiscard]] inline double ring_area(const ContactPoints& points, std::size_t i) {
  constexpr double four_pi = 12.566370614359172954;
  const double inner = polar_angle(points, static_cast<double>(i) * points.spacing);
  const double outer = polar_angle(points, static_cast<double>(i + 1) * points.spacing);
  return four_pi * std::sin(0.5 * (inner + outer)) * std::sin(0.5 * (outer - inner));
}

/// The surface of a sphere along its axis, with the rows P_0 … P_{rows−1}.
[[nodiscard]] Surface axial_surface(double poisson, std::size_t rows, const ContactPoints& points);

}  // namespace stoss::bodies::sphere
