#include "collision.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "alive.hpp"
#include "stoss/contact/grid.hpp"
#include "values.hpp"

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
    val made = val::object();
    made.set("body", mode.body);
    made.set("order", mode.order);
    made.set("index", mode.index);
    made.set("omega", mode.omega);
    made.set("after", mode.after);
    made.set("average", mode.average);
    list.call<void>("push", made);
  }
  return list;
}

double poisson(const Solid& block) {
  const auto* half_plane = std::get_if<HalfPlane>(&block);
  return half_plane != nullptr ? half_plane->poisson : std::get<HalfSpace>(block).poisson;
}

/// @param unit of stress
val interior(const Interior& now, double unit) {
  val made = val::object();
  made.set("radial", float32_array(now.radial));
  made.set("tangential", float32_array(now.tangential));
  made.set("vonMises", float32_array(now.von_mises, unit));
  made.set("fringes", float32_array(now.fringes, unit));
  return made;
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
    val made = val::object();
    made.set("kind", kind);
    made.set("radius", radius);
    list.call<void>("push", made);
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
  val units = val::object();
  for (const auto& [name, dimension] :
       {std::pair{"time", time}, {"length", length}, {"speed", speed}, {"force", force}}) {
    units.set(name, meeting_->unit_name(dimension));
  }
  const auto touches = [](const Snapshot& now) { return now.force > 0.0; };
  const auto begin = std::find_if(snapshots_.begin(), snapshots_.end(), touches);
  const auto end = std::find_if(snapshots_.rbegin(), snapshots_.rend(), touches);
  const double second = meeting_->unit(time);
  val made = val::object();
  made.set("units", units);
  made.set("time", of_all(snapshots_, &Snapshot::time, second));
  made.set("velocity", of_all(snapshots_, &Snapshot::velocity, meeting_->unit(speed)));
  made.set("force", of_all(snapshots_, &Snapshot::force, meeting_->unit(force)));
  made.set("halfWidth", of_all(snapshots_, &Snapshot::contact_half_width, meeting_->unit(length)));
  made.set("translation", of_all(snapshots_, &Snapshot::translation));
  made.set("vibration", of_all(snapshots_, &Snapshot::vibration));
  made.set("stored", of_all(snapshots_, &Snapshot::stored));
  made.set("dissipated", of_all(snapshots_, &Snapshot::dissipated));
  made.set("unresolved", of_all(snapshots_, &Snapshot::unresolved));
  made.set("modes", of_modes(impact_.energy.modes, meeting_->against_half_space()));
  made.set("begin", begin == snapshots_.end() ? 0.0 : begin->time * second);
  made.set("end", end == snapshots_.rend() ? 0.0 : end->time * second);
  made.set("bodies", bodies());
  return made;
}

val Collision::body_frame(const Frame& frame, int number) {
  val made = val::object();
  made.set("center", center(contact_, frame.state, number));
  const Body& body = number == 0 ? *contact_.first : *contact_.second;
  if (body.part.size < 1.0) {
    // Only its near side is computed: it is shown as it is at rest.
    const std::vector<double> rest(points_.radius.size() * points_.angle.size());
    for (const char* name : {"radial", "tangential", "vonMises", "fringes"}) made.set(name, float32_array(rest));
    return made;
  }
  const BodyFrame seen = seen_by(contact_, grid_, frame, number);
  auto found = insides_.find(number);
  if (found == insides_.end()) {
    Inside made_now = inside(meeting_->solid(number), seen, points_);
    found = insides_.emplace(number, std::move(made_now)).first;
  }
  val seen_inside = interior(found->second(seen), seen.stress);
  seen_inside.set("center", made["center"]);
  return seen_inside;
}

val Collision::block_frame(const Frame& frame, const bodies::half_space::PlaneGrid& below) {
  const BodyFrame seen = seen_by(contact_, grid_, frame, 1);
  if (!block_) block_.emplace(poisson(meeting_->solid(1)), seen, below);
  return interior(block_->at(seen), seen.stress);
}

void Collision::frames(const std::vector<double>& times, const Points& points,
                       const bodies::half_space::PlaneGrid& below, const val& deliver) {
  if (points != points_) {
    insides_.clear();
    block_.reset();
  }
  points_ = points;
  const double unit = meeting_->unit(Dimension::time);
  std::vector<double> own(times.size());
  std::transform(times.begin(), times.end(), own.begin(), [unit](double time) { return time / unit; });
  const std::vector<Frame> instants = motion(contact_, impact_, own, say_alive);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    say_alive();
    val made = val::object();
    made.set("time", instants[i].time * unit);
    val seen = val::array();
    seen.call<void>("push", body_frame(instants[i], 0));
    if (meeting_->against_half_space()) {
      made.set("block", block_frame(instants[i], below));
    } else if (contact_.second) {
      seen.call<void>("push", body_frame(instants[i], 1));
    }
    made.set("bodies", seen);
    deliver(made, i);
  }
}

}  // namespace stoss::web
