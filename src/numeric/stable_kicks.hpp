#pragma once

namespace stoss::numeric {

/// Kicks of period t under which an oscillator answers a force passively, however stiff what shares its displacement.
///
/// Under a force F e^{iθk} the kicks t F/m in Q̇ move it, at the kicks, by K(θ) F/(mω²), which is real at θ = π and
/// below 0 there: with less compliance than −K(π) beside it, a contact grows from step to step. With that much more,
/// which follows the force at once, it takes no energy out of nothing at any θ, and the sum is too soft by K(0) −
/// K(π) instead of 1. So force and displacement both count √strength times, strength = 1/(K(0) − K(π)), sin ωt/ωt
/// without damping; and γ/strength in place of γ leaves what a slow force dissipates, too, as it is.
struct StableKicks {
  double gamma;     ///< with which the oscillator moves in place of γ
  double strength;  ///< of the kicks in the motion that they cause
  double at_once;   ///< share of the static compliance 1/(mω²) that follows the force at once, −K(π) · strength
};

/// @param time below π/ω
[[nodiscard]] StableKicks stable_kicks(double omega, double gamma, double time);

}  // namespace stoss::numeric
