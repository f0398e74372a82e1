#pragma once

#include "relaxation/zeros.hpp"

namespace stoss::quasistatic {

/// An impact of round bodies that relax apart from scales: times in (m/k)^{2/5} v^{−1/5}, lengths in that times v,
/// forces in mv over it, with k that of E(0).
struct RelaxingMotion {
  double restitution = 1.0;
  double contact_time = 0.0;
  double max_compression = 0.0;
  double max_force = 0.0;
};

/// Ting's motion of E(t)/E(0) with rates in the unit above, to 1e-13. @param error of the speed, of a step
/// @throws NotConverged where the ball stays
[[nodiscard]] RelaxingMotion relaxing_motion(const Rates& rates, double error = 2e-15);

}  // namespace stoss::quasistatic
