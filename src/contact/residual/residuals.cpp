#include "contact/residual/residuals.hpp"

#include <algorithm>

#include "contact/residual/kick_compliance.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

namespace kernels = numeric::kernels;

Residuals::Residuals(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double step,
                     const Poll& poll)
    : lossy_(longest_loss_time(contact) > 0.0) {
  for (const ResidualPart& part : residual_parts(contact, grid, poll)) {
    parts_.emplace_back(part, contact, grid, inertia, step, poll);
    bodies_.push_back(part.body);
  }
  if (!lossy_) return;
  const std::size_t nodes = grid.recess.size();
  free_.resize(nodes);
  displacement_.resize(parts_.size(), std::vector<double>(nodes));
  const auto size = static_cast<Eigen::Index>(nodes);
  Eigen::MatrixXd kicks = Eigen::MatrixXd::Zero(size, size);
  if (inertia == ResidualMotion::Inertia::all) add_kick_compliance(contact, grid, step, poll, kicks);
  kicks_.assign(kicks.data(), kicks.data() + kicks.size());
}

std::vector<double> Residuals::compliance() const {
  std::vector<double> sum = parts_.front().compliance();
  if (!lossy_) return sum;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (parts_.size() > 1) sum[i] += parts_.back().compliance()[i];
    sum[i] += kicks_[i];
  }
  return sum;
}

const std::vector<double>& Residuals::predict() {
  if (!lossy_) return parts_.front().predict();
  std::fill(free_.begin(), free_.end(), 0.0);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    displacement_[k] = parts_[k].predict();
    for (std::size_t i = 0; i < free_.size(); ++i) free_[i] += displacement_[k][i];
  }
  return free_;
}

void Residuals::move(const std::vector<double>& displacement, const std::vector<double>& force, std::size_t count) {
  if (!lossy_) return parts_.front().move(displacement, force);
  const std::size_t nodes = displacement.size();
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    kernels::multiply_transposed(parts_[k].compliance().data(), nodes, count, 0, nodes, force.data(), free_.data());
    for (std::size_t i = 0; i < nodes; ++i) displacement_[k][i] += free_[i];
    parts_[k].move(displacement_[k], force);
  }
}

std::array<double, 2> Residuals::dissipated() const {
  std::array<double, 2> each{};
  for (std::size_t k = 0; k < parts_.size(); ++k) each[bodies_[k]] = parts_[k].dissipated();
  return each;
}

double Residuals::stored() const {
  double sum = 0.0;
  for (const ResidualMotion& part : parts_) sum += part.stored();
  return sum;
}

}  // namespace stoss
