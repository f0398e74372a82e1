#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

namespace stoss {

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
