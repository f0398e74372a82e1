#include "row/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "check.hpp"
#include "row/flight.hpp"
#include "stoss/errors.hpp"

namespace stoss {
RowMotion::RowMotion(const MadeRow& row, const std::vector<double>& speeds, const RowState* start, const Poll& poll)
    : row_(row) {
  for (const MadeRow::Joint& joint : row.joints) {
    meetings_.emplace_back(*joint.contact, joint.resolution, joint.speed, poll);
  }
  std::vector<FacePoints> points(row.bodies.size());
  for (std::size_t k = 0; k < row.joints.size(); ++k) {
    const MadeRow::Joint& joint = row.joints[k];
    const auto face = static_cast<std::size_t>(joint.face);
    points[static_cast<std::size_t>(joint.one)][face] = meetings_[k].points(0);
    if (joint.other >= 0) points[static_cast<std::size_t>(joint.other)][1 - face] = meetings_[k].points(1);
  }
  solids_.reserve(row.bodies.size());
  for (std::size_t b = 0; b < row.bodies.size(); ++b) {
    const auto like = std::find_if(solids_.begin(), solids_.end(),
                                   [&](const RowSolid& each) { return each.is_alike(*row.bodies[b], points[b]); });
    if (like != solids_.end()) {
      solids_.push_back(like->alike(speeds[b]));
    } else {
      solids_.emplace_back(row.bodies[b], row.units[b], points[b], row.step, speeds[b]);
    }
    translation_ += solids_[b].translation();
  }
  vibrate(start);
  place(speeds);
  sleep_.resize(meetings_.size()), awake_joints_.resize(solids_.size()), known_at_.resize(solids_.size());
  for (const MadeRow::Joint& joint : row.joints) {
    for (const int each : {joint.one, joint.other}) {
      if (each >= 0) ++awake_joints_[static_cast<std::size_t>(each)];
    }
  }
  displacement_.resize(solids_.size()), velocity_.resize(solids_.size()), force_.resize(meetings_.size());
  respond();
  for (RowSolid& solid : solids_) solid.begin();
  whole_ = total(in_units());
  momentum_ = momentum();
}

void RowMotion::vibrate(const RowState* start) {
  if (start != nullptr) {
    if (start->coordinate.size() != solids_.size() || start->momentum.size() != solids_.size()) {
      throw InvalidInput::out_of_range("start", std::to_string(start->coordinate.size()) + " bodies",
                                       std::to_string(solids_.size()), "those of the row");
    }
    for (std::size_t b = 0; b < solids_.size(); ++b) solids_[b].set(start->coordinate[b], start->momentum[b]);
    return;
  }
  for (const Oscillation& mode : row_.vibration) {
    const long last = static_cast<long>(solids_.size()) - 1;
    require("vibration body", static_cast<long>(mode.body), 0, last, "number of a body");
    require("energy", mode.energy, {0.0, 1e12, true, true, "0 to 1e12"}, "of a mode, over that of all centres");
    require("phase", mode.phase, {-1e12, 1e12, true, true, "-1e12 to 1e12"}, "of a mode, radians");
    body(mode.body)->vibrate(mode, mode.energy * translation_);
  }
}

/// The bodies that touch first do so at the best phase within a step; those that vibrate are then as far apart as their
/// vibration reaches.
void RowMotion::place(const std::vector<double>& speeds) {
  std::vector<double> gaps, approaches;
  double before = std::numeric_limits<double>::infinity();
  for (const MadeRow::Joint& joint : row_.joints) {
    const RowSolid& one = *body(joint.one);
    const RowSolid* other = body(joint.other);
    const double met = joint.other < 0 ? 0.0 : speeds[static_cast<std::size_t>(joint.other)];
    const double relative = speeds[static_cast<std::size_t>(joint.one)] - met, unit = row_.units_of(joint).length;
    approaches.push_back((joint.face == Face::right ? relative : -relative) / unit);
    const Face opposite = joint.face == Face::right ? Face::left : Face::right;
    gaps.push_back(joint.gap + one.reach(joint.face) +
                   (other == nullptr ? 0.0 : other->reach(opposite) * other->units().length / unit));
    if (approaches.back() > 0.0) before = std::min(before, joint.gap / approaches.back());
  }
  begin_ = -(1.0 - meetings_.front().first_kick()) * row_.step;
  if (!std::isfinite(before)) before = 0.0;
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    meetings_[k].begin(std::max(0.0, gaps[k] - (before + begin_) * approaches[k]));
  }
}

void RowMotion::respond() {
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    if (sleep_[k].until > 0) continue;
    const MadeRow::Joint& joint = row_.joints[k];
    meetings_[k].respond(*body(joint.one), joint.face, body(joint.other));
  }
  for (std::size_t b = 0; b < solids_.size(); ++b) {
    if (is_awake(b)) solids_[b].respond();
  }
}

void RowMotion::advance(double until) {
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    if (sleep_[k].until > 0 && sleep_[k].until <= now_) wake(k);
  }
  if (sleeps()) {
    constexpr double longest = 1e18;  // steps
    long next = static_cast<long>(std::min(longest, std::ceil((until - begin_) / row_.step)));
    for (const Sleep& each : sleep_) next = std::min(next, each.until);
    now_ = std::max(now_ + 1, next);
    return catch_up();
  }
  for (std::size_t b = 0; b < solids_.size(); ++b) {
    if (is_awake(b)) solids_[b].advance();
  }
  ++now_, ++steps_;
  respond();
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    if (sleep_[k].until > 0) continue;
    meetings_[k].record(time(), row_.step / row_.units_of(row_.joints[k]).time);
    if (now_ >= sleep_[k].next_look) fall_asleep(k);
  }
  wake_pushed();
}

double RowMotion::left_at(std::size_t k) const {
  constexpr double given_back = 0.3;  // of what a vibration could move its bodies by, at most
  const MadeRow::Joint& joint = row_.joints[k];
  const std::array<const RowSolid*, 2> bodies{body(joint.one), body(joint.other)};
  double lightest = std::numeric_limits<double>::infinity(), vibration = 0.0;
  for (const RowSolid* each : bodies) {
    if (each == nullptr) continue;
    lightest = std::min(lightest, each->mass());
    if (each->moves()) vibration += each->vibration();  // other waves run away
  }
  const UnitRatios& units = row_.units_of(joint);
  const double stored = std::max(0.0, energy_unit(units) * meetings_[k].stored());
  const double pushed = units.force * units.time * meetings_[k].force() * joint.duration / lightest;
  return std::max({pushed, std::sqrt(2.0 * stored / lightest), given_back * std::sqrt(2.0 * vibration / lightest)});
}

std::vector<double> RowMotion::open() const {
  std::vector<double> open(solids_.size());
  for (std::size_t k = 0, end = 0; k <= meetings_.size(); ++k) {
    // Bodies from `end` on that may meet in turn.
    const std::size_t begin = end;
    double left = 0.0, lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    const auto add = [&](int number) {
      const double velocity = number < 0 ? 0.0 : body(number)->velocity();
      lowest = std::min(lowest, velocity), highest = std::max(highest, velocity);
    };
    for (; k < meetings_.size(); ++k) {
      const MadeRow::Joint& joint = row_.joints[k];
      const bool clear = sleep_[k].until > 0 ? sleep_[k].until == never
                                             : meetings_[k].is_clear(*body(joint.one), joint.face, body(joint.other));
      end = static_cast<std::size_t>(joint.one) + (joint.face == Face::left ? 0 : 1);
      if (clear) break;
      add(joint.one), add(joint.other);
      left = std::max(left, left_at(k));
    }
    if (k == meetings_.size()) end = solids_.size();
    if (highest < lowest) continue;  // none
    const double its = std::max(highest - lowest, left);
    for (std::size_t b = begin; b < end; ++b) open[b] = its;
  }
  return open;
}

int RowMotion::overflowing() const {
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    if (sleep_[k].until == 0 && meetings_[k].overflows()) return static_cast<int>(k);
  }
  return -1;
}

}  // namespace stoss
