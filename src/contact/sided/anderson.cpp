#include "contact/sided/anderson.hpp"

#include <Eigen/QR>

namespace stoss {

void Anderson::forget() {
  tried_.clear();
  misses_.clear();
}

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& tried, const Eigen::VectorXd& miss, double share) {
  constexpr std::size_t enough = 3;
  if (tried_.size() == memory_) {
    tried_.erase(tried_.begin());
    misses_.erase(misses_.begin());
  }
  tried_.push_back(tried);
  misses_.push_back(miss);
  if (tried_.size() < enough) return tried + share * miss;
  const auto columns = static_cast<Eigen::Index>(tried_.size()) - 1;
  Eigen::MatrixXd step(miss.size(), columns), change(miss.size(), columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    const auto k = static_cast<std::size_t>(j);
    step.col(j) = tried_[k + 1] - tried_[k];
    change.col(j) = misses_[k + 1] - misses_[k];
  }
  return tried + miss - (step + change) * change.colPivHouseholderQr().solve(miss);
}

}  // namespace stoss
