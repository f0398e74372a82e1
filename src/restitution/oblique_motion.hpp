#pragma once

#include <vector>

#include "stoss/restitution/oblique.hpp"

namespace stoss {

/// As oblique_restitution, for a table: where ε_n is that of `restitution` it is that of the ladder of s′, and what is
/// left out (Coupling) is not estimated.
[[nodiscard]] std::vector<ObliqueRestitution> motion_along(const RefinableContact& contact, double speed,
                                                           const std::vector<Obliquity>& obliquities,
                                                           const ObliqueOptions& options);

}  // namespace stoss
