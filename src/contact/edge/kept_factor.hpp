#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contact/edge/compliance.hpp"

namespace stoss {

/// The factor of W + diag(d) = L Lᵀ for the first nodes, with the compliance W symmetric and positive definite, and its
/// inverse M = L⁻¹, row by row. Rows are kept while d changes little, and given up from the first on that does not; of
/// the nodes behind them there is what is left of W, which does not depend on their own d: S = W_bb − L_bk L_bkᵀ.
class KeptFactor {
 public:
  explicit KeptFactor(std::shared_ptr<const FactoredCompliance> compliance);

  /// Number of nodes whose rows are kept.
  [[nodiscard]] std::size_t kept() const { return kept_; }

  /// d of one of them when its row was made, and what the nodes before it leave of its own compliance.
  [[nodiscard]] const std::vector<double>& diagonal() const { return diagonal_; }
  [[nodiscard]] const std::vector<double>& left() const { return left_; }

  /// Gives up rows from `count` on.
  void give_up(std::size_t count);

  /// Adds the next node. @return whether the matrix is positive definite with it
  [[nodiscard]] bool add(double diagonal);

  /// Fills S of the nodes from the kept ones up to `end`, lower triangle, row-major without gaps.
  void remainder(std::size_t end, std::vector<double>& matrix);

  /// Of x, y becomes M x on the kept nodes and x − L_bk M x on those up to `end`; more of it may become void.
  void forward(std::size_t end, const std::vector<double>& x, std::vector<double>& y) const;

  /// Of y, x becomes Mᵀ (y_k − L_bkᵀ x_b) on the kept nodes, for x_b on those up to `end`; y becomes void.
  void backward(std::size_t end, std::vector<double>& y, std::vector<double>& x) const;

 private:
  void extend(std::size_t i);

  std::shared_ptr<const FactoredCompliance> compliance_;
  std::size_t size_, stride_, kept_ = 0;
  std::vector<double> lower_;                         // L, row-major
  std::vector<double> inverse_, inverse_transposed_;  // M, row-major, and Mᵀ
  std::vector<std::size_t> known_;                    // columns of each row of L
  std::vector<double> diagonal_, left_, row_;
};

}  // namespace stoss
