#pragma once

#include "stoss/quantity.hpp"
#include "stoss/quasistatic/half_space_radiation.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/quasistatic/slow_impact.hpp"

namespace stoss::quasistatic {

/// Quantities of a slow impact of a disk.
[[nodiscard]] const Quantities<SlowImpact>& slow_impact_quantities();

/// Quantities of Rayleigh's estimate for a disk, those of the impact that drives the modes included.
[[nodiscard]] const Quantities<RayleighEstimate>& rayleigh_quantities();

/// Quantities of one mode that a slow impact has driven.
[[nodiscard]] const Quantities<DrivenMode>& driven_mode_quantities();

/// Quantities of a slow impact of a sphere.
[[nodiscard]] const Quantities<SlowImpact>& point_slow_impact_quantities();

/// Quantities of Rayleigh's estimate for a sphere, those of the impact that drives the modes included.
[[nodiscard]] const Quantities<RayleighEstimate>& point_rayleigh_quantities();

/// Quantities of the loss of a slow ball to a half-space.
[[nodiscard]] const Quantities<HalfSpaceRadiation>& half_space_radiation_quantities();

}  // namespace stoss::quasistatic
