#pragma once

#include "stoss/quantity.hpp"
#include "stoss/restitution/oblique.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Quantities of a coefficient of restitution. What is of its finest impact is NaN where no impact was computed.
[[nodiscard]] const Quantities<Restitution>& restitution_quantities();

/// Quantities of one impact on the way to it.
[[nodiscard]] const Quantities<Run>& run_quantities();

/// Quantities of an oblique collision rule; of its finest impact as above.
[[nodiscard]] const Quantities<ObliqueRestitution>& oblique_quantities();

/// Quantities of one impact on the way to it.
[[nodiscard]] const Quantities<ObliqueRun>& oblique_run_quantities();

}  // namespace stoss
