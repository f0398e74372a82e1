#pragma once

#include <Eigen/Core>
#include <vector>

#include "impact/oblique/frame.hpp"
#include "impact/oblique/rings/outward_impact.hpp"
#include "impact/oblique/rings/tangential_impact.hpp"

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

/// Rings in a step: how they would slide outward, and what friction may do along y.
struct RingLimits {
  Eigen::VectorXd limit;  ///< L = μp; 0 where nothing touches
  Eigen::VectorXd share;  ///< a of L that friction outward leaves to one that does not slide along y, 0 … 1
  Eigen::VectorXd reach;  ///< R by which a ring slides outward while it hardly slides along y, above 0
  Eigen::VectorXd free;   ///< R∞ by which it would where it slides along y so fast that nothing holds it; 0: as reach
};

/// q/L of a ring at r = `ratio` R, and its slope against that ratio.
[[nodiscard]] RingMean ring_law(const RingLimits& rings, Eigen::Index ring, double ratio);

/// Coulomb's law in one step between rings that also slide outward: the friction q along y,
///
///   q = L max(a Ψ(r/R), Ψ(r/R∞)) for r > 0,
///
/// and the opposite for −r, with the slips r = free − W q − D (q − q_before) along y. q rises with r, so there is one
/// solution, found by Newton's method.
class RingFriction {
 public:
  explicit RingFriction(Eigen::MatrixXd compliance);

  /// @param give  D of each ring
  /// @param free  slip of each ring along y that there would be without friction and D
  /// @param force in: q of the step before; out: q
  void solve(const Eigen::VectorXd& give, const Eigen::VectorXd& free, const RingLimits& rings, Eigen::VectorXd& force);

 private:
  double miss(const RingLimits& rings, const Eigen::VectorXd& ratio);

  Eigen::MatrixXd compliance_;
  Eigen::VectorXd ratio_;  // r/R, of the last step
  // Of the leading rings that touch.
  Eigen::Index touching_ = 0;
  Eigen::VectorXd start_, give_;  // free + D q_before, D
  Eigen::VectorXd friction_, slope_, left_, trial_, step_;
  Eigen::MatrixXd matrix_;
};

/// The motion along the surface of balls whose rings also slide outward as in an outward impact: Coulomb's law
/// averaged over each ring (RingFriction). What friction along y takes from that outward is left out, and what it does
/// to the pressure; so is then what friction outward does to it, as stuck surfaces are stiffer in both directions
/// alike.
/// @param steps   of the outward impact without friction, for the pressures
/// @param outward those with this friction, for what it takes and where rings slide; null: friction has one direction
///                on all of a ring
/// @returns v_t′ and Ω′ after the impact
[[nodiscard]] AlongOutcome slide_on_rings(const TangentialResponse& response, const ObliqueFrame& frame,
                                          const std::vector<OutwardStep>& steps,
                                          const std::vector<OutwardStep>* outward, const Obliquity& before,
                                          const Poll& poll);

}  // namespace stoss
