#include "collision.hpp"

#include <algorithm>
#include <utility>

#include "javascript.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// One quantity of all instants.
val of_all(const std::vector<Snapshot>& snapshots, double Snapshot::*quantity, double unit = 1.0) {
  std::vector<double> values(snapshots.size());
  std::transform(snapshots.begin(), snapshots.end(), values.begin(),
                 [=](const Snapshot& now) { return unit * (now.*quantity); });
  return float64_array(values);
}

/// Of the bodies, without the waves of a half-space.
val of_modes(const std::vector<ModeEnergy>& modes, bool against_half_space) {
  val list = val::array();
  for (const ModeEnergy& mode : modes) {
    if (against_half_space && mode.body == 1) continue;
    list.call<void>("push", object({{"body", val(mode.body)},
                                    {"order", val(mode.order)},
                                    {"index", val(mode.index)},
                                    {"omega", val(mode.omega)},
                                    {"after", val(mode.after)},
                                    {"average", val(mode.average)}}));
  }
  return list;
}

}  // namespace

Collision::Collision(std::shared_ptr<const Meeting> meeting, double speed, double cutoff)
    : meeting_(std::move(meeting)) {
  const double own_speed = stoss::own_speed(meeting_->encounter, speed);
  contact_ = contact_of(meeting_->encounter, cutoff, own_speed);
  const ImpactObserver observer = [this](const Snapshot& now) { snapshots_.push_back(now); };
  impact_ = impact(contact_, own_speed, {.poll = say_alive}, {.observer = observer});
  grid_ = contact_grid(contact_, impact_.resolution.half_width, impact_.resolution.nodes);
}

val Collision::bodies() const {
  val list = val::array();
  const auto add = [&](const std::string& kind, double radius) {
    list.call<void>("push", object({{"kind", val(kind)}, {"radius", val(radius)}}));
  };
  const std::string& kind = meeting_->encounter.first.kind;
  add(kind, 1.0);
  if (meeting_->against_half_space()) {
    add("half-space", 1.0);
  } else if (contact_.second) {
    add(kind, contact_.second->scale.length / contact_.first->scale.length);
  }
  return list;
}

val Collision::series() const {
  using enum Dimension;
  const auto touches = [](const Snapshot& now) { return now.force > 0.0; };
  const auto begin = std::find_if(snapshots_.begin(), snapshots_.end(), touches);
  const auto end = std::find_if(snapshots_.rbegin(), snapshots_.rend(), touches);
  const double second = meeting_->unit(time);
  const auto unit_of = [&](Dimension dimension) { return val(meeting_->unit_name(dimension)); };
  return object({{"units", object({{"time", unit_of(time)},
                                   {"length", unit_of(length)},
                                   {"speed", unit_of(speed)},
                                   {"force", unit_of(force)}})},
                 {"time", of_all(snapshots_, &Snapshot::time, second)},
                 {"velocity", of_all(snapshots_, &Snapshot::velocity, meeting_->unit(speed))},
                 {"force", of_all(snapshots_, &Snapshot::force, meeting_->unit(force))},
                 {"halfWidth", of_all(snapshots_, &Snapshot::contact_half_width, meeting_->unit(length))},
                 {"translation", of_all(snapshots_, &Snapshot::translation)},
                 {"vibration", of_all(snapshots_, &Snapshot::vibration)},
                 {"stored", of_all(snapshots_, &Snapshot::stored)},
                 {"dissipated", of_all(snapshots_, &Snapshot::dissipated)},
                 {"unresolved", of_all(snapshots_, &Snapshot::unresolved)},
                 {"modes", of_modes(impact_.energy.modes, meeting_->against_half_space())},
                 {"begin", val(begin == snapshots_.end() ? 0.0 : begin->time * second)},
                 {"end", val(end == snapshots_.rend() ? 0.0 : end->time * second)},
                 {"bodies", bodies()}});
}

void Collision::frames(const std::vector<double>& times, const bodies::PolarGrid& points,
                       const bodies::half_space::PlaneGrid& below, const val& deliver) {
  if (points.radius != points_.radius || points.angle != points_.angle) insides_.clear();
  points_ = points;
  const double unit = meeting_->unit(Dimension::time);
  std::vector<double> own(times.size());
  std::transform(times.begin(), times.end(), own.begin(), [unit](double time) { return time / unit; });
  const std::vector<Frame> instants = motion(contact_, impact_, own, say_alive);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    val seen = val::array();
    for (std::size_t n = 0; n < (contact_.second ? 2 : 1); ++n) {
      const BodyFrame its = seen_by(contact_, grid_, instants[i], static_cast<int>(n));
      if (insides_.size() == n) {
        insides_.push_back(inside(meeting_->solid(static_cast<int>(n)), its, points, below, say_alive));
      }
      const Interior now = insides_[n](its);
      seen.call<void>("push", object({{"center", val(its.center)},
                                      {"radial", float32_array(now.radial)},
                                      {"tangential", float32_array(now.tangential)},
                                      {"vonMises", float32_array(now.von_mises, its.stress)},
                                      {"fringes", float32_array(now.principal_difference, its.stress)}}));
    }
    deliver(object({{"time", val(instants[i].time * unit)}, {"bodies", seen}}), i);
  }
}

}  // namespace stoss::web
