#pragma once

#include <string>

#include "stoss/impact/vibration.hpp"

namespace stoss {

/// "mode (2, 0) of the first body".
[[nodiscard]] std::string named(const Oscillation& mode);

/// @throws InvalidInput for a mode that bodies like these do not have at any cutoff
void require_possible(const Contact& contact, const Oscillation& mode);

}  // namespace stoss
