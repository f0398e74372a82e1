#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace stoss {

/// Coulomb's law in one step, between nodes of the compliance W: the friction q, each |q| ≤ limit, with which the slips
///
///   r = free − W q − D (q − q_before)
///
/// have the sign of q where |q| = limit, and vanish elsewhere. It is the only minimum of a convex function in a box, by
/// its active set: exact, and with the states of the step before nearly always found at once. Where states come back,
/// Murty's rule of the least index ends the search (Murty, Linear Algebra Appl. 9, 65, 1974).
///
/// Friction that acts against +y is positive, as pressure that acts against +x.
class Friction {
 public:
  explicit Friction(std::size_t nodes);

  /// @param compliance W, nodes × nodes, symmetric positive definite
  /// @param give       D of each node, none below 0 (landing.hpp)
  /// @param free       slip of each node that there would be without friction and D
  /// @param limit      largest friction of each node, μ p: `nodes` values; 0 where nothing touches
  /// @param force      in: q of the step before; out: q
  /// @throws NotConverged if no states are found
  void solve(const std::vector<double>& compliance, const std::vector<double>& give, const std::vector<double>& free,
             const double* limit, std::vector<double>& force);

  /// Of the last solution: 0 stuck or free, ±1 sliding under a friction of this sign.
  [[nodiscard]] const std::vector<int>& sliding() const { return sliding_; }

 private:
  void begin(const std::vector<double>& give, const std::vector<double>& free, const double* limit,
             const std::vector<double>& force);
  void hold_stuck(const std::vector<double>& compliance, const std::vector<double>& give);
  void move_sliding(const std::vector<double>& compliance, const std::vector<double>& give);
  bool revise(const double* limit, bool one);

  std::vector<int> sliding_;
  std::vector<std::size_t> touching_, stuck_;  // nodes
  double scale_ = 0.0;                         // of the slips
  std::vector<double> start_, slip_, trial_;   // free + D q_before, r, q
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd held_;
};

}  // namespace stoss
