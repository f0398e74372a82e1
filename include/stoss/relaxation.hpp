#pragma once

#include <complex>
#include <vector>

#include "stoss/cxx20.hpp"

namespace stoss {

/// A part of the instantaneous modulus that relaxes: E_j e^(−t/τ_j).
struct RelaxationTerm {
  double share = 0.0;  ///< E_j/E(0)
  double time = 0.0;   ///< τ_j, in the unit of time of what has it

  bool operator==(const RelaxationTerm&) const = default;
};

/// Relaxation of all moduli of a material by one Prony series.
///
///   E(t) = E∞ + Σ E_j e^(−t/τ_j),   E(0) = E∞ + Σ E_j,   M(s) = [E∞ + Σ E_j sτ_j/(1 + sτ_j)]/E(0)
///
/// Poisson's ratio stays constant, so an elastic body of the modulus E(0) keeps its eigenmodes: ω² becomes ω²M(s), and
/// a static compliance W becomes W/M(s) (docs/theory/loss.md). Without terms the material is elastic.
struct Relaxation {
  std::vector<RelaxationTerm> terms{};

  /// E∞/E(0) = 1 − Σ shares, 0 at least.
  [[nodiscard]] double relaxed() const;

  bool operator==(const Relaxation&) const = default;
};

/// How a material loses energy: by one of both, or not at all.
struct MaterialLoss {
  double loss_time = 0.0;   ///< η: stress = (1 + η ∂/∂t) elastic stress, in the unit of time of what has it
  Relaxation relaxation{};  ///< times in that unit

  bool operator==(const MaterialLoss&) const = default;
};

/// Terms that a material may have.
inline constexpr std::size_t most_relaxation_terms = 20;

/// Checks shares above 0 with a sum of at most 1, and finite times above 0. @throws InvalidInput
void validate(const Relaxation& relaxation);

/// Checks a relaxation or a loss time, finite and of 0 or more, but not both. @throws InvalidInput
void validate(const MaterialLoss& loss);

/// M(s); at s = iω its real part is E′/E(0), its imaginary part E″/E(0). @param s in 1/(unit of time)
[[nodiscard]] std::complex<double> modulus(const Relaxation& relaxation, std::complex<double> s);

/// 1 + ηs or M(s).
[[nodiscard]] std::complex<double> modulus(const MaterialLoss& loss, std::complex<double> s);

/// E(t)/E(0), the stress under a constant strain.
[[nodiscard]] double modulus_after(const Relaxation& relaxation, double time);

/// The same in another unit of time, in which all times are `factor` times as large.
[[nodiscard]] Relaxation in_time(const Relaxation& relaxation, double factor);
[[nodiscard]] MaterialLoss in_time(const MaterialLoss& loss, double factor);

}  // namespace stoss
