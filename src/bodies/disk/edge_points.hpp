#pragma once

#include <cmath>

#include "stoss/body/body.hpp"

namespace stoss::bodies::disk {

/// Angle φ of a contact point on the edge of the disk: sin φ = radius · sin α.
[[nodiscard]] inline double edge_angle(const ContactPoints& points, std::size_t i) {
  const double angle = points.angle(i);
  return points.radius == 1.0 ? angle : std::asin(points.radius * std::sin(angle));
}

/// dφ/dα: 1 if the points lie on a circle of the size of the disk.
[[nodiscard]] inline double edge_stretch(const ContactPoints& points, std::size_t i) {
  if (points.radius == 1.0) return 1.0;
  return points.radius * std::cos(points.angle(i)) / std::cos(edge_angle(points, i));
}

}  // namespace stoss::bodies::disk
