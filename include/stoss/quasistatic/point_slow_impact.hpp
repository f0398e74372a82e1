#pragma once

#include <vector>

#include "stoss/quasistatic/point_compression.hpp"
#include "stoss/quasistatic/slow_impact.hpp"

/// Impact of a sphere that follows the wall's force statically: δ̈ = −F(δ), δ̇ = v at first contact, F in mc²/R.
///
/// Energy gives ½v² = U(a_m), and with δ̇ = v cos(phase) and U = ½v² sin²(phase) time is dt = v sin(phase)/F d(phase).
/// In Hertz' limit, for v → 0,
///
///   a_m⁵ = (5π/4)(1 − ν²) v²,   δ_max = a_m²,   τ = (4/5) B(2/5, 1/2) δ_max/v = 2.943275 δ_max/v.
namespace stoss::quasistatic {

/// Lowest speed of a slow impact of a sphere, in c: below it the phase of the modes has no meaning in double precision.
inline constexpr double min_point_speed = 1e-12;

/// Highest speed that slow_impact accepts of a sphere, in c: that at which the law ends.
[[nodiscard]] double limit_speed(PointLaw law, double poisson);

/// A slow impact of a sphere, with the inputs that made it. Relative errors below 1e-13.
struct PointSlowImpact {
  PointLaw law{};
  double poisson = 0.0;
  double speed = 0.0;            ///< v, c
  double contact_time = 0.0;     ///< τ, from first to last contact, R/c
  double max_compression = 0.0;  ///< δ_max, R
  double max_force = 0.0;        ///< F_max, mc²/R
  double max_radius = 0.0;       ///< a_m, maximum radius of the contact, R
};

/// Impact of a sphere at a rigid wall, by one of the laws of compression.
/// @param speed of the centre of mass towards the wall, min_point_speed … limit_speed(law, poisson), c. Two equal
///              spheres that each move at `speed` towards each other are the same problem.
/// @throws InvalidInput for arguments out of range
[[nodiscard]] PointSlowImpact slow_impact(PointLaw law, double poisson, double speed);

/// History of a slow impact of a sphere: the instants at which the velocity is v cos(phase). Phase 0 is the first
/// contact, π/2 the turning point, π the last contact.
/// @param impact what slow_impact gave, or anything with its inputs: law, poisson, speed
/// @throws InvalidInput for a phase outside 0 … π, and as slow_impact
[[nodiscard]] std::vector<ContactInstant> contact_history(const PointSlowImpact& impact,
                                                          const std::vector<double>& phases);

}  // namespace stoss::quasistatic
