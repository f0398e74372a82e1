#pragma once

#include "stoss/body/body.hpp"

namespace stoss {

/// A rigid mass with a flat face, for rods to meet, in any units common to both.
struct Anvil {
  double length = 1.0;
  double young = 1.0;  ///< only sets units: those in which a rod of the same numbers is given
  double density = 1.0;
  double area = 1.0;
};

/// Makes it, at any cutoff. @throws InvalidInput unless all numbers are above 0
[[nodiscard]] BodyMaker anvil(const Anvil& anvil);

}  // namespace stoss
