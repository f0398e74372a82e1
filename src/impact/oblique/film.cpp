#include "impact/oblique/film.hpp"

#include "impact/inputs.hpp"
#include "impact/oblique/points.hpp"

namespace stoss {

AlongMotion times(double factor, const AlongMotion& motion) {
  const auto& [first, second] = motion.angle;
  return {times(factor, motion.outcome), factor * motion.shift, {factor * first, factor * second}};
}

std::vector<Rub> times(double factor, std::vector<Rub> nodes) {
  for (Rub& node : nodes) {
    node.friction *= factor;
    node.slip *= factor;
  }
  return nodes;
}

ObliqueFilm::ObliqueFilm(const NormalCourse& course, const Obliquity& before, const ObliqueObservation& observation)
    : course_(course), before_(before), observation_(observation), normal_(course) {
  require_every(observation.every);
  if (!watched()) return;
  points_ = course.points;
  nodes_.resize(course.nodes.count);
}

bool ObliqueFilm::wanted() const {
  return normal_.step() % observation_.every == 0 || normal_.step() == course_.impact.steps;
}

bool ObliqueFilm::advance() {
  if (!watched()) return false;
  normal_.advance();
  return wanted();
}

void ObliqueFilm::fly(long until, const AlongMotion& since) {
  if (!watched()) return;
  shift_ += since.shift;
  for (std::size_t k = 0; k < 2; ++k) angle_[k] += since.angle[k];
  if (!begun_) show_flight(since.outcome);
  begun_ = true;
  while (normal_.step() < until) {
    normal_.advance();
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

void ObliqueFilm::show(const AlongMotion& along, const std::vector<Rub>& nodes) {
  load(nodes);
  show_instant(along);
}

void ObliqueFilm::load(const std::vector<Rub>& nodes) {
  const std::size_t count = nodes.size();
  const double share = points_.size() > count ? 0.5 : 1.0;
  const auto set = [&](ObliquePoint& point, std::size_t i) {
    point.pressure = share * normal_.force(i);
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
  const double velocity = normal_.velocity();
  const double elastic = frame.normal_energy - 0.5 * frame.mass * velocity * velocity;
  ObliqueSnapshot now = frame.instant(normal_.time(), before_, velocity, along.outcome, elastic);
  now.center = normal_.center();
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
