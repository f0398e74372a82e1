#pragma once

#include <vector>

#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::sphere {

/// A sphere against forces along y that are uniform on rings (Body::along): one body of two families of modes, the
/// spheroidal ones of the sphere with one wave around the axis, of the same frequencies, U and V, and the toroidal ones
/// (docs/theory/oblique.md).
/// @param body  the sphere, along its axis
/// @param modes its kept modes
[[nodiscard]] Body along(const Body& body, double poisson, const std::vector<Mode>& modes, const Poll& poll);

}  // namespace stoss::bodies::sphere
