#pragma once

#include <vector>

#include "bodies/half_space/medium.hpp"
#include "bodies/surface/medium_surface.hpp"
#include "stoss/bodies/round.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::half_space {

/// All wave numbers of which waves with ω ≤ cutoff are kept, as surface_waves, of a half-plane under forces along both
/// directions (docs/theory/oblique.md). A load of one direction and
/// of wave number k moves the other by −Γ_X/(2μk)·(1 − ν) cos → sin,
///
///   Γ_X = (2 + ζ² − 2ab)/{(1 − ν)[(2 + ζ²)² − 4ab]},   Γ_X(0) = −η̂,
///
/// with the poles and cuts of Γ and Γ_h (Spectrum). Its residue and its density obey a_X² = a_R a_h and, below the
/// speed of pressure waves, ρ_X² = ρ ρ_h: a Rayleigh wave and each wave of the continuum there is one oscillator that
/// moves both directions. Above that speed ρ_X = 0, and the two directions have waves of their own.
[[nodiscard]] std::vector<PlaneWaves> plane_waves(const Medium& medium, double cutoff, double duration,
                                                  const Poll& poll);

/// Of all waves of one wave number, per dk: their compliance, and Σ 1/ω⁴.
[[nodiscard]] bodies::Flexibility plane_compliance(const Medium& medium, double wave_number);
[[nodiscard]] bodies::Flexibility plane_second_moment(const Medium& medium, double wave_number);

}  // namespace stoss::bodies::half_space
