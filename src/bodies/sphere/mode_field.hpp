#pragma once

#include <span>
#include <vector>

#include "bodies/sphere/static_field.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::bodies::sphere {

/// Displacement and stress of a free vibration inside the sphere: the formulas of EdgeProblem with κr for κ and, at
/// r = 0, their limits.
/// @param radii 0 … 1
/// @throws InvalidInput for a Poisson's ratio, a mode or a radius out of range
[[nodiscard]] std::vector<RadialField> mode_field(double poisson, const Mode& mode, std::span<const double> radii,
                                                  const Poll& poll);

}  // namespace stoss::bodies::sphere
