#pragma once

#include "stoss/quantity.hpp"
#include "stoss/restitution/oblique.hpp"
#include "stoss/restitution/pulse.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Quantities of a coefficient of restitution. What is of its finest impact is NaN where no impact was computed.
[[nodiscard]] const Quantities<Restitution>& restitution_quantities();

/// Quantities of one impact on the way to it.
[[nodiscard]] const Quantities<Run>& run_quantities();

/// Quantities of a pulse of force.
[[nodiscard]] const Quantities<Pulse>& pulse_quantities();

/// The force at an instant of a pulse.
struct PulseInstant {
  double time = 0.0;
  Estimate force;
};
[[nodiscard]] const Quantities<PulseInstant>& pulse_instant_quantities();

/// Quantities of an oblique collision rule; of its finest impact as above.
[[nodiscard]] const Quantities<ObliqueRestitution>& oblique_quantities();

/// Quantities of one impact on the way to it.
[[nodiscard]] const Quantities<ObliqueRun>& oblique_run_quantities();

}  // namespace stoss
