#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "bodies/sphere/hole/hole.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::sphere {

/// Its surface: the rows P_n of the first degrees. A wave that runs out from a ring meets it, on average over its
/// direction, with ½ of its displacement along the meridian and ½ across, where only shear waves go.
[[nodiscard]] Surface surface_along(double poisson, std::size_t rows, const ContactPoints& points);

/// The modes that a sphere keeps, normalised as those of a solid one, and the hole in it.
struct Kept {
  std::shared_ptr<const std::vector<Mode>> modes;
  Hole hole{};
};

/// A sphere against forces along y that are uniform on rings (Body::along): one body of two families of modes, the
/// spheroidal ones of the sphere with one wave around the axis, of the same frequencies, U and V, and the toroidal ones
/// (docs/theory/oblique.md).
/// @param body  the sphere, along its axis
[[nodiscard]] Body along(const Body& body, double poisson, const Kept& kept, const Poll& poll);

/// A sphere against forces alike all around the axis (Body::outward): its modes move a ring along the axis and out from
/// it by the rows (m,+) = (P_m | P¹_m/m) and (m,−) = (P_m | −P¹_m/(m + 1)), with P¹_m = sin θ P_m′ (docs/theory/
/// oblique.md).
/// @param body  the sphere, along its axis
[[nodiscard]] Body outward(const Body& body, double poisson, const Kept& kept, const Poll& poll);

}  // namespace stoss::bodies::sphere
