#pragma once

#include <vector>

#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::sphere {

/// A sphere against forces alike all around the axis (Body::outward): its modes move a ring along the axis and out from
/// it by the rows (m,+) = (P_m | P¹_m/m) and (m,−) = (P_m | −P¹_m/(m + 1)), with P¹_m = sin θ P_m′ (docs/theory/
/// oblique.md).
/// @param body  the sphere, along its axis
/// @param modes its kept modes
[[nodiscard]] Body outward(const Body& body, double poisson, const std::vector<Mode>& modes);

}  // namespace stoss::bodies::sphere
