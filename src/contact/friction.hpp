#pragma once

#include <Eigen/Core>
#include <algorithm>
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
  /// @param give       D of each node, none below 0 (edge_compliance_along)
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

/// D of a node in a step, by which it moves along the surface per friction in addition to the compliance between nodes
/// (Friction): what the edge law is along the normal, in the other direction.
///
/// The edge law lets a node carry pressure at a gap, so that its stiffness grows gradually. A node that sticks as soon
/// as it carries pressure would add all of its stiffness at once, an error of first order in the spacing. In a
/// continuous contact a small step along the surface meets the punch that a step along the normal meets, whose
/// compliance is W + diag(−dg/df); with the secant in place of the slope friction under a load of fixed direction is
/// proportional to the pressure at every node and step, as it must be.
/// @param ratio  local softness along the surface over that along the normal
/// @param gap    of the node, exactly 0 where it is rigid; as far as it is open where it carries no pressure
/// @param force  its pressure times its area
[[nodiscard]] inline double edge_compliance_along(double ratio, double gap, double gap_before, double force,
                                                  double force_before) {
  if (!(force > 0.0) || force == force_before) return 0.0;
  return ratio * std::max(0.0, -(gap - gap_before) / (force - force_before));
}

}  // namespace stoss
