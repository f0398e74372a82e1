// Speeds at which yield and adhesion begin to matter.
#include "encounter/participant.hpp"
#include "prediction/touching.hpp"
#include "stoss/encounter/roughness.hpp"
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
  constexpr double compressions = 100.0;
  const double given = asperities_of(encounter) * size_of_first(encounter);
  const double asperities = given > 0.0 ? given : asperities_over_rms * bearing_ball_roughness;
  made.rough = its.speed_of_compression(compressions * asperities);
  return made;
}

}  // namespace stoss
