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
RowSolid::RowSolid(std::shared_ptr<const Body> body, const UnitRatios& units, const FacePoints& points, double step,
                   double speed)
    : body_(std::move(body)),
      units_(units),
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
  if (both)
    across_ = {body_->opposite_compliance(*points[1], *points[0]), body_->opposite_compliance(*points[0], *points[1])};
  next_.resize(force_.size());
  constexpr double usual = 0.5;  // steps over 1/cutoff
  const double shorter = step / units.time * body_->cutoff / usual;
  lag_ = shorter > 0.5 ? 1.0 : shorter;
  if (mode_count(*body_) == 0) return;
  const FaceModes its = face_modes(body_, points);
  groups_ = its.contact.groups;
  const Kicks kicks = longest_loss_time(*body_) > 0.0 ? Kicks::weaker : Kicks::whole;
  modes_.emplace(its.contact, its.grid, step / units.time, kicks);
  if (both && loses(*body_)) begin_creep(its.contact, its.grid, step / units.time);
}

void RowSolid::begin_creep(const Contact& contact, const ContactGrid& grid, double step) {
  const auto points = static_cast<Eigen::Index>(force_.size());
  Eigen::MatrixXd beside = Eigen::MatrixXd::Zero(points, points);
  add_kick_compliance(contact, grid, step, {}, beside);
  const Creep its = creep_of(*body_, 1.0);
  for (std::size_t face = 0; face < 2; ++face) {
    const Side &here = sides_[face], &there = sides_[1 - face];
    CreepAcross& made = creep_.emplace_back(
        CreepAcross{{its, step, there.count}, {its, step, here.count}, {}, std::vector<double>(here.count)});
    for (std::size_t j = there.begin; j < there.begin + there.count; ++j) {
      for (std::size_t i = here.begin; i < here.begin + here.count; ++i) {
        made.at_once.push_back(beside(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
  }
}

void RowSolid::load(Face face, const std::vector<double>& force, std::size_t count, double sum) {
  Side& its = sides_[static_cast<std::size_t>(face)];
  its.before.swap(its.force);
  std::copy_n(force.begin(), its.count, its.force.begin());
  its.pressed_before = its.pressed;
  its.pressed = count;
  its.sum = sum;
}

void RowSolid::add_across(std::size_t face) {
  Side& its = sides_[face];
  const Side& other = sides_[1 - face];
  std::size_t pressed = std::max(other.pressed, other.pressed_before);
  if (pressed == 0 && !its.moved_across) return;
  for (std::size_t j = 0; j < pressed; ++j) next_[j] = 2.0 * other.force[j] - other.before[j];
  if (lag_ < 1.0) {
    pressed = other.count;
    std::vector<double>& late = late_[face];
    late.resize(pressed);
    for (std::size_t j = 0; j < pressed; ++j) {
      late[j] += lag_ * (other.force[j] - late[j]);
      next_[j] = late[j];
    }
  }
  numeric::kernels::multiply_transposed(across_[face].data(), its.count, pressed, 0, its.count, next_.data(),
                                        its.across.data());
  its.moved_across = pressed > 0;
}

void RowSolid::creep_across(std::size_t face) {
  Side& its = sides_[face];
  const Side& other = sides_[1 - face];
  CreepAcross& creep = creep_[face];
  const auto multiply = [&](const std::vector<double>& matrix, const std::vector<double>& force) {
    numeric::kernels::multiply_transposed(matrix.data(), its.count, other.count, 0, its.count, force.data(),
                                          its.across.data());
  };
  multiply(across_[face], other.force);
  creep.stress.take(other.force), creep.strain.take(its.across);
  const std::vector<double> crept = creep.strain.crept();
  for (std::size_t i = 0; i < its.count; ++i) {
    work_across_ += 0.5 * (its.force[i] + its.before[i]) * (crept[i] - creep.crept[i]);
  }
  creep.crept = crept;
  for (std::size_t j = 0; j < other.count; ++j) next_[j] = 2.0 * other.force[j] - other.before[j];
  multiply(creep.at_once, next_);
  const std::vector<double> follows = its.across;
  const std::vector<double>& remembered = creep.stress.predict();
  late_[face].resize(other.count);
  for (std::size_t j = 0; j < other.count; ++j) {
    late_[face][j] += lag_ * ((lag_ < 1.0 ? other.force[j] : next_[j]) - late_[face][j]);
    next_[j] = creep.stress.share() * late_[face][j] + remembered[j];
  }
  multiply(across_[face], next_);
  numeric::kernels::add(its.across.data(), follows.data(), its.count, its.across.data());
}

void RowSolid::respond() {
  center_.load((sides_[1].sum - sides_[0].sum) * units_.force);
  for (std::size_t face = 0; face < 2 && !across_[face].empty(); ++face) {
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
  for (const ModeGroup& group : groups_) {
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

double RowSolid::displacement(Face face, std::size_t point) const {
  const Side& its = side(face);
  return moved_[its.begin + point] - its.across[point];
}

double RowSolid::reach(Face face) const {
  return modes_ ? modes_->reach(side(face).begin, side(face).begin + side(face).count) : 0.0;
}

double RowSolid::dissipated() const {
  const double across = creep_.empty() ? 0.0 : work_across_ - stored_in_creep();
  return ((modes_ ? modes_->dissipated(0, groups_.size()) : 0.0) + across) * energy_;
}

// Of each face half: the springs under the stress here by what the force there strains.
double RowSolid::stored_in_creep() const {
  return creep_[0].strain.energy(creep_[1].stress) + creep_[1].strain.energy(creep_[0].stress);
}

double RowSolid::stored_across() const {
  double sum = 0.0;
  const std::vector<double>& across = creep_.empty() ? across_[1] : creep_[1].at_once;
  for (std::size_t i = 0, at = 0; i < sides_[0].count && !across.empty(); ++i) {
    for (std::size_t j = 0; j < sides_[1].count; ++j, ++at) {
      sum += sides_[0].force[i] * across[at] * sides_[1].force[j];
    }
  }
  return (sum + (creep_.empty() ? 0.0 : stored_in_creep())) * energy_;
}

}  // namespace stoss
