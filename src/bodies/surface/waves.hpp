#pragma once

#include <vector>

#include "stoss/bodies/round.hpp"

namespace stoss::bodies {

/// The waves of one wave number along a surface, as part of a quadrature: of all with weight dk, those with ω ≤ cutoff
/// one by one, the others by what they add to slow responses.
struct SurfaceWaves {
  double wave_number;             ///< k
  double weight;                  ///< dk
  std::vector<double> omega;      ///< of the kept ones
  std::vector<double> strength;   ///< ω² times the share of each in the compliance
  double residual_compliance;     ///< Σ strength/ω² over those that are not kept
  double residual_second_moment;  ///< Σ strength/ω⁴ over those that are not kept
};

/// The same with both directions of a plane through k: every wave moves the surface along its normal as cos ky and
/// along itself as sin ky, on rings as J₀(kr) and J₁(kr).
struct PlaneWaves {
  double wave_number;                  ///< k
  double weight;                       ///< dk
  std::vector<double> omega;           ///< of the kept ones
  std::vector<double> normal, along;   ///< amplitudes of both directions
  Flexibility residual_compliance;     ///< Σ (normal, along)(normal, along)ᵀ/ω² of those that are not kept
  Flexibility residual_second_moment;  ///< the same with ω⁴
};

}  // namespace stoss::bodies
