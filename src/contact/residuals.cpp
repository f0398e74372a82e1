#include "contact/residuals.hpp"

#include "numeric/kernels.hpp"

namespace stoss {

namespace kernels = numeric::kernels;

Residuals::Residuals(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double step,
                     const Poll& poll) {
  for (const ResidualPart& part : residual_parts(contact, grid, poll)) {
    parts_.emplace_back(part, contact, grid, inertia, step, poll);
  }
  if (parts_.size() == 1) return;
  for (auto* each : {&free_, &first_, &second_}) each->resize(grid.recess.size());
}

std::vector<double> Residuals::compliance() const {
  std::vector<double> sum = parts_.front().compliance();
  if (parts_.size() == 1) return sum;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += parts_.back().compliance()[i];
  return sum;
}

const std::vector<double>& Residuals::predict() {
  const std::vector<double>& first = parts_.front().predict();
  if (parts_.size() == 1) return first;
  const std::vector<double>& second = parts_.back().predict();
  first_ = first;
  for (std::size_t i = 0; i < free_.size(); ++i) free_[i] = first[i] + second[i];
  return free_;
}

void Residuals::move(const std::vector<double>& displacement, const std::vector<double>& force, std::size_t count) {
  if (parts_.size() == 1) return parts_.front().move(displacement, force);
  const std::size_t nodes = displacement.size();
  kernels::multiply_transposed(parts_.front().compliance().data(), nodes, count, 0, nodes, force.data(),
                               second_.data());
  for (std::size_t i = 0; i < nodes; ++i) {
    first_[i] += second_[i];
    second_[i] = displacement[i] - first_[i];
  }
  parts_.front().move(first_, force);
  parts_.back().move(second_, force);
}

std::array<double, 2> Residuals::dissipated() const {
  if (parts_.size() == 1) return {parts_.front().dissipated(), 0.0};
  return {parts_.front().dissipated(), parts_.back().dissipated()};
}

double Residuals::stored() const {
  double sum = 0.0;
  for (const ResidualMotion& part : parts_) sum += part.stored();
  return sum;
}

}  // namespace stoss
