#pragma once

#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/poll.hpp"
#include "stoss/quasistatic/slow_impact.hpp"

/// Rayleigh's estimate of the loss: every mode is driven, at the point of contact φ = 0, by the force of a slow impact,
///
///   Q̈ + ω²Q = −C F(t)  (mass m, F in mc²/R)   ⟹   energy left = ½m C² |∫F e^{iωt} dt|² = ½mv² · C² (∫F cos ωt dt / v)²
///
/// with t from the turning point, about which F is even (docs/theory/quasistatic.md; paper section V with E1–E8).
///
/// It is the first order of a perturbation theory. Its small number is the kinetic energy of modes that follow the
/// force, Q̇ = −C Ḟ/ω², which the quasi-static balance of energy leaves out. As v → 0 that number falls as 1/ln²(1/v)
/// and the amplitudes as 1/ln(1/v), so that the relative error of the estimate falls only as 1/ln(1/v).
///
/// While a sphere touches, the stiffness of its contact, dF/dδ, raises the frequency of a mode, and
///
///   energy left = ½mv² U² [∫F cos(ωt + φ) dt / v]²,   φ(t) = (U²/2ω) ∫₀ᵗ dF/dδ dt′
///
/// with φ odd about the turning point (docs/theory/points.md). The loss becomes v times a wave that never settles: the
/// beginning and the end of the pulse alone, F = (4/3)E*(vt)^{3/2}, drive the modes. Without φ the estimate is wrong by
/// up to a factor of two at v = 1e-3.
namespace stoss::quasistatic {

/// Error of √lost_fraction as a multiple of kinetic_share, of a disk. Measured: at most 6.6 in 251 impacts
/// against the hard wall, ν = 0 … 0.9, v = 1e-8 … 0.16.
inline constexpr double second_order_factor = 7.0;

/// The same of a sphere. Measured: at most 1.9 in 70 impacts against the hard wall, ν = −0.5 … 0.49, v = 1e-5 … 0.03.
inline constexpr double point_second_order_factor = 2.5;

/// Bound of kinetic_share for `beyond_perturbation`. In those 251 impacts the estimate is, below the bound, 0.24 to 3.0
/// times the full solution (0.67 to 0.96 times at the latter's maxima, ν ≥ 0.2); above the bound it is always too
/// great, by factors from 1.8 to 19. At ν = 0.33 the bound is reached at v = 0.024.
inline constexpr double max_kinetic_share = 0.04;

/// A mode that a slow impact has driven.
struct DrivenMode {
  int order = 0;           ///< n
  int index = 0;           ///< l
  double omega = 0.0;      ///< c/R
  double amplitude = 0.0;  ///< ∫F cos(ωt + φ) dt / v, t from the turning point, φ = 0 of a disk; 2 for ω → 0. Error
                           ///< below 1e-11, mostly 1e-14
  double after = 0.0;  ///< energy after the impact, as a share of ½mv²
};

/// Rayleigh's estimate, with the inputs that made it.
struct RayleighEstimate {
  SlowImpact impact;                 ///< law, poisson, speed, and the impact that drives the modes
  double cutoff = 0.0;               ///< highest frequency among the modes, c/R
  std::vector<DrivenMode> modes;     ///< as given
  double lost_fraction = 0.0;        ///< 1 − ε², their sum. May exceed 1 where it means nothing
  double lost_fraction_error = 0.0;  ///< against the full solution, from kinetic_share and its factor
  double mean_lost_fraction = 0.0;   ///< the law of v → 0 of a sphere averaged over phases, c(ν) v; 0 of a disk
  double kinetic_share = 0.0;        ///< maximum kinetic energy of the modes as they follow the force, share of ½mv²
  bool beyond_perturbation = false;  ///< kinetic_share > max_kinetic_share: the numbers mean nothing
};

/// Rayleigh's estimate of the loss of a slow impact to the given modes.
/// @param poisson, speed as for slow_impact
/// @param modes of the same body, in any order. Those beyond a cutoff of 60 would add 2e-4 to 5e-4 of lost_fraction
///              (v ≤ 0.01, ν = 0.33), which falls as 1/cutoff²; of a sphere 2e-4 to 1e-3
/// @throws InvalidInput as slow_impact, and for a frequency outside 0 … max_cutoff
[[nodiscard]] RayleighEstimate rayleigh(StaticLaw law, double poisson, double speed,
                                        const std::vector<bodies::Mode>& modes, const Poll& poll = {});

/// c(ν) of the loss of a slow sphere, 1 − ε² → v c(ν) in the mean over the phases of its modes as v → 0:
/// (2πE*²/m²) Σ U²/ω⁵ over the given modes; 0.158, 0.172, 0.199, 0.290 and 0.331 at ν = 0, 0.2, 0.3, 0.45 and 0.49.
[[nodiscard]] double mean_loss_factor(double poisson, const std::vector<bodies::Mode>& modes);

}  // namespace stoss::quasistatic
