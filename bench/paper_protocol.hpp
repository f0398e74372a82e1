// The rival: the numerical protocol of F. Gerl and A. Zippelius, Phys. Rev. E 59, 2361 (1999), sections III and IV,
// as published. Every mode is integrated in the interaction picture (paper eqs. (42), (43)),
//
//   Q = Re(q e^{iωt}),   P = −mω Im(q e^{iωt}),
//   dq/dt = (i α V₀ / mω) e^{−iωt} ∫ dφ (C cos nφ cos φ − S sin nφ sin φ) e^{αx(φ)},
//   dv/dt = −(α V₀ / m) ∫ dφ e^{αx(φ)},
//   x(φ)  = x₀ + cos φ + Σ Q (C cos nφ cos φ − S sin nφ sin φ),          (eq. (39))
//
// φ from −π/2 to π/2, by the classical Runge–Kutta method of 4th order: 940 modes, those with the highest average
// energy in a preliminary run; 256 angles in the upper quadrant; look-up tables for cos nφ and sin nφ; αR = 500; at the
// start q = 0 and the disk out of the wall's reach. R = c = ρ = 1, m = π. Corrected is only what is evidently a slip of
// the pen: the sign of P and with it that of dq/dt (as printed, P = mω Im(q e^{iωt}), free modes have dQ/dt = −P/m, and
// the wall pulls where it should push), and the energy of a mode, ½mω²|q|² (eq. (40) has mω²Q²).
//
// What the paper leaves open is settled in favour of speed: modes of one order may share their sums over the angles,
// e^{iωt} is carried on by rotation instead of being computed anew, and the loops over modes and angles are vectorised
// as those of stoss are. The energy error is that at the end, not the larger one on the way.
#pragma once

#include <cstddef>
#include <vector>

#include "stoss/body/body.hpp"

namespace bench {

struct PaperSettings {
  double speed = 0.1;       ///< v, c
  double hardness = 500.0;  ///< α, 1/R
  double strength = 1.0;    ///< V₀, arbitrary: it only shifts the wall
  int angles = 256;         ///< in the upper quadrant, at the middle of equal intervals
  double step = 0.0;        ///< Δt, R/c
};

struct PaperResult {
  double lost_fraction = 0.0;  ///< 1 − ε²
  double energy_error = 0.0;   ///< |E/E₀ − 1| at the end
  long steps = 0;
};

/// One impact, from out of the wall's reach until the centre is back where it started and the edge out of reach again.
/// The sums over the angles are done once for each group.
[[nodiscard]] PaperResult paper_impact(const std::vector<stoss::ModeGroup>& modes, const PaperSettings& settings);

/// The same modes, each a group of its own: eqs. (39) and (43) taken literally, every mode at every angle.
[[nodiscard]] std::vector<stoss::ModeGroup> mode_by_mode(const std::vector<stoss::ModeGroup>& modes);

/// The `count` modes of a disk with the highest energy, averaged over the contact. The preliminary run is stoss's own
/// at its exponential wall of the same hardness, with all modes of the body.
/// @return the body with these modes only
[[nodiscard]] stoss::Body most_energetic(const stoss::Body& disk, std::size_t count, const PaperSettings& settings);

/// The largest step, to 5 %, up to which the energy error stays below the tolerance.
[[nodiscard]] double largest_step(const std::vector<stoss::ModeGroup>& modes, PaperSettings settings, double tolerance);

}  // namespace bench
