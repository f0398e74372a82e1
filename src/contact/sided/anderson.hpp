#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace stoss {

/// Anderson's acceleration of a fixed-point iteration x ← x + miss(x): the next trial is the combination of the last
/// ones whose misses, taken for linear, are least (Anderson, J. ACM 12, 547, 1965).
class Anderson {
 public:
  explicit Anderson(std::size_t memory) : memory_(memory) {}

  /// Forgets what was tried, as when the function changes.
  void forget();

  /// @param share of the miss by which it moves while little is known
  [[nodiscard]] Eigen::VectorXd next(const Eigen::VectorXd& tried, const Eigen::VectorXd& miss, double share = 1.0);

 private:
  std::size_t memory_;
  std::vector<Eigen::VectorXd> tried_, misses_;
};

}  // namespace stoss
