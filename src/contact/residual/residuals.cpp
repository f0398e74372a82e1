#include "contact/residual/residuals.hpp"

#include <algorithm>
#include <utility>

#include "contact/residual/residual_part.hpp"
#include "numeric/dense.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

namespace kernels = numeric::kernels;

namespace {

void add(const std::vector<double>& values, std::vector<double>& sum) {
  for (std::size_t i = 0; i < values.size(); ++i) sum[i] += values[i];
}

}  // namespace

Residuals::Residuals(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double step,
                     const Poll& poll)
    : lossy_(loses(contact)) {
  for (ResidualPart& part : residual_parts(contact, grid, poll)) {
    bodies_.push_back(part.body);
    parts_.emplace_back(std::move(part), contact, grid, inertia, step, poll);
  }
  for (ResidualPart& coat : coats(contact, grid)) {
    bodies_.push_back(coat.body);
    ++coats_;
    parts_.emplace_back(std::move(coat), contact, grid, ResidualMotion::Inertia::none, step, poll);
  }
  joined_ = parts_.size() == 1 && !lossy_;
  if (joined_) return;
  const std::size_t nodes = grid.recess.size();
  free_.resize(nodes);
  displacement_.resize(parts_.size(), std::vector<double>(nodes));
  if (!lossy_ || inertia == ResidualMotion::Inertia::none) return;
  const auto size = static_cast<Eigen::Index>(nodes);
  kicks_ = numeric::dense::zeros(nodes * nodes, poll);
  add_kick_compliance(contact, grid, step, poll, Eigen::MatrixXd::Map(kicks_.data(), size, size));
}

std::vector<double> Residuals::compliance(const Poll& poll) const {
  std::vector<double> sum = numeric::dense::copy(parts_.front().compliance(), poll);
  for (std::size_t k = 1; k < parts_.size(); ++k) add(parts_[k].compliance(), sum);
  if (!kicks_.empty()) add(kicks_, sum);
  return sum;
}

const std::vector<double>& Residuals::predict() {
  if (joined_) return parts_.front().predict();
  std::fill(free_.begin(), free_.end(), 0.0);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    displacement_[k] = parts_[k].predict();
    for (std::size_t i = 0; i < free_.size(); ++i) free_[i] += displacement_[k][i];
  }
  return free_;
}

void Residuals::move(const std::vector<double>& displacement, const std::vector<double>& force, std::size_t count) {
  if (joined_) return parts_.front().move(displacement, force);
  const std::size_t nodes = displacement.size();
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    kernels::multiply_transposed(parts_[k].compliance().data(), nodes, count, 0, nodes, force.data(), free_.data());
    for (std::size_t i = 0; i < nodes; ++i) displacement_[k][i] += free_[i];
    parts_[k].move(displacement_[k], force);
  }
}

bool Residuals::is_still(const std::vector<double>& displacement, double negligible) const {
  if (joined_) return parts_.front().is_still(displacement, negligible);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    if (!parts_[k].is_still(displacement_[k], negligible)) return false;
  }
  return true;
}

void Residuals::rest(double time) {
  for (ResidualMotion& each : parts_) each.rest(time);
}

std::vector<double> Residuals::crept_force(std::size_t body) const {
  for (std::size_t k = 0; lossy_ && k + coats_ < parts_.size(); ++k) {
    if (bodies_[k] == body) return parts_[k].crept_force();
  }
  return {};
}

std::array<double, 2> Residuals::dissipated() const {
  std::array<double, 2> each{};
  for (std::size_t k = 0; k < parts_.size(); ++k) each[bodies_[k]] += parts_[k].dissipated();
  return each;
}

std::array<double, 2> Residuals::stored() const {
  std::array<double, 2> each{};
  for (std::size_t k = 0; k < parts_.size(); ++k) each[bodies_[k]] += parts_[k].stored();
  return each;
}

}  // namespace stoss
