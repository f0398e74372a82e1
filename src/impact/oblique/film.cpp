#include "impact/oblique/film.hpp"

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

ObliqueFilm::ObliqueFilm(const NormalCourse& course, const Obliquity& before, const ObliqueObservation& observation)
    : course_(course), before_(before), observation_(observation) {
  require_every(observation.every);
  if (!watched()) return;
  points_ = course.points;
  nodes_.resize(course.nodes.count);
}

bool ObliqueFilm::wanted() const { return step_ % observation_.every == 0 || step_ == course_.impact.steps; }

bool ObliqueFilm::advance() {
  if (!watched()) return false;
  ++step_;
  return wanted();
}

void ObliqueFilm::fly(long until, const AlongMotion& since) {
  if (!watched()) return;
  shift_ += since.shift;
  for (std::size_t k = 0; k < 2; ++k) angle_[k] += since.angle[k];
  if (!begun_) show_flight(since.outcome);
  begun_ = true;
  while (step_ < until) {
    ++step_;
    shift_ += since.outcome.tangential * course_.impact.resolution.step;
    for (std::size_t k = 0; k < 2; ++k) angle_[k] += since.outcome.spin[k] * course_.impact.resolution.step;
    if (wanted()) show_flight(since.outcome);
  }
}

void ObliqueFilm::show_flight(const AlongOutcome& along) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double slip = along.tangential + along.spin[0] * course_.arm[0][i] + along.spin[1] * course_.arm[1][i];
    nodes_[i] = {0.0, begun_ ? slip : 0.0, slip > 0.0 ? 1 : slip < 0.0 ? -1 : 0};
  }
  load(nodes_);
  show_instant({along});
}

void ObliqueFilm::show(const AlongMotion& along, const std::vector<PointFriction>& nodes) {
  load(nodes);
  show_instant(along);
}

void ObliqueFilm::load(const std::vector<PointFriction>& nodes) {
  const std::size_t count = nodes.size();
  const double share = points_.size() > count ? 0.5 : 1.0;
  const double* force = course_.at(step_).force;
  const auto set = [&](ObliquePoint& point, std::size_t i) {
    point.pressure = force == nullptr ? 0.0 : share * force[i];
    point.friction = share * nodes[i].friction;
    point.slip = nodes[i].slip;
    point.grip = static_cast<Grip>(nodes[i].sliding);
  };
  for (std::size_t i = 0; i < count; ++i) {
    set(points_[points_.size() - count + i], i);
    if (points_.size() > count) set(points_[count - 1 - i], i);
  }
}

void ObliqueFilm::show_instant(const AlongMotion& along) {
  const ObliqueFrame& frame = course_.frame;
  const NormalInstant normal = course_.at(step_);
  const double elastic = frame.normal_energy - 0.5 * frame.mass * normal.velocity * normal.velocity;
  ObliqueSnapshot now = frame.instant(normal.time, before_, normal.velocity, along.outcome, elastic);
  now.center = normal.center;
  now.shift = shift_ + along.shift;
  now.angle = angle_[0] + along.angle[0];
  now.second_angle = angle_[1] + along.angle[1];
  show_points(points_, course_.unit, now);
  observation_.observer(now);
}

ObliqueImpact smooth_impact(const NormalCourse& course, const Obliquity& before,
                            const ObliqueObservation& observation) {
  const AlongOutcome same = ObliqueFrame::unchanged(before);
  ObliqueFilm(course, before, observation).fly(course.impact.steps, {same});
  return course.frame.joined(course.impact, before, same);
}

}  // namespace stoss
