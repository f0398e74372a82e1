#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "stoss/poll.hpp"

/// Dense linear algebra in blocks of columns, with a poll between them: a matrix of 4096 rows takes seconds.
namespace stoss::numeric::dense {

/// Calls work(first, count) for one block of columns after the other.
template <typename Work>
void by_columns(Eigen::Index columns, const Poll& poll, const Work& work) {
  constexpr Eigen::Index width = 32;
  for (Eigen::Index first = 0; first < columns; first += width) {
    if (poll) poll();
    work(first, std::min(width, columns - first));
  }
}

/// So many zeros, made in blocks too: memory that is touched first costs more than arithmetic on it.
[[nodiscard]] std::vector<double> zeros(std::size_t size, const Poll& poll);

/// These values once more, in the same blocks.
[[nodiscard]] std::vector<double> copy(const std::vector<double>& values, const Poll& poll);

/// The square matrix of these values, by columns.
[[nodiscard]] Eigen::MatrixXd square(const double* values, Eigen::Index size, const Poll& poll);

/// Cholesky factorization A = L Lᵀ, in place: only the lower triangle is read and written.
/// @return whether A is positive definite; if not, the matrix is void
[[nodiscard]] bool factor(Eigen::Ref<Eigen::MatrixXd> matrix, const Poll& poll);

/// Fills `inverse` with L⁻¹ of the lower triangle L, and zeros above.
void invert_lower(const Eigen::MatrixXd& lower, Eigen::Ref<Eigen::MatrixXd> inverse, const Poll& poll);

/// Overwrites B with A⁻¹B = L⁻ᵀL⁻¹B.
void solve(const Eigen::MatrixXd& lower, Eigen::MatrixXd& right, const Poll& poll);

}  // namespace stoss::numeric::dense

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
