#include "row/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Units of a joint in those of the first body of the row.
const UnitRatios& units_of(const MadeRow& row, const MadeRow::Joint& joint) {
  return row.units[static_cast<std::size_t>(joint.one)];
}

double energy_unit(const UnitRatios& units) { return units.force * units.length; }

double sum(const RowEnergy& its) {
  return its.translation + its.vibration + its.contact + its.unresolved + its.dissipated + its.yielded;
}

}  // namespace

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
  for (std::size_t b = 0; b < row.bodies.size(); ++b) {
    solids_.emplace_back(row.bodies[b], row.units[b], points[b], row.step, speeds[b]);
    translation_ += solids_[b].translation();
  }
  vibrate(start);
  place(speeds);
  displacement_.resize(solids_.size()), velocity_.resize(solids_.size()), force_.resize(meetings_.size());
  respond();
  for (RowSolid& solid : solids_) solid.begin();
  whole_ = sum(in_units());
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
    const double relative = speeds[static_cast<std::size_t>(joint.one)] - met, unit = units_of(row_, joint).length;
    approaches.push_back((joint.face == Face::right ? relative : -relative) / unit);
    const Face opposite = joint.face == Face::right ? Face::left : Face::right;
    gaps.push_back(joint.gap + one.reach(joint.face) +
                   (other == nullptr ? 0.0 : other->reach(opposite) * other->units().length / unit));
    if (approaches.back() > 0.0) before = std::min(before, joint.gap / approaches.back());
  }
  time_ = -(1.0 - meetings_.front().first_kick()) * row_.step;
  if (!std::isfinite(before)) before = 0.0;
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    meetings_[k].begin(std::max(0.0, gaps[k] - (before + time_) * approaches[k]));
  }
}

void RowMotion::respond() {
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    const MadeRow::Joint& joint = row_.joints[k];
    meetings_[k].respond(*body(joint.one), joint.face, body(joint.other));
  }
  for (RowSolid& solid : solids_) solid.respond();
}

void RowMotion::advance() {
  for (RowSolid& solid : solids_) solid.advance();
  respond();
  time_ += row_.step;
  ++steps_;
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    meetings_[k].record(time_, row_.step / units_of(row_, row_.joints[k]).time);
  }
}

double RowMotion::left_at(std::size_t k) const {
  constexpr double given_back = 0.3;  // of what a vibration could move its bodies by, at most
  const MadeRow::Joint& joint = row_.joints[k];
  const RowSolid* bodies[] = {body(joint.one), body(joint.other)};
  double lightest = std::numeric_limits<double>::infinity(), vibration = 0.0;
  for (const RowSolid* each : bodies) {
    if (each == nullptr) continue;
    lightest = std::min(lightest, each->mass());
    if (each->moves()) vibration += each->vibration();  // other waves run away
  }
  const UnitRatios& units = units_of(row_, joint);
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
      const bool clear = meetings_[k].is_clear(*body(joint.one), joint.face, body(joint.other));
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
    if (meetings_[k].overflows()) return static_cast<int>(k);
  }
  return -1;
}

double RowMotion::momentum() const {
  double sum = 0.0;
  for (const RowSolid& solid : solids_) sum += std::isfinite(solid.mass()) ? solid.mass() * solid.velocity() : 0.0;
  return sum;
}

RowEnergy RowMotion::in_units() const {
  RowEnergy its;
  for (const RowSolid& solid : solids_) {
    its.translation += solid.translation();
    its.vibration += solid.vibration();
    its.dissipated += solid.dissipated();
    its.contact += solid.stored_across();
  }
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    const double unit = energy_unit(units_of(row_, row_.joints[k]));
    its.contact += unit * meetings_[k].stored();
    its.unresolved += unit * meetings_[k].unresolved();
    its.dissipated += unit * meetings_[k].dissipated();
    its.yielded += unit * meetings_[k].yielded();
  }
  return its;
}

RowEnergy RowMotion::energy() const {
  RowEnergy its = in_units();
  for (double* each : {&its.translation, &its.vibration, &its.contact, &its.unresolved, &its.dissipated, &its.yielded})
    *each /= translation_;
  return its;
}

RowImpact RowMotion::result() const {
  RowImpact made;
  made.step = row_.step;
  made.steps = steps_;
  made.time = time_;
  const double mass = solids_.front().mass();
  double of_walls = 0.0;
  for (const RowSolid& solid : solids_) made.velocities_after.push_back(solid.velocity());
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    const MadeRow::Joint& joint = row_.joints[k];
    const UnitRatios& units = units_of(row_, joint);
    const Meeting& its = meetings_[k];
    const double impulse = its.impulse * units.force * units.time;
    made.strain = std::max(made.strain, its.strain());
    const bool stands = joint.other < 0 || !std::isfinite(body(joint.other)->mass());
    if (stands) of_walls += joint.face == Face::right ? -impulse : impulse;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    made.contacts.push_back({joint.face == Face::left ? -1 : joint.one, its.touches > 0 ? its.first_touch : none,
                             its.touches > 0 ? its.last_touch : none, its.touches,
                             its.greatest_force * units.force / mass, impulse / mass,
                             its.greatest_compression * units.length});
  }
  made.energy = energy();
  made.energy_error = sum(made.energy) - whole_ / translation_;
  made.momentum_error = (momentum() - momentum_ - of_walls) / (mass * row_.fastest);
  for (const RowSolid& solid : solids_) {
    made.after.coordinate.push_back(solid.coordinate());
    made.after.momentum.push_back(solid.momentum());
  }
  made.open = open();
  std::size_t modes = 0;
  for (const auto& each : row_.bodies) modes += mode_count(*each);
  constexpr double of_a_contact = 600.0;  // modes
  made.work =
      static_cast<double>(steps_) * (static_cast<double>(modes) + of_a_contact * static_cast<double>(meetings_.size()));
  return made;
}

void RowMotion::observe(const RowWatch& watch) {
  if (!watch.observer) return;
  for (std::size_t b = 0; b < solids_.size(); ++b) {
    displacement_[b] = solids_[b].position();
    velocity_[b] = solids_[b].velocity();
  }
  const double mass = solids_.front().mass();
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    force_[k] = meetings_[k].force() * units_of(row_, row_.joints[k]).force / mass;
  }
  watch.observer({time_, displacement_, velocity_, force_, energy()});
}

}  // namespace stoss
