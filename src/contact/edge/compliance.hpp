#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cstddef>
#include <vector>

#include "stoss/poll.hpp"

namespace stoss {

/// A symmetric positive definite compliance W = L Lᵀ between nodes, factored once: the Cholesky factor of a leading
/// block of W is the leading block of L, and its inverse that of L⁻¹, so what concerns only the first nodes costs a
/// product with a triangle.
class FactoredCompliance {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// @param matrix W, row-major, size × size
  /// @throws NotConverged if W is not positive definite
  FactoredCompliance(std::vector<double> matrix, std::size_t size, const Poll& poll);

  [[nodiscard]] std::size_t size() const { return size_; }

  /// W
  [[nodiscard]] Eigen::Map<const Matrix> matrix() const;

  /// Fills the first `count` of y with L⁻¹ q; more of y may become void.
  void forward(std::size_t count, const std::vector<double>& q, std::vector<double>& y) const;

  /// Fills the first `count` of f with L⁻ᵀ y, for y that is 0 from `count` on; more of f may become void.
  void backward(std::size_t count, const std::vector<double>& y, std::vector<double>& f) const;

  /// Fills rows begin … size − 1 of W x, for x that is 0 from `count` on.
  void multiply(std::size_t begin, std::size_t count, const std::vector<double>& x, std::vector<double>& result) const;

  /// Fills rows begin … end − 1 of it.
  void multiply(std::size_t begin, std::size_t count, std::size_t end, const std::vector<double>& x,
                std::vector<double>& result) const;

  /// Column j of row i of L, for i − 2 ≤ j ≤ i.
  [[nodiscard]] double lower(std::size_t i, std::size_t j) const { return band_[3 * i + (i - j)]; }

 private:
  std::size_t size_;
  std::vector<double> matrix_;
  std::vector<double> inverse_;             // L⁻¹, row-major
  std::vector<double> inverse_transposed_;  // L⁻ᵀ
  std::vector<double> band_;                // of L: diagonal and two below
};

/// A compliance between nodes that need not be symmetric and changes now and then, as where friction that slides moves
/// what it slides on. Blocks of it are solved many times with little changes: the factors of nodes that stay rigid are
/// kept, and those between them and the others.
class VaryingCompliance {
 public:
  /// Makes it another matrix.
  void assign(Eigen::MatrixXd matrix);

  [[nodiscard]] const Eigen::MatrixXd& matrix() const { return matrix_; }

  /// Solves for the block of some nodes and a diagonal, in place. Nodes with 0 there are rigid.
  /// @return whether it is regular
  [[nodiscard]] bool solve(const std::vector<Eigen::Index>& nodes, const Eigen::VectorXd& diagonal, Eigen::VectorXd& x);

 private:
  void factor(const std::vector<Eigen::Index>& nodes, const std::vector<bool>& rigid);
  void join(const std::vector<Eigen::Index>& edge);

  Eigen::MatrixXd matrix_;
  std::vector<Eigen::Index> rigid_, edge_;           // nodes of the factors, and of the others all so far
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;     // of the former
  Eigen::MatrixXd to_edge_, from_edge_, edge_self_;  // rows of the edge, A_RR⁻¹ A_RE, A_EE − A_ER A_RR⁻¹ A_RE
};

}  // namespace stoss
