#pragma once

#include "stoss/quantity.hpp"
#include "stoss/vibration/distribution.hpp"

namespace stoss {

/// Quantities of one sample of an ensemble.
[[nodiscard]] const Quantities<Sample>& sample_quantities();

/// Quantities of the summary of an ensemble.
[[nodiscard]] const Quantities<DistributionSummary>& distribution_quantities();

}  // namespace stoss
