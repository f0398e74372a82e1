#include "impact/oblique/rings/normal_course.hpp"

#include <algorithm>
#include <cstddef>

#include "impact/oblique/film.hpp"

namespace stoss {

NormalCourse::NormalCourse(const Contact& contact, double speed, const ImpactOptions& options)
    : frame(contact, speed, options), mass(contact.mass), extent(contact.extent), unit(whole_mass(*contact.first)) {
  impact = stoss::impact(contact, speed, options, {}, &pressures);
  if (!loses(contact)) pressures.end_with_contact();
  const ContactGrid grid = contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes);
  nodes = grid.points;
  arm = arms(contact, nodes);
  points = points_at_rest(contact, grid);
}

NormalInstant NormalCourse::at(long step) const {
  const double time = static_cast<double>(step) * impact.resolution.step;
  NormalInstant now{time, frame.speed, pressures.start() + frame.speed * time};
  if (step >= pressures.first() && pressures.steps() > 0) {
    const auto since = static_cast<std::size_t>(step - pressures.first());
    const std::size_t last = std::min(since, pressures.steps() - 1);
    now.velocity = pressures.velocity(last);
    now.center =
        pressures.compression(last) + now.velocity * static_cast<double>(since - last) * impact.resolution.step;
    if (since == last) now.force = pressures.force(last);
  }
  const double part = mass / frame.mass;
  if (part != 1.0) {
    const double free = pressures.start() + frame.speed * time;
    now.velocity = frame.speed - part * (frame.speed - now.velocity);
    now.center = free - part * (free - now.center);
  }
  now.center -= extent;
  return now;
}

}  // namespace stoss
