#pragma once

#include <vector>

#include "stoss/bodies/modal_body.hpp"

namespace stoss::bodies::modal {

/// ω_c a, c, up to which modes that bend, or move the contact as a piston, leave a compliance that is positive, and
/// lose what those of a sphere lose (docs/theory/any_body.md).
inline constexpr double reach = 1.1, reach_of_pistons = 0.6;

/// What a body might be instead.
struct Alternatives {
  std::vector<ModalBody> errors;  ///< with one kind of its numbers off by their errors, if they have any
  std::vector<ModalBody> bounds;  ///< by what none of its numbers tells
};

/// @param other curvature of what it meets, in units of its own_length
[[nodiscard]] Alternatives alternatives(const ModalBody& its, double other);

/// The same of what only moves it along its surface: empty without a tangent.
[[nodiscard]] Alternatives alternatives_along(const ModalBody& its);

/// By what a surface of unequal curvatures may answer forces along t otherwise than all around on average.
struct Unevenness {
  double softness = 0.0;  ///< share of the compliance, ν/(2 − ν) · |A − B|/(A + B) of relative curvatures A and B
  double curvature = 0.0;  ///< of the logarithm, H: half of the difference of both principal ones
};
[[nodiscard]] Unevenness unevenness(const ModalBody& its, double other);

}  // namespace stoss::bodies::modal
