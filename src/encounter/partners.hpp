#pragma once

#include "stoss/encounter/encounter.hpp"

namespace stoss {

/// Checks who meets whom: kinds that go together, of which one deforms, and a material of both or of none.
/// @throws InvalidInput otherwise
void require_partners(const Encounter& encounter);

}  // namespace stoss
