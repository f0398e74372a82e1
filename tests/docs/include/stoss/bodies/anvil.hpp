#pragma once

#include "stoss/body/body.hpp"

namespace stoss {

/// A rigid mass with a flat face, for rods to meet, as heavy as `mass` of them.
/// @param mass   in the mass unit of the other body's scale, above 0 to 1000
/// @param cutoff that of the other body
/// @throws InvalidInput outside these ranges
[[nodiscard]] Body anvil(double mass, double cutoff);

}  // namespace stoss
