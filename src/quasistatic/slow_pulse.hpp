#pragma once

#include "quasistatic/pulse.hpp"
#include "stoss/quasistatic/compression.hpp"

namespace stoss::quasistatic {

/// The pulse of force of a slow impact.
/// @throws InvalidInput as slow_impact
[[nodiscard]] ForcePulse slow_pulse(CompressionLaw law, double poisson, double speed);

}  // namespace stoss::quasistatic
