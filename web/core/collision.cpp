#include "collision.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "alive.hpp"
#include "stoss/contact/grid.hpp"
#include "values.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

constexpr std::array<const char*, 3> kinds{"disk", "sphere", "rod"};

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

Collision::Collision(const Encounter& encounter, double speed, double cutoff) : encounter_(encounter) {
  const double own_speed = encounter.own_speed(speed);
  contact_ = encounter.contact(cutoff, own_speed);
  const ImpactObserver observer = [this](const Snapshot& now) { snapshots_.push_back(now); };
  impact_ = impact(contact_, own_speed, {.poll = say_alive}, {.observer = observer});
  grid_ = contact_grid(contact_, impact_.resolution.half_width, impact_.resolution.nodes);
}

val Collision::bodies() const {
  val list = val::array();
  const auto add = [&](const char* kind, double radius) {
    val made = val::object();
    made.set("kind", std::string(kind));
    made.set("radius", radius);
    list.call<void>("push", made);
  };
  const char* const kind = kinds.at(static_cast<std::size_t>(encounter_.kind()));
  add(kind, 1.0);
  if (encounter_.against_half_space()) {
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
    units.set(name, encounter_.unit_name(dimension));
  }
  const auto touches = [](const Snapshot& now) { return now.force > 0.0; };
  const auto begin = std::find_if(snapshots_.begin(), snapshots_.end(), touches);
  const auto end = std::find_if(snapshots_.rbegin(), snapshots_.rend(), touches);
  const double second = encounter_.unit(time);
  val made = val::object();
  made.set("units", units);
  made.set("time", of_all(snapshots_, &Snapshot::time, second));
  made.set("velocity", of_all(snapshots_, &Snapshot::velocity, encounter_.unit(speed)));
  made.set("force", of_all(snapshots_, &Snapshot::force, encounter_.unit(force)));
  made.set("halfWidth", of_all(snapshots_, &Snapshot::contact_half_width, encounter_.unit(length)));
  made.set("translation", of_all(snapshots_, &Snapshot::translation));
  made.set("vibration", of_all(snapshots_, &Snapshot::vibration));
  made.set("stored", of_all(snapshots_, &Snapshot::stored));
  made.set("dissipated", of_all(snapshots_, &Snapshot::dissipated));
  made.set("unresolved", of_all(snapshots_, &Snapshot::unresolved));
  made.set("modes", of_modes(impact_.energy.modes, encounter_.against_half_space()));
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
    Inside made_now = inside(encounter_.kind(), encounter_.poisson(number), seen, points_);
    found = insides_.emplace(number, std::move(made_now)).first;
  }
  val seen_inside = interior(found->second(seen), seen.stress);
  seen_inside.set("center", made["center"]);
  return seen_inside;
}

val Collision::block_frame(const Frame& frame, const bodies::half_space::PlaneGrid& below) {
  const BodyFrame seen = seen_by(contact_, grid_, frame, 1);
  if (!block_) block_.emplace(encounter_.poisson(1), seen, below);
  return interior(block_->at(seen), seen.stress);
}

void Collision::frames(const std::vector<double>& times, const Points& points,
                       const bodies::half_space::PlaneGrid& below, const val& deliver) {
  if (points != points_) {
    insides_.clear();
    block_.reset();
  }
  points_ = points;
  const double unit = encounter_.unit(Dimension::time);
  std::vector<double> own(times.size());
  std::transform(times.begin(), times.end(), own.begin(), [unit](double time) { return time / unit; });
  const std::vector<Frame> instants = motion(contact_, impact_, own, say_alive);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    say_alive();
    val made = val::object();
    made.set("time", instants[i].time * unit);
    val seen = val::array();
    seen.call<void>("push", body_frame(instants[i], 0));
    if (encounter_.against_half_space()) {
      made.set("block", block_frame(instants[i], below));
    } else if (contact_.second) {
      seen.call<void>("push", body_frame(instants[i], 1));
    }
    made.set("bodies", seen);
    deliver(made, i);
  }
}

}  // namespace stoss::web
