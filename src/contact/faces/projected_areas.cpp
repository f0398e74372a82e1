#include "contact/faces/projected_areas.hpp"

#include <cmath>
#include <numbers>

namespace stoss {

std::vector<double> projected_areas(const Contact& contact, const ContactPoints& points) {
  if (has_single_point(contact)) return {1.0};
  constexpr double first_ring = 11.0 / 12.0;
  const bool circle = contact.first->contour == Contour::ball;
  const double width = 2.0 * points.radius * points.spacing;
  std::vector<double> area;
  for (std::size_t i = 0; i < points.count; ++i) {
    const double angle = points.angle(i), ring = i == 0 ? first_ring : 1.0;
    const double around = circle ? std::numbers::pi * points.radius * std::sin(angle) * ring : 1.0;
    area.push_back(width * std::cos(angle) * around);
  }
  return area;
}

}  // namespace stoss
