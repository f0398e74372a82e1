// Speeds at which yield and adhesion begin to matter.
#include "prediction/touching.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/quasistatic/adhesion.hpp"

namespace stoss {

Thresholds thresholds(const Encounter& encounter, const PredictionOptions& options) {
  const prediction::Touching its = prediction::touching(encounter, options.work_of_adhesion);
  Thresholds made;
  made.yield = its.yield_speed;
  if (its.yield_speed) made.impression = prediction::speed_of_impression(its);
  made.sticking = quasistatic::sticking_speed(its.pair, its.work_of_adhesion, its.mass);
  constexpr double matters = 10.0;  // (v_s/v)² is a hundredth
  made.adhesion = matters * made.sticking;
  return made;
}

}  // namespace stoss
