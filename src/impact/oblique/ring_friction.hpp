#pragma once

#include <Eigen/Core>

namespace stoss {

/// Mean over a ring of the friction along y, over its limit, of a ring that slides outward by R and along y by xR,
///
///   Ψ(x) = ⟨(x + cos φ)/√(1 + 2x cos φ + x²)⟩,
///
/// and dΨ/dx: it rises from x/2 to 1 − 1/4x². To 2e-3, and 1e-4 but near x = 1.
struct RingMean {
  double value, slope;
};
[[nodiscard]] RingMean ring_mean(double x);

/// Coulomb's law in one step between rings that also slide outward: the friction q along y, q = L Ψ(r/R), with the
/// slips r = free − W q − D (q − q_before) along y. It is the one minimum of a convex function, found by Newton's
/// method.
class RingFriction {
 public:
  explicit RingFriction(Eigen::MatrixXd compliance);

  /// @param give  D of each ring
  /// @param free  slip of each ring along y that there would be without friction and D
  /// @param limit L of each ring; 0 where nothing touches
  /// @param reach R of each ring, above 0
  /// @param force in: q of the step before; out: q
  void solve(const Eigen::VectorXd& give, const Eigen::VectorXd& free, const Eigen::VectorXd& limit,
             const Eigen::VectorXd& reach, Eigen::VectorXd& force);

 private:
  double miss(const Eigen::VectorXd& ratio);

  Eigen::MatrixXd compliance_;
  Eigen::VectorXd ratio_;  // r/R, of the last step
  // Of the leading rings that touch.
  Eigen::Index touching_ = 0;
  Eigen::VectorXd start_, limit_, reach_, give_;  // free + D q_before, L, R, D
  Eigen::VectorXd friction_, slope_, left_, trial_, step_;
  Eigen::MatrixXd matrix_;
};

}  // namespace stoss
