#pragma once

#include <vector>

#include "stoss/errors.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {

/// What s′ is known to at best is more than the tolerance: its points across the contact are too few in any run.
class OutOfReach : public NotConverged {
 public:
  explicit OutOfReach(double error)
      : NotConverged("the tolerance asks for more points across the contact than are computed"), least(error) {}

  double least;  ///< tolerance
};

/// As oblique_restitution, for a table: where ε_n is that of `restitution` it is that of the ladder of s′, and what is
/// left out (Coupling) is not estimated. @throws OutOfReach before the last run, where it can be seen that none helps
[[nodiscard]] std::vector<ObliqueRestitution> motion_along(const RefinableContact& contact, double speed,
                                                           const std::vector<Obliquity>& obliquities,
                                                           const ObliqueOptions& options);

}  // namespace stoss
