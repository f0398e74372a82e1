#pragma once

#include <vector>

#include "relaxation/zeros.hpp"

namespace stoss {

/// A mode of a lossy material, Q̈ + ω² M ∗ Q = 0, as a sum of free motions: after a kick that makes its velocity 1
///
///   Q(t) = x(t) + Σ ρ_k e^(−λ_k t),   ẍ + 2γẋ + w²x = 0,   x(0) = −Σ ρ_k,   ẋ(0) = 1 + Σ ρ_k λ_k
///
/// with −λ_k, one for each term of the relaxation, and the pair −γ ± √(γ² − w²) the zeros of s² + ω² M(s), and ρ_k the
/// residues of its inverse. Two real zeros that nearly coincide are the pair, whose motion has no singularity there.
/// Kelvin and Voigt's mode, M = 1 + ηs, is a pair alone.
struct LossyOscillator {
  double omega = 1.0;  ///< of the elastic mode
  double gamma = 0.0, frequency = 1.0;
  double place = 0.0, velocity = 1.0;  ///< x(0), ẋ(0)
  std::vector<double> rate, residue;   ///< λ_k, ρ_k

  /// Share of a kick that is still due to the velocity before it where the steady motion under kicks of period t, at
  /// rest but for them, has no velocity; ½ without loss.
  [[nodiscard]] double share_due(double time) const;

  /// Displacement that kicks of period t leave out of that by a steady force of 1, 1/(ω² M(0)).
  [[nodiscard]] double missing_beside_kicks(double time) const;

  /// Energy over the mass: ½Q̇² and that of all springs of its Maxwell branches, ½ω² [e∞ Q² + Σ e_j (Q − q_j)²], which
  /// is ½Q̇² − ½Σ c² p/ρ with amplitudes c of the zeros p (docs/developer/derivations/loss.md).
  /// @param moved,speed x and ẋ @param decaying each ρ_k e^(−λ_k t) @param kick that is due in half against Q̇
  [[nodiscard]] double energy(double moved, double speed, const std::vector<double>& decaying, double kick) const;
};

[[nodiscard]] LossyOscillator kelvin_voigt_oscillator(double omega, double loss_time);
[[nodiscard]] LossyOscillator relaxing_oscillator(double omega, const Rates& rates);

}  // namespace stoss
