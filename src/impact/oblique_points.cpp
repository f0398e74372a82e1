#include "impact/oblique_points.hpp"

#include <cstddef>

namespace stoss {

bool is_sided(const Contact& contact) {
  return !has_single_point(contact) && contact.first->contour == Contour::cylinder;
}

std::vector<ObliquePoint> points_at_rest(const Contact& contact, const ContactGrid& grid) {
  const std::size_t count = grid.points.count;
  std::vector<ObliquePoint> points;
  points.reserve(2 * count);
  const bool sided = is_sided(contact);
  const double share = sided ? 0.5 : 1.0;
  for (std::size_t i = sided ? count : 0; i-- > 0;) {
    points.push_back({.place = -grid.coordinate[i], .measure = share * grid.measure[i]});
  }
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({.place = grid.coordinate[i], .measure = share * grid.measure[i]});
  }
  return points;
}

void show_points(std::vector<ObliquePoint>& points, double unit, ObliqueSnapshot& now) {
  for (ObliquePoint& point : points) {
    point.pressure /= unit;
    point.friction /= unit;
    now.force += point.pressure;
    now.friction += point.friction;
    if (point.pressure > 0.0) {
      ++now.touching;
    } else {
      point.grip = Grip::open;
    }
  }
  now.points = points;
}

}  // namespace stoss
