#pragma once

#include <string>

#include "stoss/encounter/encounter.hpp"

namespace stoss {

/// Makes the body that yields from its yield_strength on, as it is given; of 0 the body itself.
/// @throws InvalidInput for a yield_rate without a strength, or without a material in SI
[[nodiscard]] BodyMaker yielding_as_given(const BodyMaker& maker, const Encounter& encounter, const Participant& of);

/// yield_warning where nobody has given the speed. @param whose it is, before it: "you asked for"
[[nodiscard]] std::string yield_warning(const Encounter& encounter, double speed, const std::string& whose);

}  // namespace stoss
