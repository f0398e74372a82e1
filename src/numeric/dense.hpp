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
