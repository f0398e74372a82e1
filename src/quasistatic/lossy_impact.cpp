// In units R, c and m: the power η δ̇² dF/dδ = η Ḟδ̇ is, integrated by parts, η∫F² dt, which is ½v²(1 − ε²).
#include "stoss/quasistatic/lossy_impact.hpp"

#include "check.hpp"
#include "quasistatic/slow_pulse.hpp"

namespace stoss::quasistatic {

double viscous_loss(CompressionLaw law, double poisson, double loss_time, double speed) {
  require("loss_time", loss_time, {0.0, 1e3, true, true, "0 to 1000"}, "in units of R/c");
  return loss_time * slow_pulse(law, poisson, speed).squared_force();
}

}  // namespace stoss::quasistatic
