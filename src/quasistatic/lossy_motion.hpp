#pragma once

#include "stoss/quasistatic/point_lossy_impact.hpp"

namespace stoss::quasistatic {

/// An impact of lossy round bodies apart from scales: times in (m/k)^{2/5} v^{−1/5}, lengths in that times v.
struct LossyMotion {
  double restitution = 1.0;
  double contact_time = 0.0;
  double max_compression = 0.0;
};

/// The motion of a loss number x, 0 to 1e6, to 1e-13. @throws NotConverged should it not end
[[nodiscard]] LossyMotion lossy_motion(LossyLaw law, double loss_number);

}  // namespace stoss::quasistatic
