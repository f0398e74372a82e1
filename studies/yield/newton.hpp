#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "body.hpp"

namespace yield_study {

/// Newton's iteration for a Body whose unknowns are partly prescribed.
class Newton {
 public:
  explicit Newton(Body& body);

  /// One iteration: the unknowns that are prescribed jump to their values, the others follow by the tangent.
  /// The body was assembled at `unknowns`; afterwards it is assembled at the new ones.
  /// @param prescribed 1 where an unknown is prescribed
  /// @param values of the unknowns, used where they are prescribed
  void step(Eigen::VectorXd& unknowns, const std::vector<char>& prescribed, const Eigen::VectorXd& values,
            const Eigen::VectorXd& external);

  /// |internal − external| over the unknowns that are not prescribed, over the sum of |internal| over those that are
  /// and |external|.
  [[nodiscard]] double imbalance(const std::vector<char>& prescribed, const Eigen::VectorXd& external) const;

 private:
  Body& body_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver_;
};

/// Iterates until the imbalance is below `tolerance`, and keeps the state.
/// @throws std::runtime_error where it does not converge
void solve(Body& body, Newton& newton, Eigen::VectorXd& unknowns, const std::vector<char>& prescribed,
           const Eigen::VectorXd& values, const Eigen::VectorXd& external, double tolerance = 1e-9);

}  // namespace yield_study
