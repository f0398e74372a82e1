#pragma once

namespace stoss::numeric {

/// Free motion of a damped oscillator, Q̈ + 2γ Q̇ + ω²Q = 0, in the coordinates a = √ω Q, b = Q̇/√ω over a time t:
///
///   a(t) = position · a + coupling · b,   b(t) = velocity · b − coupling · a.
///
/// With Ω² = ω² − γ²: position, velocity = e^{−γt} (cos Ωt ± γ sin Ωt/Ω), coupling = e^{−γt} ω sin Ωt/Ω.
struct DampedMotion {
  double position;
  double coupling;
  double velocity;
};

/// Free motion over a time of either sign, for any damping γ ≥ 0: exact to rounding also near γ = ω and for γ ≫ ω. For
/// γ = 0 it is cos ωt, sin ωt, cos ωt.
[[nodiscard]] DampedMotion damped_motion(double omega, double gamma, double time);

/// Share of its static compliance 1/(mω²) by which an oscillator stays back under kicks of period t: kicked by t F/m in
/// Q̇, it is found at Q = t [(1 − M)⁻¹ M]₁₂ F/m at the kicks, with M its free motion between them.
[[nodiscard]] double share_beside_kicks(double omega, double gamma, double time);

/// det(1 − M) of the free motion M over a time.
[[nodiscard]] double determinant(double omega, double gamma, double time);

/// Share of a kick that is still due to the velocity before it where the steady motion under kicks of period t, at rest
/// but for them, has no velocity: (1 − M)⁻¹ again; ½ without damping.
[[nodiscard]] double share_due(double omega, double gamma, double time);

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
