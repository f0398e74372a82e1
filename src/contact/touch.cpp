#include "contact/touch.hpp"

#include <cmath>

#include "contact/unit_ratios.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

Touch touch(const Contact& contact) {
  Touch touch;
  const double first = contact.first->softness;
  touch.circle = contact.first->contour == Contour::ball;
  touch.softness = first;
  touch.loss_time = contact.first->loss_time;
  if (contact.second == nullptr) return touch;
  const UnitRatios units = units_of(contact, 1);
  const double second = contact.second->softness * units.softness;
  touch.curvature = contact.first->curvature + contact.second->curvature / units.length;
  touch.softness = first + second;
  touch.loss_time = (first * touch.loss_time + second * contact.second->loss_time * units.time) / touch.softness;
  touch.slowness = (first + second * units.time / units.length) / touch.softness;
  return touch;
}

std::vector<RelaxingBody> relaxing_bodies(const Contact& contact) {
  const double softness = touch(contact).softness;
  std::vector<RelaxingBody> bodies;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr || body->relaxation.terms.empty()) continue;
    const UnitRatios units = units_of(contact, number);
    bodies.push_back({body->softness * units.softness / softness, in_time(body->relaxation, units.time)});
  }
  return bodies;
}

double loss_share(const Contact& contact) {
  const Touch met = touch(contact);
  if (met.loss_time > 0.0) return contact.first->softness * contact.first->loss_time / (met.softness * met.loss_time);
  const auto relaxing = [&](int number) {
    const auto body = body_of(contact, number);
    return body == nullptr ? 0.0
                           : body->softness * units_of(contact, number).softness * (1.0 - body->relaxation.relaxed());
  };
  const double first = relaxing(0), both = first + relaxing(1);
  return both > 0.0 ? first / both : 1.0;
}

double touch_compression(const Contact& contact, const ContactGrid& grid, double edge) {
  const double mean_plane = contact.asperities > 0.0 ? -std::log(contact.strength) * contact.asperities : 0.0;
  if (has_single_point(contact)) return mean_plane;
  const double spacing = grid.points.spacing * grid.points.radius;
  const Touch met = touch(contact);
  return mean_plane - edge * met.curvature * spacing * spacing / (met.circle ? 12.0 : 24.0);
}

}  // namespace stoss
