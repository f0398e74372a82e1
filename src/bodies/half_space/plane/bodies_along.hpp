#pragma once

#include <vector>

#include "bodies/half_space/medium.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::half_space {

/// A half-plane against forces along its surface (Body::along), as those of a disk: (x even | y odd), (y even | x odd).
/// @param plane    all but its waves and functions
/// @param duration of contacts for which they are made
[[nodiscard]] std::vector<Body> planes_along(const Body& plane, const Medium& medium, double duration,
                                             const Poll& poll);

/// A half-space against forces alike all around the axis (Body::outward): its pressure and shear waves are those of a
/// half-plane, with J₀(kr) for cos ky and J₁(kr) for sin ky.
[[nodiscard]] Body space_outward(const Body& space, const Medium& medium, double duration, const Poll& poll);

}  // namespace stoss::bodies::half_space
