#pragma once

#include "stoss/quantity.hpp"
#include "stoss/vibration/bounce.hpp"
#include "stoss/vibration/distribution.hpp"

namespace stoss {

/// Quantities of one sample of an ensemble.
[[nodiscard]] const Quantities<Sample>& sample_quantities();

/// Quantities of the summary of an ensemble.
[[nodiscard]] const Quantities<DistributionSummary>& distribution_quantities();

/// Quantities of one impact of a sequence. Energies are shares of the initial energy of the first.
[[nodiscard]] const Quantities<Bounce>& bounce_quantities();

}  // namespace stoss
