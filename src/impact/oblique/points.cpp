#include "impact/oblique/points.hpp"

#include <cstddef>

#include "contact/along.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/inputs.hpp"

namespace stoss {

PlanePoint center(const Contact& contact, const ObliqueSnapshot& now, int number) {
  const Body& body = *required_body(contact, number);
  const UnitRatios units = units_of(contact, number);
  // The centre of mass of both rests, and the share of a body in their relative motion is that of the other's mass.
  const double share = contact.whole_mass / (whole_mass(body) * units.mass);
  const double overlap = now.center + contact.extent, side = number == 0 ? -1.0 : 1.0;
  return {side * (body.extent * units.length - share * overlap), -side * share_along(contact, number) * now.shift};
}

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
