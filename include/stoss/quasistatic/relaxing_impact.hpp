#pragma once

#include <array>

#include "stoss/relaxation.hpp"

/// Impact of round bodies of materials that relax, where nothing but the contact dissipates.
///
/// Hertz' contact is a row of independent springs of the elongation δ − x²/R. Each has the memory of both materials,
/// 1/E*(s) = Σ 1/(E*_k M_k(s)), and lets go when its force is zero (T. C. T. Ting, J. Appl. Mech. 33, 845, 1966):
///
///   growing contact     F = (4/3) √R ∫₀ᵗ E*(t − t′) dδ^{3/2}
///   shrinking contact   F = (4/3) √R ∫₀^{t₁} E*(t − t′) dδ^{3/2},   ∫_{t₁}ᵗ E*(t − t′) dδ = 0
///
/// (docs/developer/derivations/loss.md). Elastic bodies are the limit of slow and fast relaxation.
namespace stoss::quasistatic {

/// One of two round bodies in a contact that relaxes.
struct RelaxingSide {
  double softness = 0.0;    ///< (1 − ν²)/E(0), 0 of a rigid one
  Relaxation relaxation{};  ///< times in R/c of the body in whose units all is
};

/// What a contact knows of bodies that relax, in units of one of them: R, ρ, E(0) and c = √(E(0)/ρ). A ball at a hard
/// wall is {1, {{{1 − ν², relaxation}}}, 4π/3}.
struct RelaxingContact {
  double curvature = 1.0;               ///< 1/R₁ + 1/R₂
  std::array<RelaxingSide, 2> sides{};  ///< of which one is not rigid
  double mass = 1.0;                    ///< reduced mass, ρR³
};

/// An impact of round bodies that relax, with the inputs that made it.
struct RelaxingImpact {
  RelaxingContact contact;
  double speed = 0.0;            ///< v, c
  double restitution = 0.0;      ///< ε
  double dissipated = 0.0;       ///< 1 − ε², with what the materials still hold when F = 0
  double contact_time = 0.0;     ///< from first contact to F = 0, R/c
  double max_compression = 0.0;  ///< R
  double max_force = 0.0;        ///< E(0)R²; while the contact grows
};

/// Impact of round bodies that relax by Ting's law: the limit of an impact with waves as it becomes slower.
///
/// ε is right to 1e-13, the rest to 1e-13 of itself, but for a time of contact where ε is below 0.01, to 1e-9. Measured
/// with 600 random materials of up to 8 terms, shares of up to 1 − 1e-6 and times over 18 decades, against errors of a
/// step that are 500 times as large. A value takes some 4 ms with one term, 40 ms with twenty.
/// @param speed of approach, 1e-100 to 1e100 c
/// @throws InvalidInput outside this range, for a curvature, mass or sum of softnesses outside 1e-100 … 1e100, for a
///         negative softness, and as validate(Relaxation); NotConverged where so much flows that the ball stays
[[nodiscard]] RelaxingImpact relaxing_impact(const RelaxingContact& contact, double speed);

}  // namespace stoss::quasistatic
