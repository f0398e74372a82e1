// What the modes of a body that are not kept do from one face to the other: u = W_x f, of materials that lose J(s) W_x
// f.
#include <algorithm>

#include "contact/residual/residual_part.hpp"
#include "numeric/kernels.hpp"
#include "row/solid.hpp"

namespace stoss {

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
  numeric::kernels::multiply_transposed((*across_)[face].data(), its.count, pressed, 0, its.count, next_.data(),
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
  multiply((*across_)[face], other.force);
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
  multiply((*across_)[face], next_);
  numeric::kernels::add(its.across.data(), follows.data(), its.count, its.across.data());
}

// Of each face half: the springs under the stress here by what the force there strains.
double RowSolid::stored_in_creep() const {
  return creep_[0].strain.energy(creep_[1].stress) + creep_[1].strain.energy(creep_[0].stress);
}

double RowSolid::stored_across() const {
  double sum = 0.0;
  const std::vector<double>& across = creep_.empty() ? (*across_)[1] : creep_[1].at_once;
  for (std::size_t i = 0, at = 0; i < sides_[0].count && !across.empty(); ++i) {
    for (std::size_t j = 0; j < sides_[1].count; ++j, ++at) {
      sum += sides_[0].force[i] * across[at] * sides_[1].force[j];
    }
  }
  return (sum + (creep_.empty() ? 0.0 : stored_in_creep())) * energy_;
}

}  // namespace stoss
