#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "stoss/poll.hpp"

namespace stoss::numeric {

/// Σ s lᵀ over rows s and l whose sum is symmetric, such as l = weight · s: only the lower triangle is computed, many
/// rows at a time.
class SymmetricProducts {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Row = Eigen::Map<Eigen::RowVectorXd>;

  /// @param poll is called between the products; it must live as long as the sum
  SymmetricProducts(std::size_t size, const Poll& poll);

  /// Begins one more pair of rows, s and l, which are to be filled.
  void start();
  [[nodiscard]] Row shape() { return {shape_.data() + (rows_ - 1) * stride_, size()}; }
  [[nodiscard]] Row load() { return {load_.data() + (rows_ - 1) * stride_, size()}; }

  /// The whole sum so far.
  [[nodiscard]] Matrix sum();

 private:
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(size_); }
  void flush();

  std::size_t size_;
  std::size_t stride_;  // whole vectors; what is beyond the size stays 0
  std::size_t rows_ = 0;
  std::vector<double> shape_, load_, sum_;
  const Poll& poll_;
};

}  // namespace stoss::numeric
