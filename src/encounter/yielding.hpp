#pragma once

#include "stoss/encounter/encounter.hpp"

namespace stoss {

/// Makes the body that yields from its yield_strength on, as it is given; of 0 the body itself.
/// @throws InvalidInput for a yield_rate without a strength, or without a material in SI
[[nodiscard]] BodyMaker yielding_as_given(const BodyMaker& maker, const Encounter& encounter, const Participant& of);

}  // namespace stoss
