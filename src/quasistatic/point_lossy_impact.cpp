#include "stoss/quasistatic/point_lossy_impact.hpp"

#include <cmath>

#include "check.hpp"
#include "quasistatic/lossy_motion.hpp"

namespace stoss::quasistatic {
namespace {

constexpr Range positive{1e-100, 1e100, true, true, "1e-100 to 1e100"};
constexpr Range not_negative{0.0, 1e100, true, true, "0 to 1e100"};

}  // namespace

LossyImpact lossy_impact(LossyLaw law, const LossyContact& contact, double speed) {
  require("curvature", contact.pair.curvature, positive, "1/R1 + 1/R2");
  require("softness", contact.pair.softness, positive, "1/E*");
  require("mass", contact.mass, positive, "reduced mass in units of rho R^3");
  require("loss_time", contact.loss_time, not_negative, "in units of R/c");
  require("speed", speed, positive, "in units of c");
  const double stiffness = 4.0 / (3.0 * contact.pair.softness * std::sqrt(contact.pair.curvature));
  const double unit = std::pow(contact.mass / stiffness, 0.4) * std::pow(speed, -0.2);  // of time
  const double x = 1.5 * contact.loss_time / unit;
  require("loss_number", x, {0.0, 1e6, true, true, "0 to 1e6"}, "1.5 loss_time (k/m)^(2/5) speed^(1/5)");
  const LossyMotion motion = lossy_motion(law, x);
  return {.law = law,
          .contact = contact,
          .speed = speed,
          .loss_number = x,
          .restitution = motion.restitution,
          .contact_time = unit * motion.contact_time,
          .max_compression = unit * speed * motion.max_compression};
}

}  // namespace stoss::quasistatic
