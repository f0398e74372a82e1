#pragma once

#include <vector>

#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::bodies::sphere {

/// ω/κ and ω/κ′: the speeds of pressure and of shear waves, c.
struct WaveSpeeds {
  double pressure, shear;
};
[[nodiscard]] WaveSpeeds wave_speeds(double poisson);

/// Throws InvalidInput unless `poisson` is one of which the modes are tested, −0.95 … 0.4999.
void require_poisson(double poisson);

/// All modes with 0 < ω ≤ cutoff, sorted by degree and frequency; arguments already checked.
[[nodiscard]] std::vector<Mode> find_modes(double poisson, double cutoff, const Poll& poll);

/// The same, checked against the static sum rules. @throws NotConverged if the list fails its check
[[nodiscard]] std::vector<Mode> checked_modes(double poisson, double cutoff, const Poll& poll);

}  // namespace stoss::bodies::sphere
