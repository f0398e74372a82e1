#pragma once

#include "stoss/body/body.hpp"

namespace stoss {

/// A rigid mass with a flat face, for rods to meet.
struct Anvil {
  double mass = 1.0;  ///< in the units of the rod
};

/// Makes it, at any cutoff. @throws InvalidInput unless its mass is above 0 and finite
[[nodiscard]] BodyMaker anvil(const Anvil& anvil);

}  // namespace stoss
