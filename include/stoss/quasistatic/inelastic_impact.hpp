#pragma once

#include <limits>

#include "stoss/quasistatic/elastic_plastic.hpp"

/// Impact of round elastic bodies with yield, adhesion and waves in one motion.
///
/// A model: quasi-static Hertz contact whose force answers late. In units T = (m/k)^{2/5} v^{−1/5} of time, vT of
/// length and mv/T of force, k = (4/3)E*√R, the compression δ and the velocity u of the centre follow
///
///   du/dt = −F,   dδ/dt = u − αF,
///   F = P(δ) + P′τ dδ/dt + A(δ) as the contact grows,   F = P(δ + τ dδ/dt) + A(δ) as it shrinks,   τ = DP′,
///
/// P being the elastic–plastic force, δ^{3/2} without yield, and A what adhesion adds. D is the radiation of a
/// half-space (docs/theory/half_space.md), α that of a thin plate (Zener).
/// All losses are in one motion: what one takes another has no more.
namespace stoss::quasistatic {

/// What acts in the contact, in the units above.
struct InelasticContact {
  YieldLaw yield_law = YieldLaw::finite_elements;
  double yield_depth = std::numeric_limits<double>::infinity();  ///< δ at the onset of yield
  double radiation = 0.0;                                        ///< D
  double mobility = 0.0;                                         ///< α
  double adhesion = 0.0;                                         ///< δ₀ = Rκ^{4/3}, as adhesion.hpp has it
};

/// The impact. Shares are of the energy before it.
struct InelasticImpact {
  double restitution = 1.0;      ///< ε, 0 where the bodies stick
  double waves = 0.0;            ///< taken by D and α
  double yield = 0.0;            ///< taken by plastic work
  double adhesion = 0.0;         ///< taken by the jumps into and out of contact
  double contact_time = 0.0;     ///< T; infinite where the bodies stick
  double max_force = 0.0;        ///< mv/T
  double max_compression = 0.0;  ///< vT
  bool sticks = false;           ///< adhesion holds the bodies, with what they still have
};

/// Computes the motion, by Runge and Kutta's method of fifth order with a local error of 1e-11.
/// @throws InvalidInput for a number that is negative or NaN, and where adhesion alone is stronger than the impact by
///         1e6; NotConverged should the motion not end
[[nodiscard]] InelasticImpact inelastic_impact(const InelasticContact& contact);

}  // namespace stoss::quasistatic
