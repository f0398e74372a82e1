#pragma once

#include <vector>

#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/quasistatic/point_slow_impact.hpp"
#include "stoss/quasistatic/rayleigh.hpp"

/// Rayleigh's estimate of the loss of a slow sphere: the force of a slow impact drives every mode at the point of
/// contact, and the stiffness of the contact, dF/dδ, raises the frequency of the mode while they touch,
///
///   energy left = ½mv² U² [∫F cos(ωt + φ) dt / v]²,   φ(t) = (U²/2ω) ∫₀ᵗ dF/dδ dt′
///
/// with F in mc²/R and t from the turning point, about which F is even and φ odd (docs/theory/points.md). The loss
/// becomes v times a wave that never settles: the beginning and the end of the pulse alone, F = (4/3)E*(vt)^{3/2},
/// drive the modes. Without φ the estimate is wrong by up to a factor of two at v = 1e-3.
namespace stoss::quasistatic {

/// Error of √lost_fraction as a multiple of kinetic_share, for a sphere. Measured: at most 1.9 in 70 impacts against
/// the hard wall, ν = −0.5 … 0.49, v = 1e-5 … 0.03.
inline constexpr double point_second_order_factor = 2.5;

/// Rayleigh's estimate for a sphere, with the inputs that made it.
struct PointRayleighEstimate {
  PointSlowImpact impact;            ///< law, poisson, speed, and the impact that drives the modes
  double cutoff = 0.0;               ///< highest frequency among the modes, c/R
  std::vector<DrivenMode> modes;     ///< as given; `amplitude` is ∫F cos(ωt + φ) dt / v
  double lost_fraction = 0.0;        ///< 1 − ε², their sum
  double lost_fraction_error = 0.0;  ///< against the full solution, from kinetic_share and point_second_order_factor
  double mean_lost_fraction = 0.0;   ///< the law of v → 0 averaged over the phases of the modes, c(ν) v
  double kinetic_share = 0.0;        ///< maximum kinetic energy of the modes as they follow the force, share of ½mv²
  bool beyond_perturbation = false;  ///< kinetic_share > max_kinetic_share: the numbers mean little
};

/// Rayleigh's estimate of the loss of a slow sphere to the given modes.
/// @param poisson, speed as for slow_impact
/// @param modes of the same sphere, in any order. Those beyond a cutoff of 60 would add 2e-4 to 1e-3 of lost_fraction
/// @throws InvalidInput as slow_impact, and for a frequency outside 0 … max_cutoff
[[nodiscard]] PointRayleighEstimate rayleigh(PointLaw law, double poisson, double speed,
                                             const std::vector<bodies::Mode>& modes, const Poll& poll = {});

/// c(ν) of the loss of a slow sphere, 1 − ε² → v c(ν) in the mean over the phases of its modes as v → 0:
/// (2πE*²/m²) Σ U²/ω⁵ over the given modes; 0.158, 0.172, 0.199, 0.290 and 0.331 at ν = 0, 0.2, 0.3, 0.45 and 0.49.
[[nodiscard]] double mean_loss_factor(double poisson, const std::vector<bodies::Mode>& modes);

}  // namespace stoss::quasistatic
