#pragma once

#include "stoss/encounter/encounter.hpp"

namespace stoss {

/// The coat of a body of an encounter, in R/E and R/c of the first body (of a rod in SI); without one, a compliance of
/// 0. @throws InvalidInput for a coat without a modulus, and a modulus or a quality without a coat
[[nodiscard]] Coat coat_of(const Encounter& encounter, const Participant& of);

/// Makes the coated body, in units of the first.
[[nodiscard]] BodyMaker coated_in_units_of_first(const BodyMaker& bare, const Coat& coat);

}  // namespace stoss
