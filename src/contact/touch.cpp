#include "contact/touch.hpp"

#include "contact/units.hpp"

namespace stoss {

Touch touch(const Contact& contact) {
  if (contact.second == nullptr) return {};
  const Units units(*contact.second, *contact.first);
  Touch touch;
  touch.curvature = 1.0 + 1.0 / units.length;
  touch.softness = 1.0 + units.compliance;
  touch.slowness = (1.0 + units.compliance * units.time / units.length) / touch.softness;
  return touch;
}

double touch_compression(const Contact& contact, const ContactGrid& grid) {
  if (has_single_point(contact)) return 0.0;
  const double spacing = grid.points.spacing * grid.points.radius;
  return -touch(contact).curvature * spacing * spacing / 24.0;
}

}  // namespace stoss
