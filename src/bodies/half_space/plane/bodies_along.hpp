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

}  // namespace stoss::bodies::half_space
