// Golub and Welsch: about the middle x = (K−1)/2 of K points the monic discrete Chebyshev polynomials have the
// recurrence p_{k+1} = x p_k − b_k p_{k−1}, b_k = k² (K² − k²)/(4(4k² − 1)).
#include "bodies/sphere/sum_quadrature.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace stoss::bodies::sphere {

SumRule sum_rule(long count, int nodes) {
  SumRule rule;
  if (count <= nodes) {
    rule.node.resize(static_cast<std::size_t>(count));
    std::iota(rule.node.begin(), rule.node.end(), 0.0);
    rule.weight.assign(rule.node.size(), 1.0);
    return rule;
  }
  const auto terms = static_cast<double>(count);
  const double half = 0.5 * terms;
  Eigen::VectorXd side(nodes - 1);  // in units of half the range
  for (int k = 1; k < nodes; ++k) {
    const double square = static_cast<double>(k) * k;
    side(k - 1) = std::sqrt(square * (1.0 - square / (terms * terms)) / (4.0 * square - 1.0));
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::VectorXd::Zero(nodes), side);
  for (int k = 0; k < nodes; ++k) {
    const double first = solver.eigenvectors()(0, k);
    rule.node.push_back(0.5 * (terms - 1.0) + half * solver.eigenvalues()(k));
    rule.weight.push_back(terms * first * first);
  }
  return rule;
}

}  // namespace stoss::bodies::sphere
