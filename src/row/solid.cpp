// A body of a row: m Ẍ = F_left − F_right, m Q̈ = −m ω² Q − Σ f_i s_i over the points of both faces.
#include "row/solid.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "check.hpp"
#include "contact/residual/residual_part.hpp"
#include "numeric/kernels.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

std::vector<double> transposed(const std::vector<double>& matrix, std::size_t columns) {
  std::vector<double> result(matrix.size());
  const std::size_t rows = matrix.size() / columns;
  for (std::size_t k = 0; k < matrix.size(); ++k) result[k % columns * rows + k / columns] = matrix[k];
  return result;
}

}  // namespace

RowSolid::RowSolid(std::shared_ptr<const Body> body, const UnitRatios& units, const FacePoints& points, double step,
                   double speed)
    : body_(std::move(body)),
      points_(points),
      units_(units),
      step_(step / units.time),
      mass_(whole_mass(*body_) * units.mass),
      energy_(units.mass * units.length * units.length / (units.time * units.time)),
      moves_(!is_unbounded(*body_)),
      center_(mass_, step, speed) {
  const bool both = points[0] && points[1];
  if (both && !body_->opposite_compliance) {
    throw InvalidInput::out_of_range("row", "'" + short_name(*body_) + "' between two others",
                                     "spheres, disks and rods; others at its ends", "it has no opposite face");
  }
  for (std::size_t f = 0; f < 2; ++f) {
    if (!points[f]) continue;
    Side& its = sides_[f];
    its.begin = force_.size(), its.count = points[f]->count;
    for (auto* each : {&its.force, &its.before, &its.across}) each->resize(its.count);
    force_.resize(its.begin + its.count);
  }
  moved_.resize(force_.size());
  Across across;
  if (both) {
    across[0] = body_->opposite_compliance(*points[1], *points[0]);
    across[1] = transposed(across[0], sides_[0].count);
  }
  across_ = std::make_shared<const Across>(std::move(across));
  next_.resize(force_.size());
  constexpr double usual = 0.5;  // steps over 1/cutoff; with shorter ones forces that go on would drive the contact
  const double shorter = step_ * body_->cutoff / usual;
  lag_ = shorter > 0.98 ? 1.0 : shorter;
  if (mode_count(*body_) == 0) return;
  const FaceModes its = face_modes(body_, points);
  groups_ = std::make_shared<const std::vector<ModeGroup>>(its.contact.groups);
  const Kicks kicks = longest_loss_time(*body_) > 0.0 ? Kicks::weaker : Kicks::whole;
  modes_.emplace(its.contact, its.grid, step_, kicks);
  if (is_foreseen())
    looks_ = std::make_shared<const ModeTables>(its.contact, its.grid, static_cast<double>(look) * step_, Kicks::whole);
  if (both && loses(*body_)) begin_creep(its.contact, its.grid, step_);
}

RowSolid RowSolid::alike(double speed) const {
  RowSolid other = *this;
  other.center_ = NormalMotion(mass_, step_ * units_.time, speed);
  return other;
}

bool RowSolid::is_alike(const Body& body, const FacePoints& points) const {
  if (body_.get() != &body) return false;
  for (std::size_t f = 0; f < 2; ++f) {
    const auto &one = points_[f], &other = points[f];
    if (one.has_value() != other.has_value()) return false;
    if (one && (one->radius != other->radius || one->spacing != other->spacing || one->count != other->count)) {
      return false;
    }
  }
  return true;
}

void RowSolid::load(Face face, const std::vector<double>& force, std::size_t count, double sum) {
  Side& its = sides_[static_cast<std::size_t>(face)];
  its.before.swap(its.force);
  std::copy_n(force.begin(), its.count, its.force.begin());
  its.pressed_before = its.pressed;
  its.pressed = count;
  its.sum = sum;
  greatest_ = std::max(greatest_, sum);
}

void RowSolid::respond() {
  center_.load((sides_[1].sum - sides_[0].sum) * units_.force);
  for (std::size_t face = 0; face < 2 && !(*across_)[face].empty(); ++face) {
    creep_.empty() ? add_across(face) : creep_across(face);
  }
  if (!modes_) return;
  std::size_t pressed = 0;  // of all points
  for (const Side& side : sides_) {
    std::copy(side.force.begin(), side.force.end(), force_.begin() + static_cast<std::ptrdiff_t>(side.begin));
    if (side.pressed > 0) pressed = std::max(pressed, side.begin + side.pressed);
  }
  modes_->load(force_, pressed);
}

void RowSolid::vibrate(const Oscillation& mode, double energy) {
  std::size_t k = 0;
  for (std::size_t g = 0; modes_ && g < groups_->size(); ++g) {
    const ModeGroup& group = (*groups_)[g];
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const int index = group.index.empty() ? static_cast<int>(l) : group.index[l];
      if (group.order != mode.order || index != mode.index) continue;
      std::vector<double> place = coordinate(), speed = momentum();
      const double most = std::sqrt(2.0 * body_->mass * energy / energy_);
      place[k] = most / (body_->mass * group.omega[l]) * std::cos(mode.phase);
      speed[k] = -most * std::sin(mode.phase);
      return set(place, speed);
    }
  }
  throw InvalidInput::out_of_range("vibration",
                                   "mode (" + std::to_string(mode.order) + ", " + std::to_string(mode.index) +
                                       ") of body " + std::to_string(mode.body),
                                   "modes that are kept, up to " + shown_most(body_->cutoff) + " c/R of the body");
}

void RowSolid::set(const std::vector<double>& coordinate, const std::vector<double>& momentum) {
  if (!modes_) return;
  modes_->set(coordinate, momentum);
  std::fill(moved_.begin(), moved_.end(), 0.0);
  modes_->add_displacement(moved_);  // where the faces are at first: what moves there in a step is no jump
}

std::vector<double> RowSolid::coordinate() const { return modes_ ? modes_->coordinate() : std::vector<double>{}; }
std::vector<double> RowSolid::momentum() const { return modes_ ? modes_->momentum() : std::vector<double>{}; }

void RowSolid::begin() {
  center_.begin();
  if (modes_) modes_->begin();
}

void RowSolid::advance() {
  if (moves_) center_.advance();
  if (!modes_) return;
  std::fill(moved_.begin(), moved_.end(), 0.0);
  modes_->advance();
  modes_->add_displacement(moved_);
}

bool RowSolid::is_free() const {
  constexpr double nothing = 1e-12;                // of the forces that still follow on the far face
  if (!moves_ && vibration() > 0.0) return false;  // waves run on it
  for (std::size_t face = 0; face < 2; ++face) {
    const Side& its = sides_[face];
    if (its.pressed > 0 || its.pressed_before > 0 || its.sum != 0.0) return false;
    if ((*across_)[face].empty()) continue;
    if (lag_ == 1.0 && creep_.empty() && its.moved_across) return false;
    for (const double each : late_[face]) {
      if (std::abs(each) > nothing * greatest_) return false;
    }
  }
  return true;
}

void RowSolid::fly(long steps) {
  const double time = static_cast<double>(steps) * step_;
  if (moves_) center_.fly(time * units_.time);
  if (modes_) modes_->fly(time);
  for (std::vector<double>& each : late_) std::fill(each.begin(), each.end(), 0.0);
  for (std::size_t face = 0; face < creep_.size(); ++face) {
    CreepAcross& creep = creep_[face];
    creep.stress.fade(time), creep.strain.fade(time);
    creep.crept = creep.strain.crept();
    sides_[face].across = creep.crept;
  }
  if (!modes_) return;
  std::fill(moved_.begin(), moved_.end(), 0.0);
  modes_->add_displacement(moved_);
}

std::optional<KeptModes> RowSolid::in_flight() const {
  return modes_ ? std::optional(modes_->in_flight(looks_)) : std::nullopt;
}

double RowSolid::displacement(Face face, std::size_t point) const {
  const Side& its = side(face);
  return moved_[its.begin + point] - its.across[point];
}

double RowSolid::reach(Face face) const {
  const Side& its = side(face);
  double most = 0.0;
  for (std::size_t i = 0; i < its.count && !creep_.empty(); ++i) most = std::max(most, std::abs(its.across[i]));
  return most + (modes_ ? modes_->reach(its.begin, its.begin + its.count) : 0.0);
}

double RowSolid::dissipated() const {
  const double across = creep_.empty() ? 0.0 : work_across_ - stored_in_creep();
  return ((modes_ ? modes_->dissipated(0, groups_->size()) : 0.0) + across) * energy_;
}

}  // namespace stoss
