#pragma once

#include "stoss/body/body.hpp"

namespace stoss {

/// An elastic disk, R = c = ρ = 1, m = π, with all symmetric modes up to the cutoff (paper section II).
/// Contact nodes φ_i = (i + ½)h; shapes c_n = cos nφ cos φ, s_n = −sin nφ sin φ (paper eq. (39)).
/// @param poisson 2-D Poisson number, −0.95 … 0.995 (plane strain: Material)
/// @param cutoff  c/R, from the lowest mode to 1000
/// @throws InvalidInput as disk_modes
[[nodiscard]] Body disk(double poisson, double cutoff, const Poll& poll = {});

/// Makes disks of one Poisson number at any cutoff, for `restitution`, which chooses the cutoffs.
/// @throws InvalidInput for a Poisson number out of range
[[nodiscard]] BodyMaker disk(double poisson);

}  // namespace stoss
