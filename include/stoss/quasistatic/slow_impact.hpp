#pragma once

#include <vector>

#include "stoss/quasistatic/compression.hpp"

/// Impact of a disk or a sphere that follows the wall's force statically: δ̈ = −F(δ), δ̇ = v at first contact, F in
/// mc²/R.
///
/// The laws of a disk are δ = F [1 + ln(F*/F)] with F* = limit_force. Energy, ½v² = ½F²a with a = ½ + ln(F*/F), makes
/// time an integral of a alone: with δ̇ = v cos(phase), dt = √a d(phase). Let A be a at the turning point, F_max = v/√A.
/// Then
///
///   A − ½ ln A = Λ,  Λ = ln(F*/v) + ½:   center    Λ = ln(1/v) − (3+ν)/4
///                                        diameter  Λ = ln(4/v) − 3/2
///   δ_max = v [√A + 1/(2√A)]                          = v√Λ [1 + (ln Λ + 2)/(4Λ) + O(ln²Λ/Λ²)]
///   τ     = π√A [1 + ln 2/(2A) + 0.0104/A² + O(A⁻³)]  = π√Λ [1 + (ln Λ + 2 ln 2)/(4Λ) + O(ln²Λ/Λ²)]
///
/// which completes paper eq. (60) (docs/theory/quasistatic.md). The law, and with it the impact, ends where
/// F_max = F*, at v = F*/√2.
///
/// Of a sphere, energy gives ½v² = U(a_m), and with δ̇ = v cos(phase) and U = ½v² sin²(phase) time is
/// dt = v sin(phase)/F d(phase). In Hertz' limit, for v → 0,
///
///   a_m⁵ = (5π/4)(1 − ν²) v²,   δ_max = a_m²,   τ = (4/5) B(2/5, 1/2) δ_max/v = 2.943275 δ_max/v.
namespace stoss::quasistatic {

/// Lowest speeds that slow_impact accepts, in c: of a disk, and of a sphere, below which the phase of its modes has no
/// meaning in double precision.
inline constexpr double min_slow_speed = 1e-100, min_point_speed = 1e-12;

/// Highest speed that slow_impact accepts, in c, at which the law ends: of a disk limit_force/√2, 0.16 to 0.26 for the
/// law of the centre.
[[nodiscard]] double limit_speed(StaticLaw law, double poisson);

/// A slow impact, with the inputs that made it. Relative errors below 1e-14, of a sphere 1e-13; of a disk near
/// limit_speed, where F_max depends on the speed as on √(limit_speed − v), that of max_force is up to 1e-8.
struct SlowImpact {
  StaticLaw law{};
  double poisson = 0.0;
  double speed = 0.0;            ///< v, c
  double contact_time = 0.0;     ///< τ, from first to last contact, R/c
  double max_compression = 0.0;  ///< δ_max, R
  double max_force = 0.0;        ///< F_max, mc²/R
  double max_radius = 0.0;       ///< a_m, maximum radius of the contact of a sphere, R; 0 of a disk
};

/// Impact of a disk or a sphere at a rigid wall, by one of the laws of compression.
/// @param speed of the centre of mass towards the wall, from min_slow_speed or min_point_speed to
///              limit_speed(law, poisson), c. Two equal bodies that each move at `speed` towards each other are the
///              same problem.
/// @throws InvalidInput for arguments out of range
[[nodiscard]] SlowImpact slow_impact(StaticLaw law, double poisson, double speed);

/// One instant of a slow impact.
struct ContactInstant {
  double time = 0.0;         ///< from first contact, R/c
  double velocity = 0.0;     ///< δ̇, towards the wall, c
  double compression = 0.0;  ///< δ, R
  double force = 0.0;        ///< F, mc²/R
};

/// History of a slow impact: the instants at which the velocity is v cos(phase). Phase 0 is the
/// first contact, π/2 the turning point, π the last contact. Phases that are evenly spaced are so
/// nearly in time too.
/// @param impact what slow_impact gave, or anything with its inputs: law, poisson, speed
/// @throws InvalidInput for a phase outside 0 … π, and as slow_impact
[[nodiscard]] std::vector<ContactInstant> contact_history(const SlowImpact& impact, const std::vector<double>& phases);

/// 1 − ε of a body of a lossy material at a hard wall, to first order of its loss time η: stress = (1 + η∂_t) elastic
/// stress (Kelvin and Voigt).
///
/// The strain rates are those of a contact of fixed width, so that the power lost is η δ̇² dF/dδ, and with δ̈ = −F/m
///
///   1 − ε = η∫F² dt/(m²v²);   of a disk, with the A and F* of slow_impact,
///         = (2η/√A) ∫₀¹ √(1 − f² (1 − ln f/A)) df = (πη/2√A) [1 − (2 ln 2 − 1)/4A + O(A⁻²)],   A − ½ ln A = ln(F*/v) +
///         ½
///
/// in units of R and c (docs/theory/quasistatic.md): as v → 0 the loss falls only like 1/√ln(1/v). The integral is good
/// to 1e-13. The loss of the elastic disk comes on top, and the damping of the modes that ring changes the sum: at
/// ν = 0.33 by about 2 % of this at v = 1e-8, by up to 18 % at 1e-4 and 1e-3. Of a sphere with Hertz' law it is
/// 1.153449 x (point_lossy_impact.hpp); that of the centre adds 1.3 % at v = 1e-4, 3.7 % at 1e-3, 11 % at 0.01 (ν =
/// 0.3).
/// @param loss_time η, 0 to 1000 R/c; the next order is about the square of the result
/// @param poisson, speed as for slow_impact
/// @throws InvalidInput outside these ranges
[[nodiscard]] double viscous_loss(StaticLaw law, double poisson, double loss_time, double speed);

}  // namespace stoss::quasistatic
