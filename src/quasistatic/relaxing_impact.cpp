#include "stoss/quasistatic/relaxing_impact.hpp"

#include <cmath>

#include "check.hpp"
#include "quasistatic/relaxing_motion.hpp"
#include "relaxation/creep.hpp"
#include "stoss/errors.hpp"

namespace stoss::quasistatic {
namespace {

constexpr Range allowed{1e-100, 1e100, true, true, "1e-100 to 1e100"};

/// M of a contact, whose creep is that of both bodies: 1/M = 1 + Σ f/(s + r).
///
/// In p = 1/s, f/(s + r) = (f/r) p/(p + 1/r), so that 1/M(s) is a relaxation in p, and its creep is M.
Rates of_contact(const RelaxingContact& contact, double softness, double unit) {
  Relaxation dual;
  double creeps = 1.0;
  for (const RelaxingSide& side : contact.sides) {
    if (side.softness == 0.0 || side.relaxation.terms.empty()) continue;
    for (const auto& [fluidity, rate] : creep(Rates(in_time(side.relaxation, 1.0 / unit))).terms) {
      const double compliance = side.softness / softness * fluidity / rate;
      dual.terms.push_back({compliance, rate});
      creeps += compliance;
    }
  }
  for (RelaxationTerm& term : dual.terms) term.share /= creeps;
  Rates of_compliance(dual);
  of_compliance.relaxed = 1.0 / creeps;
  Rates result;
  result.relaxed = 1.0 / creeps;
  for (const auto& [fluidity, rate] : creep(of_compliance).terms) {
    result.rate.push_back(1.0 / rate);
    result.share.push_back(fluidity / rate / creeps);
  }
  return result;
}

}  // namespace

RelaxingImpact relaxing_impact(const RelaxingContact& contact, double speed) {
  double softness = 0.0;
  for (const RelaxingSide& side : contact.sides) {
    require("softness", side.softness, {0.0, allowed.high, true, true, "0 to 1e100"}, "(1 - nu^2)/E(0) of a body");
    validate(side.relaxation);
    softness += side.softness;
  }
  require("curvature", contact.curvature, allowed, "1/R1 + 1/R2");
  require("softness", softness, allowed, "1/E*, the sum of both bodies");
  require("mass", contact.mass, allowed, "reduced mass in units of rho R^3");
  require("speed", speed, allowed, "in units of c");
  const double stiffness = 4.0 / (3.0 * softness * std::sqrt(contact.curvature));
  const double unit = std::pow(contact.mass / stiffness, 0.4) * std::pow(speed, -0.2);  // of time
  const RelaxingMotion motion = relaxing_motion(of_contact(contact, softness, unit));
  return {.contact = contact,
          .speed = speed,
          .restitution = motion.restitution,
          .dissipated = (1.0 - motion.restitution) * (1.0 + motion.restitution),
          .contact_time = unit * motion.contact_time,
          .max_compression = unit * speed * motion.max_compression,
          .max_force = contact.mass * speed / unit * motion.max_force};
}

}  // namespace stoss::quasistatic
