#include "stoss/contact/wall.hpp"

#include "check.hpp"

namespace stoss {

void validate(const Wall& wall) {
  const auto* soft = std::get_if<ExponentialWall>(&wall);
  if (soft == nullptr) return;
  require("hardness", soft->hardness, {1.0, 1e8, true, true, "1 to 1e8"},
          "alpha R of the exponential wall; 500 is usual");
  require("strength", soft->strength, {1e-100, 1e100, true, true, "1e-100 to 1e100"},
          "V0 in units of rho c^2 R^2; it only shifts the wall");
}

}  // namespace stoss
