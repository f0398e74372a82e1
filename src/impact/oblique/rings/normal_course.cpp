#include "impact/oblique/rings/normal_course.hpp"

#include <cstddef>

#include "impact/oblique/film.hpp"

namespace stoss {

NormalCourse::NormalCourse(const Contact& contact, double speed, const ImpactOptions& options)
    : frame(contact, speed, options), mass(contact.mass), extent(contact.extent), unit(whole_mass(*contact.first)) {
  impact = stoss::impact(contact, speed, options, {}, &pressures);
  if (longest_loss_time(contact) == 0.0) pressures.end_with_contact();
  const ContactGrid grid = contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes);
  nodes = grid.points;
  arm = arms(contact, nodes);
  points = points_at_rest(contact, grid);
}

NormalReplay::NormalReplay(const NormalCourse& course)
    : course_(course),
      part_(course.mass / course.frame.mass),
      compression_(course.pressures.start()),
      velocity_(course.frame.speed) {
  load();
  velocity_ += 0.5 * total_ * course_.impact.resolution.step / course_.mass;
}

void NormalReplay::load() {
  const Pressures& pressures = course_.pressures;
  const auto at = static_cast<std::size_t>(step_ - pressures.first());
  const bool pressed = step_ >= pressures.first() && at < pressures.steps();
  force_ = pressed ? pressures.force(at) : nullptr;
  total_ = 0.0;
  for (std::size_t i = 0; pressed && i < pressures.extent(at); ++i) total_ += force_[i];
}

void NormalReplay::advance() {
  const double step = course_.impact.resolution.step;
  velocity_ -= total_ * step / course_.mass;
  compression_ += velocity_ * step;
  ++step_;
  load();
}

double NormalReplay::velocity() const {
  const double own = velocity_ - 0.5 * total_ * course_.impact.resolution.step / course_.mass;
  return part_ == 1.0 ? own : course_.frame.speed - part_ * (course_.frame.speed - own);
}

double NormalReplay::center() const {
  const double own = compression_ - course_.extent;
  if (part_ == 1.0) return own;
  const double free = course_.pressures.start() - course_.extent + course_.frame.speed * time();
  return free - part_ * (free - own);
}

}  // namespace stoss
